// SPDX-License-Identifier: Apache-2.0
#include "gloss/write_gloss.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "gloss/batch.h"
#include "sky/base/atomic_file.h"
#include "sky/base/hash.h"
#include "sky/image/exr_write.h"

namespace welkin::gloss {
namespace {

template <typename Code>
std::vector<std::byte> pngOf(const Mip& mip, bool normals) {
  constexpr double kLargest = std::numeric_limits<Code>::max();
  const auto codeOf = [&](double share) {
    return static_cast<Code>(std::lround(std::clamp(share, 0.0, 1.0) * kLargest));
  };
  std::vector<Code> codes;
  codes.reserve(mip.normal.size());
  for (std::size_t i = 0; i < mip.normal.size(); ++i)
    codes.push_back(normals ? codeOf((double{mip.normal[i]} + 1.0) / 2.0) : codeOf(double{mip.gloss[i / 3]}));
  return image::encodePng(mip.width, mip.height, codes);
}

std::vector<std::byte> encoded(const Mip& mip, bool normals, Format format) {
  if (format == Format::png) return pngOf<std::uint8_t>(mip, normals);
  if (format == Format::png16) return pngOf<std::uint16_t>(mip, normals);
  return image::encodeExr(mip.width, mip.height, normals ? 3 : 1, normals ? mip.normal : mip.gloss);
}

std::vector<NamedBytes> mipFiles(const std::string& name, const std::vector<Mip>& mips, Format format) {
  std::vector<NamedBytes> files;
  for (const bool of_normals : {true, false})
    for (std::size_t k = 0; k < mips.size(); ++k)
      files.push_back({fmt::format("{}_{}_mip{}.{}", name, of_normals ? "normal" : "gloss", k,
                                   format == Format::exr ? "exr" : "png"),
                       encoded(mips[k], of_normals, format)});
  return files;
}

std::vector<NamedBytes> filesOf(const Request& request, Result& result) {
  const std::string name = request.normal.stem().string();
  if (request.format != Format::bc3 && request.format != Format::bc5)
    return mipFiles(name, result.mips, request.format);
  BlockReport& report = result.blocks.emplace();
  if (request.format == Format::bc5) return bc5Files(name, result.mips, report);
  return bc3Files(name, result.mips, request.max_error_deg, report);
}

void checkGreen(const Request& request, Result& result) {
  if (!result.green.points_down() || request.flip_green) return;
  result.warnings.push_back({"green-down", 1,
                             fmt::format("green seems to point down, as DirectX has it (correlation {:.3f}, certainty "
                                         "{:.4f}); glTF, OpenGL and Welkin have it up. --flip-green turns it",
                                         result.green.correlation, result.green.certainty)});
}

}  // namespace

Result writeGloss(const Request& request, const std::filesystem::path& folder, const base::Progress& progress) {
  NormalMap normals = readNormalMap(request.normal, request.options);
  const GlossMap gloss = readGloss(request.gloss, request.roughness);
  Result result{request.normal.filename().string(),
                gloss.number ? request.gloss : std::filesystem::path(request.gloss).filename().string(),
                normals.coding,
                normals.mean_stored_length,
                greenDirectionOf(normals, request.wrap),
                {},
                {},
                {},
                std::move(normals.warnings),
                {}};
  result.warnings.insert(result.warnings.end(), gloss.warnings.begin(), gloss.warnings.end());
  checkGreen(request, result);
  if (request.flip_green)
    for (std::size_t i = 1; i < normals.xyz.size(); i += 3) normals.xyz[i] = -normals.xyz[i];
  result.mips = mipsOf(normals, gloss, progress);
  result.average = averageFactorOf(result.mips);
  const std::vector<NamedBytes> files = filesOf(request, result);
  const std::vector<std::filesystem::path> inputs = inputsOf(request);
  for (const NamedBytes& file : files) base::requireNoInput(folder / file.name, inputs);
  for (const NamedBytes& file : files) {
    base::writeFile(folder / file.name, file.bytes);
    result.files.push_back({file.name, file.bytes.size(), base::textOf(base::hashOf(file.bytes))});
    progress.check();
  }
  return result;
}

}  // namespace welkin::gloss
