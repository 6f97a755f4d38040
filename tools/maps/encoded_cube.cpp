// SPDX-License-Identifier: Apache-2.0
#include "maps/encoded_cube.h"

#include <algorithm>
#include <utility>

#include "format/cubemap_format.h"
#include "maps/bc6h.h"

namespace welkin::maps {
namespace {

constexpr FormatFacts kFacts[] = {
    {"rgba16f", 97, 10, 2, 1, 8}, {"rgb9e5", 123, 67, 4, 1, 4}, {"bc6h", 143, 95, 1, 4, 16}};

unsigned char* bytesAt(std::vector<std::byte>& bytes, std::size_t offset) {
  return reinterpret_cast<unsigned char*>(bytes.data()) + offset;
}

/// Appends all texels of a stacked cube one by one. Returns how many components were past the largest number.
std::size_t appendTexels(const Map& cube, format::CubemapFormat format, std::vector<std::byte>& bytes) {
  const std::size_t texel_bytes = format::texelBytes(format);
  const std::size_t texels = cube.rgb.size() / 3;
  const std::size_t start = bytes.size();
  bytes.resize(start + texels * texel_bytes);
  std::size_t saturated = 0;
  for (std::size_t i = 0; i < texels; ++i) {
    const float rgb[3] = {cube.rgb[3 * i], cube.rgb[3 * i + 1], cube.rgb[3 * i + 2]};
    saturated += format::encodeTexel(format, rgb, bytesAt(bytes, start + i * texel_bytes));
  }
  return saturated;
}

/// Appends the blocks of a face. Blocks past the edge of a small mip repeat its last row and column.
std::size_t appendBlocks(const Map& face, std::vector<std::byte>& bytes) {
  std::size_t saturated = 0;
  for (int y = 0; y < face.height; y += kBc6hSide)
    for (int x = 0; x < face.width; x += kBc6hSide) {
      Bc6hTexels texels;
      for (int i = 0; i < kBc6hSide * kBc6hSide; ++i) {
        const int column = std::min(x + i % kBc6hSide, face.width - 1);
        const int row = std::min(y + i / kBc6hSide, face.height - 1);
        const std::size_t at = 3 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(face.width) +
                                    static_cast<std::size_t>(column));
        std::copy_n(face.rgb.begin() + static_cast<std::ptrdiff_t>(at), 3, texels[static_cast<std::size_t>(i)].begin());
      }
      const std::size_t start = bytes.size();
      bytes.resize(start + kBc6hBytes);
      saturated += encodeBc6h(texels, bytesAt(bytes, start));
    }
  return saturated;
}

}  // namespace

const FormatFacts& factsOf(Format format) {
  return kFacts[static_cast<std::size_t>(format)];
}

std::optional<Format> formatOf(std::string_view name) {
  for (const Format format : {Format::rgba16f, Format::rgb9e5, Format::bc6h})
    if (name == factsOf(format).name) return format;
  return std::nullopt;
}

EncodedCube encodeLevels(const std::vector<Map>& levels, Format format) {
  EncodedCube encoded{format, levels.front().width, {}, 0};
  for (const Map& level : levels) {
    std::vector<std::byte>& bytes = encoded.levels.emplace_back();
    if (format == Format::bc6h)
      for (int face = 0; face < 6; ++face) encoded.saturated += appendBlocks(faceOf(level, face), bytes);
    else
      encoded.saturated += appendTexels(
          level, format == Format::rgba16f ? format::CubemapFormat::rgba16f : format::CubemapFormat::rgb9e5, bytes);
  }
  return encoded;
}

EncodedCube encodeCube(const Map& cube, Format format, bool mips) {
  std::vector<Map> levels = {cube};
  while (mips && levels.back().width > 1) {
    Map next = nextMip(levels.back());
    levels.push_back(std::move(next));
  }
  return encodeLevels(levels, format);
}

}  // namespace welkin::maps
