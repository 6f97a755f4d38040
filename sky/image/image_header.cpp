// SPDX-License-Identifier: Apache-2.0
#include "sky/image/image_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <utility>

#include "sky/base/error.h"

namespace welkin::image {
namespace {

using Refusal = std::optional<std::string>;

/// Reads bytes from front to back. Past the end it reads zeros and `good` is false.
struct Reader {
  std::span<const std::byte> bytes;
  std::int64_t place = 0;
  bool good = true;

  std::int64_t end() const { return static_cast<std::int64_t>(bytes.size()); }
  char next() {
    good = good && place < end();
    return good ? static_cast<char>(bytes[static_cast<std::size_t>(place++)]) : '\0';
  }
  std::uint32_t number(std::endian order) {
    std::array<char, 4> raw{};
    for (char& c : raw) c = next();
    if (order == std::endian::big) std::reverse(raw.begin(), raw.end());
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < raw.size(); ++i) value |= std::uint32_t{static_cast<unsigned char>(raw[i])} << (8 * i);
    return value;
  }
  /// A little-endian number of 1 to 4 bytes at a place.
  std::int64_t at(std::int64_t from, int size) {
    place = from;
    std::int64_t value = 0;
    for (int i = 0; i < size; ++i) value |= std::int64_t{static_cast<unsigned char>(next())} << (8 * i);
    return value;
  }
  std::int64_t exrInt() { return static_cast<std::int32_t>(number(std::endian::little)); }

  /// Reads a terminated name. OpenEXR allows at most 255 bytes.
  std::string exrName() {
    std::string name;
    while (name.size() < 256) {
      const char c = next();
      if (c == '\0') break;
      name.push_back(c);
    }
    return name;
  }
};

/// Bytes of the types of OpenEXR whose values all have one size. OpenEXR reads as many, whatever size the file states.
constexpr std::pair<std::string_view, std::int64_t> kExrSizes[] = {
    {"box2f", 16},
    {"box2i", 16},
    {"chromaticities", 32},
    {"compression", 1},
    {"deepImageState", 1},
    {"double", 8},
    {"envmap", 1},
    {"float", 4},
    {"int", 4},
    {"keycode", 28},
    {"lineOrder", 1},
    {"m33d", 72},
    {"m33f", 36},
    {"m44d", 128},
    {"m44f", 64},
    {"rational", 8},
    {"tiledesc", 9},
    {"timecode", 8},
    {"v2d", 16},
    {"v2f", 8},
    {"v2i", 8},
    {"v3d", 24},
    {"v3f", 12},
    {"v3i", 12},
};

/// Bytes that OpenEXR reads for a value of this type, which may differ from the stated `size`. The reader stands at the
/// value's start and moves.
std::int64_t exrBytesRead(Reader& file, const std::string& type, std::int64_t size) {
  const std::int64_t at = file.place;
  for (const auto& [fixed, bytes] : kExrSizes)
    if (type == fixed) return bytes;
  if (type == "chlist") {
    constexpr std::int64_t kChannel = 16;  // type, flags, two samplings
    while (file.good && !file.exrName().empty()) file.place += kChannel;
    return file.place - at;
  }
  if (type == "preview") {
    const std::int64_t width = file.number(std::endian::little);
    const std::int64_t height = file.number(std::endian::little);
    constexpr std::int64_t kSizes = 8, kTexel = 4;
    const bool small = width <= file.end() && height <= file.end();
    return small ? kSizes + kTexel * width * height : std::numeric_limits<std::int64_t>::max();
  }
  return size;
}

/// Checks the value of one attribute. The reader stands at its start.
Refusal whyValueImpossible(Reader& file, const std::string& name, const std::string& type, std::int64_t largest_side) {
  if (type == "box2i" && name == "dataWindow") {
    std::int64_t v[4];
    for (auto& number : v) number = file.exrInt();
    const std::int64_t width = v[2] - v[0] + 1;
    const std::int64_t height = v[3] - v[1] + 1;
    if (std::max(width, height) > largest_side)
      return fmt::format("{} x {} texels; 1 to {} a side are allowed", width, height, largest_side);
  } else if (type == "tiledesc") {
    const std::int64_t width = file.number(std::endian::little);
    const std::int64_t height = file.number(std::endian::little);
    if (std::max(width, height) > largest_side)
      return fmt::format("tiles of {} x {} texels; 1 to {} a side are allowed", width, height, largest_side);
  }
  return std::nullopt;
}

Refusal whyExrImpossible(Reader& file, int largest_side) {
  constexpr std::int64_t kMagic = 4;
  constexpr std::uint32_t kMultipart = 0x1000;  // Flag of the version: headers follow until an empty one.
  file.place = kMagic;
  const bool multipart = (file.number(std::endian::little) & kMultipart) != 0;
  for (bool header_ended = false; file.good;) {
    const std::string name = file.exrName();
    if (name.empty()) {  // Ends a header. At the start of a header it ends the list.
      if (!multipart || header_ended) break;
      header_ended = true;
      continue;
    }
    header_ended = false;
    const std::string type = file.exrName();
    const std::int64_t size = file.exrInt();
    const std::int64_t at = file.place;
    if (!file.good) break;
    if (size < 0 || size > file.end() - at)
      return fmt::format("the attribute {} has {} bytes; the file ends {} bytes on", name, size, file.end() - at);
    if (const std::int64_t read = exrBytesRead(file, type, size); read != size)
      return fmt::format("the attribute {} of type {} states {} bytes and has {}", name, type, size, read);
    file.place = at;
    if (const auto why = whyValueImpossible(file, name, type, largest_side)) return why;
    file.place = at + size;
  }
  return std::nullopt;
}

Refusal whyPngImpossible(Reader& file) {
  constexpr std::int64_t kSignature = 8;
  constexpr std::uint32_t kEnd = 0x49454e44;  // "IEND"
  constexpr std::int64_t kChecksum = 4;
  file.place = kSignature;
  while (file.good) {
    const std::int64_t length = file.number(std::endian::big);
    const bool last = file.number(std::endian::big) == kEnd;
    const std::int64_t at = file.place;
    if (!file.good || last) break;
    if (length > file.end() - at)
      return fmt::format("a chunk has {} bytes; the file ends {} bytes on", length, file.end() - at);
    file.place = at + length + kChecksum;
  }
  return std::nullopt;
}

/// Why texels of rows from `from` on are not all within the file.
Refusal whyTexelsMissing(const Reader& file, std::int64_t header, std::int64_t from, std::int64_t row_bytes,
                         std::int64_t rows) {
  if (!file.good || from < header || from > file.end()) return fmt::format("its texels start at byte {}", from);
  if (row_bytes * rows > file.end() - from)
    return fmt::format("its texels take {} bytes; the file ends {} bytes on", row_bytes * rows, file.end() - from);
  return std::nullopt;
}

Refusal whyBmpImpossible(Reader& file) {
  constexpr std::int64_t kFileHeader = 14, kOldHeader = 12;
  const std::int64_t from = file.at(10, 4), header = file.at(14, 4);
  const bool old = header == kOldHeader;
  const std::int64_t width = old ? file.at(18, 2) : file.at(18, 4);
  const std::int64_t height = old ? file.at(20, 2) : std::abs(std::int64_t{static_cast<std::int32_t>(file.at(22, 4))});
  const std::int64_t bits = old ? file.at(24, 2) : file.at(28, 2);
  const std::int64_t packing = old ? 0 : file.at(30, 4);
  constexpr std::int64_t kRunLengths = 2;  // 1 and 2 pack rows of 8 and 4 bits
  const bool packed = packing == 1 || packing == kRunLengths;
  const std::int64_t row_bytes = packed ? 0 : (width * bits + 31) / 32 * 4;
  return whyTexelsMissing(file, kFileHeader + header, from, row_bytes, height);
}

Refusal whyTargaImpossible(Reader& file) {
  constexpr std::int64_t kHeader = 18, kPacked = 8;  // types from 9 on are run-length packed
  const std::int64_t map_bytes = (file.at(1, 1) & 1) != 0 ? file.at(5, 2) * ((file.at(7, 1) + 7) / 8) : 0;
  const std::int64_t from = kHeader + file.at(0, 1) + map_bytes;
  const bool packed = file.at(2, 1) > kPacked;
  const std::int64_t texel_bytes = packed ? 0 : (file.at(16, 1) + 7) / 8;
  const std::int64_t width = file.at(12, 2), height = file.at(14, 2);
  return whyTexelsMissing(file, kHeader, from, width * texel_bytes, height);
}

}  // namespace

Refusal whyHeaderUnusable(std::span<const std::byte> bytes, std::string_view format, int largest_side) {
  Reader file{bytes};
  if (format == "openexr") return whyExrImpossible(file, largest_side);
  if (format == "png") return whyPngImpossible(file);
  if (format == "bmp") return whyBmpImpossible(file);
  if (format == "targa") return whyTargaImpossible(file);
  return std::nullopt;
}

void requireSize(const std::string& file, std::int64_t width, std::int64_t height, const ImageLimits& limits) {
  if (width < 1 || height < 1 || width > limits.largest_side || height > limits.largest_side)
    throw base::Error(base::ExitStatus::content, fmt::format("{}: {} x {} texels; 1 to {} a side are allowed", file,
                                                             width, height, limits.largest_side));
  if (static_cast<std::size_t>(width * height) > limits.most_texels)
    throw base::Error(base::ExitStatus::content, fmt::format("{}: {} x {} texels; at most {} in all are allowed", file,
                                                             width, height, limits.most_texels));
}

}  // namespace welkin::image
