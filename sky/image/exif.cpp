// SPDX-License-Identifier: Apache-2.0
#include "sky/image/exif.h"

#include <cstdint>

namespace welkin::image {

int exifOrientation(std::span<const std::byte> exif) {
  constexpr std::uint32_t kOrientation = 274, kShort = 3;
  if (exif.size() < 8) return 1;
  const bool little = exif[0] == std::byte{'I'};
  const auto number = [&](std::size_t at, std::size_t size) {
    std::uint32_t value = 0;
    if (at > exif.size() || size > exif.size() - at) return value;
    for (std::size_t i = 0; i < size; ++i)
      value = value << 8U | std::to_integer<std::uint32_t>(exif[at + (little ? size - 1 - i : i)]);
    return value;
  };
  const std::size_t directory = number(4, 4);
  const std::size_t count = number(directory, 2);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t entry = directory + 2 + 12 * i;
    if (number(entry, 2) != kOrientation || number(entry + 2, 2) != kShort) continue;
    const std::uint32_t value = number(entry + 8, 2);
    return value >= 1 && value <= 8 ? static_cast<int>(value) : 1;
  }
  return 1;
}

}  // namespace welkin::image
