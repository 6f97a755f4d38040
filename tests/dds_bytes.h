// SPDX-License-Identifier: Apache-2.0
// DDS files, written by hand: a header of 32 words, 5 more for a number of DXGI, and texels.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>
#include <vector>

namespace welkin::tests {

struct DdsHeader {
  std::uint32_t width = 0, height = 0;
  std::uint32_t flags = 0;          ///< 4: a code of four letters, 0x40: RGB, 0x20000: grey; + 1: alpha
  std::string four_letters;         ///< empty: none
  std::uint32_t bits = 0;           ///< of a pixel
  std::uint32_t mask[4] = {};       ///< red, green, blue, alpha
  std::uint32_t caps2 = 0;          ///< 0x200: a cube, 0x200000: a volume
  std::vector<std::uint32_t> dxgi;  ///< format, dimension, flags, array, alpha mode
};

inline std::string ddsOf(const DdsHeader& header, std::initializer_list<int> texels) {
  std::string bytes = "DDS ";
  const auto word = [&](std::uint32_t value) {
    for (unsigned shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<char>(value >> shift));
  };
  const auto zeros = [&](int count) {
    for (int i = 0; i < count; ++i) word(0);
  };
  for (const std::uint32_t value : {124U, 0x1007U, header.height, header.width}) word(value);
  zeros(14);
  word(32);
  word(header.flags);
  bytes += header.four_letters.empty() ? std::string(4, '\0') : header.four_letters;
  word(header.bits);
  for (const std::uint32_t mask : header.mask) word(mask);
  word(0x1000);
  word(header.caps2);
  zeros(3);
  for (const std::uint32_t value : header.dxgi) word(value);
  for (const int texel : texels) bytes.push_back(static_cast<char>(texel));
  return bytes;
}

/// 8 bits of blue, green, red and alpha.
inline DdsHeader ddsBgra(std::uint32_t width, std::uint32_t height) {
  return {width, height, 0x41, "", 32, {0xff0000, 0xff00, 0xff, 0xff000000}, 0, {}};
}

inline DdsHeader ddsBlocks(std::uint32_t width, std::uint32_t height, const std::string& four_letters) {
  return {width, height, 4, four_letters, 0, {}, 0, {}};
}

inline DdsHeader ddsDxgi(std::uint32_t width, std::uint32_t height, std::uint32_t format) {
  return {width, height, 4, "DX10", 0, {}, 0, {format, 3, 0, 1, 0}};
}

}  // namespace welkin::tests
