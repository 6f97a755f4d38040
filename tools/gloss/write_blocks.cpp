// SPDX-License-Identifier: Apache-2.0
#include "gloss/write_blocks.h"

#include <utility>

#include "gloss/dds.h"

namespace welkin::gloss {

std::vector<NamedBytes> bc3Files(const std::string& name, const std::vector<Mip>& mips,
                                 std::optional<double> max_error_deg, BlockReport& report) {
  const BlockTexture map = packBc3(mips, std::nullopt);
  const BlockTexture average = packBc3(mips, averageFactorOf(mips).gloss);
  report.bc3 = true;
  report.with_map = map.error;
  report.with_average = average.error;
  report.holds_map = !max_error_deg || map.error.angle_rms <= *max_error_deg;
  const BlockTexture& chosen = report.holds_map ? map : average;
  return {{name + "_normal.dds", encodeBlockDds(BlockFormat::bc3, mips[0].width, mips[0].height, chosen)}};
}

std::vector<NamedBytes> bc5Files(const std::string& name, const std::vector<Mip>& mips, BlockReport& report) {
  const BlockTexture normals = packBc5(mips), gloss = packBc4(mips);
  report.apart = normals.error;
  report.apart.gloss_rms = gloss.error.gloss_rms;
  return {{name + "_normal.dds", encodeBlockDds(BlockFormat::bc5, mips[0].width, mips[0].height, normals)},
          {name + "_gloss.dds", encodeBlockDds(BlockFormat::bc4, mips[0].width, mips[0].height, gloss)}};
}

}  // namespace welkin::gloss
