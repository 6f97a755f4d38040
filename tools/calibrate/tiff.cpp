// SPDX-License-Identifier: Apache-2.0
#include "calibrate/tiff.h"

#include <array>

namespace welkin::calibrate {
namespace {

using std::uint32_t;

class TiffWriter {
 public:
  void add(std::uint32_t value, int bytes) {
    for (int i = 0; i < bytes; ++i) out_.push_back(static_cast<std::byte>(value >> (8 * i) & 0xFF));
  }

  /// A field whose value, or the place of its values, has 32 bits.
  void addField(std::uint32_t tag, std::uint32_t type, std::uint32_t count, std::uint32_t value) {
    add(tag, 2);
    add(type, 2);
    add(count, 4);
    add(value, 4);
  }

  std::vector<std::byte> take() { return std::move(out_); }
  void reserve(std::size_t bytes) { out_.reserve(bytes); }

 private:
  std::vector<std::byte> out_;
};

constexpr uint32_t kShort = 3, kLong = 4, kRational = 5;

/// x and y in parts of 10000: of white D65, then of red, green and blue.
constexpr std::array<uint32_t, 8> kRec709 = {3127, 3290, 6400, 3300, 3000, 6000, 1500, 600};

}  // namespace

std::vector<std::byte> encodeTiff(int width, int height, std::span<const std::uint16_t> rgb) {
  constexpr uint32_t kFields = 12, kHeader = 8;
  constexpr uint32_t kBits = kHeader + 2 + 12 * kFields + 4;  // three shorts, and two bytes so that numbers lie evenly
  constexpr uint32_t kColours = kBits + 8, kTexels = kColours + 8 * 8;
  const auto bytes = static_cast<uint32_t>(2 * rgb.size());
  TiffWriter out;
  out.reserve(kTexels + bytes);
  out.add(0x4949, 2);
  out.add(42, 2);
  out.add(kHeader, 4);
  out.add(kFields, 2);
  out.addField(256, kLong, 1, static_cast<uint32_t>(width));
  out.addField(257, kLong, 1, static_cast<uint32_t>(height));
  out.addField(258, kShort, 3, kBits);  // BitsPerSample
  out.addField(259, kShort, 1, 1);      // Compression: none
  out.addField(262, kShort, 1, 2);      // PhotometricInterpretation: RGB
  out.addField(273, kLong, 1, kTexels);
  out.addField(274, kShort, 1, 1);  // Orientation: rows from the top
  out.addField(277, kShort, 1, 3);  // SamplesPerPixel
  out.addField(278, kLong, 1, static_cast<uint32_t>(height));
  out.addField(279, kLong, 1, bytes);
  out.addField(318, kRational, 2, kColours);          // WhitePoint
  out.addField(319, kRational, 6, kColours + 2 * 8);  // PrimaryChromaticities
  out.add(0, 4);
  for (int i = 0; i < 3; ++i) out.add(16, 2);
  out.add(0, 2);
  for (const uint32_t part : kRec709) {
    out.add(part, 4);
    out.add(10000, 4);
  }
  for (const std::uint16_t code : rgb) out.add(code, 2);
  return out.take();
}

}  // namespace welkin::calibrate
