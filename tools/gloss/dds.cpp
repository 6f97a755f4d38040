// SPDX-License-Identifier: Apache-2.0
#include "gloss/dds.h"

#include <cstdint>
#include <string_view>
#include <utility>

#include "sky/base/little_endian.h"

namespace welkin::gloss {
namespace {

constexpr std::uint32_t kHasSizesAndFormat = 0x1007, kHasMips = 0x20000, kHasLinearSize = 0x80000;
constexpr std::uint32_t kFourLetters = 0x4, kTexture = 0x1000, kComplex = 0x8, kMips = 0x400000;
constexpr std::uint32_t kTexture2d = 3, kDxgiBc4 = 80, kDxgiBc5 = 83;  // both unsigned

}  // namespace

std::vector<std::byte> encodeBlockDds(BlockFormat format, int width, int height, const BlockTexture& texture) {
  const auto mips = static_cast<std::uint32_t>(texture.levels.size());
  const bool more = mips > 1, letters = format == BlockFormat::bc3;
  base::LittleEndian file;
  file.appendText("DDS ");
  file.append32({124, kHasSizesAndFormat | kHasLinearSize | (more ? kHasMips : 0U), static_cast<std::uint32_t>(height),
                 static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(texture.levels[0].size()), 0, mips});
  file.append32({0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
  file.append32({32, kFourLetters});
  file.appendText(letters ? "DXT5" : "DX10");
  file.append32({0, 0, 0, 0, 0});
  file.append32({kTexture | (more ? kComplex | kMips : 0U), 0, 0, 0, 0});
  if (!letters) file.append32({format == BlockFormat::bc4 ? kDxgiBc4 : kDxgiBc5, kTexture2d, 0, 1, 0});
  for (const std::vector<std::byte>& level : texture.levels)
    file.bytes.insert(file.bytes.end(), level.begin(), level.end());
  return std::move(file.bytes);
}

}  // namespace welkin::gloss
