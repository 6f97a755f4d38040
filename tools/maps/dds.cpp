// SPDX-License-Identifier: Apache-2.0
#include "maps/dds.h"

#include <utility>

#include "sky/base/little_endian.h"

namespace welkin::maps {
namespace {

constexpr std::uint32_t kHasSizesAndFormat = 0x1007, kHasPitch = 0x8, kHasMips = 0x20000, kHasLinearSize = 0x80000;
constexpr std::uint32_t kFourLetters = 0x4;
constexpr std::uint32_t kTexture = 0x1000, kComplex = 0x8, kMips = 0x400000;
constexpr std::uint32_t kCubeOfSixFaces = 0xFE00;
constexpr std::uint32_t kTexture2d = 3, kTextureCube = 4;

}  // namespace

std::vector<std::byte> encodeDds(const EncodedCube& cube) {
  const FormatFacts& facts = factsOf(cube.format);
  const auto size = static_cast<std::uint32_t>(cube.size);
  const auto mips = static_cast<std::uint32_t>(cube.levels.size());
  const bool blocks = facts.block_texels > 1;
  const std::uint32_t pitch = blocks ? static_cast<std::uint32_t>(cube.levels[0].size() / 6) : facts.block_bytes * size;
  base::LittleEndian file;
  file.appendText("DDS ");
  file.append32({124, kHasSizesAndFormat | (blocks ? kHasLinearSize : kHasPitch) | (mips > 1 ? kHasMips : 0U), size,
                 size, pitch, 0, mips});
  file.append32({0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
  file.append32({32, kFourLetters});
  file.appendText("DX10");
  file.append32({0, 0, 0, 0, 0});
  file.append32({kTexture | kComplex | (mips > 1 ? kMips : 0U), kCubeOfSixFaces, 0, 0, 0});
  file.append32({facts.dxgi, kTexture2d, kTextureCube, 1, 0});
  for (std::size_t face = 0; face < 6; ++face)
    for (const std::vector<std::byte>& level : cube.levels) {
      const auto bytes = static_cast<std::ptrdiff_t>(level.size() / 6);
      const auto first = level.begin() + static_cast<std::ptrdiff_t>(face) * bytes;
      file.bytes.insert(file.bytes.end(), first, first + bytes);
    }
  return std::move(file.bytes);
}

}  // namespace welkin::maps
