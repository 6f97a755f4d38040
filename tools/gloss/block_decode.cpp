// SPDX-License-Identifier: Apache-2.0
// Decodes blocks as the Direct3D 11 functional specification defines them, without the rounding that GPUs may add.
#include <array>

#include "gloss/block_texture.h"

namespace welkin::gloss {
namespace {

std::uint64_t littleEndian(const std::byte* bytes, int count) {
  std::uint64_t value = 0;
  for (int i = count - 1; i >= 0; --i) value = value << 8U | std::to_integer<std::uint64_t>(bytes[i]);
  return value;
}

/// Red and green of a 5:6:5 colour.
RedGreen redGreenOf(std::uint64_t colour) {
  return {static_cast<double>(colour >> 11U & 31U) / 31.0, static_cast<double>(colour >> 5U & 63U) / 63.0};
}

}  // namespace

std::vector<double> decodeBc4(const std::byte* block) {
  const double first = std::to_integer<int>(block[0]) / 255.0, second = std::to_integer<int>(block[1]) / 255.0;
  std::array<double, 8> palette{first, second};
  const int between = first > second ? 6 : 4;
  for (int i = 1; i <= between; ++i)
    palette[static_cast<std::size_t>(i) + 1] = ((between + 1 - i) * first + i * second) / (between + 1);
  if (between == 4) palette[7] = 1.0;  // and the sixth is 0
  const std::uint64_t indices = littleEndian(block + 2, 6);
  std::vector<double> texels;
  for (unsigned i = 0; i < 16; ++i) texels.push_back(palette[indices >> 3 * i & 7U]);
  return texels;
}

std::vector<RedGreen> decodeBc3Colours(const std::byte* block) {
  const RedGreen first = redGreenOf(littleEndian(block, 2)), second = redGreenOf(littleEndian(block + 2, 2));
  const auto mix = [&](double a, double b) {
    return RedGreen{(a * first.red + b * second.red) / 3.0, (a * first.green + b * second.green) / 3.0};
  };
  const std::array<RedGreen, 4> palette{first, second, mix(2.0, 1.0), mix(1.0, 2.0)};
  const std::uint64_t indices = littleEndian(block + 4, 4);
  std::vector<RedGreen> texels;
  for (unsigned i = 0; i < 16; ++i) texels.push_back(palette[indices >> 2 * i & 3U]);
  return texels;
}

}  // namespace welkin::gloss
