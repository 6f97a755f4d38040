// SPDX-License-Identifier: Apache-2.0
#include "sky/image/exif.h"

#include <cstdint>
#include <optional>

namespace welkin::image {
namespace {

constexpr std::uint32_t kOrientation = 274, kExifDirectory = 34665, kColorSpace = 40961, kInteroperability = 40965;
constexpr std::uint32_t kInteroperabilityIndex = 1;
constexpr std::uint32_t kAscii = 2, kShort = 3, kLong = 4;

class ExifReader {
 public:
  explicit ExifReader(std::span<const std::byte> bytes)
      : bytes_(bytes), little_(!bytes.empty() && bytes[0] == std::byte{'I'}) {}

  /// A number of `size` bytes; 0 past the end.
  std::uint32_t number(std::size_t at, std::size_t size) const {
    std::uint32_t value = 0;
    if (at > bytes_.size() || size > bytes_.size() - at) return value;
    for (std::size_t i = 0; i < size; ++i)
      value = value << 8U | std::to_integer<std::uint32_t>(bytes_[at + (little_ ? size - 1 - i : i)]);
    return value;
  }
  /// The place of the value of a tag in a directory, if it has that type.
  std::optional<std::size_t> find(std::size_t directory, std::uint32_t tag, std::uint32_t type) const {
    const std::size_t count = number(directory, 2);
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t entry = directory + 2 + 12 * i;
      if (number(entry, 2) == tag && number(entry + 2, 2) == type) return entry + 8;
    }
    return std::nullopt;
  }
  /// The place of the directory that a tag of another points to.
  std::optional<std::size_t> directory(std::size_t of, std::uint32_t tag) const {
    const auto pointer = find(of, tag, kLong);
    if (!pointer) return std::nullopt;
    return number(*pointer, 4);
  }
  bool isR03(std::size_t at) const {
    return at + 3 <= bytes_.size() && bytes_[at] == std::byte{'R'} && bytes_[at + 1] == std::byte{'0'} &&
           bytes_[at + 2] == std::byte{'3'};
  }

 private:
  std::span<const std::byte> bytes_;
  bool little_;
};

ExifColours coloursOf(const ExifReader& reader, std::size_t exif) {
  constexpr std::uint32_t kAdobe = 2, kUncalibrated = 65535;  // 2 is not of the standard, but cameras write it
  const auto space = reader.find(exif, kColorSpace, kShort);
  const std::uint32_t value = space ? reader.number(*space, 2) : 0;
  if (value == kAdobe) return ExifColours::adobe_rgb;
  if (value != kUncalibrated) return ExifColours::unsaid;
  const auto interoperability = reader.directory(exif, kInteroperability);
  const auto index = interoperability ? reader.find(*interoperability, kInteroperabilityIndex, kAscii) : std::nullopt;
  return index && reader.isR03(*index) ? ExifColours::adobe_rgb : ExifColours::uncalibrated;
}

}  // namespace

ExifFields readExif(std::span<const std::byte> exif) {
  ExifFields fields;
  const ExifReader reader(exif);
  constexpr std::uint32_t kTiff = 42;  // a BigTIFF has another number and other entries
  if (exif.size() < 8 || reader.number(2, 2) != kTiff) return fields;
  const std::size_t first = reader.number(4, 4);
  if (const auto at = reader.find(first, kOrientation, kShort)) {
    const std::uint32_t value = reader.number(*at, 2);
    if (value >= 1 && value <= 8) fields.orientation = static_cast<int>(value);
  }
  if (const auto directory = reader.directory(first, kExifDirectory)) fields.colours = coloursOf(reader, *directory);
  return fields;
}

}  // namespace welkin::image
