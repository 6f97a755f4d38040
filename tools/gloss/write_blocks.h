// SPDX-License-Identifier: Apache-2.0
// The mips as DDS files of blocks, and the choice between a gloss map and one number.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "gloss/block_texture.h"
#include "gloss/mips.h"

namespace welkin::gloss {

/// What the blocks cost, and what stands in red.
struct BlockReport {
  bool bc3 = false;
  BlockError with_map;      ///< BC3 with the gloss map in red
  BlockError with_average;  ///< BC3 with the average Toksvig factor in red
  BlockError apart;         ///< BC5 for normals and BC4 for gloss
  bool holds_map = true;    ///< whether the files hold the gloss map
};

struct NamedBytes {
  std::string name;
  std::vector<std::byte> bytes;
};

/// BC3: NAME_normal.dds with the gloss in red. It is the map, unless that takes the normals' angle_rms past
/// `max_error_deg`, then the average factor.
std::vector<NamedBytes> bc3Files(const std::string& name, const std::vector<Mip>& mips,
                                 std::optional<double> max_error_deg, BlockReport& report);

/// NAME_normal.dds as BC5 and NAME_gloss.dds as BC4.
std::vector<NamedBytes> bc5Files(const std::string& name, const std::vector<Mip>& mips, BlockReport& report);

}  // namespace welkin::gloss
