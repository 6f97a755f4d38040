// SPDX-License-Identifier: Apache-2.0
// A cube as texels of a GPU's format: the contents of KTX2 and DDS files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "maps/sky_map.h"

namespace welkin::maps {

/// Formats of texels, little-endian. Errors are relative and of a component between the format's smallest normal number
/// and its largest.
enum class Format {
  rgba16f,  ///< half floats, alpha 1: 8 bytes a texel, error 2^-11
  rgb9e5,   ///< shared exponent: 4 bytes a texel, error 2^-9 of the texel's largest component
  bc6h      ///< blocks of 4 x 4 texels in 16 bytes, unsigned (maps/bc6h.h)
};

/// Facts of a format that containers state.
struct FormatFacts {
  const char* name;            ///< as --format takes it
  std::uint32_t vulkan;        ///< VkFormat
  std::uint32_t dxgi;          ///< DXGI_FORMAT
  std::uint32_t scalar_bytes;  ///< bytes of the unit that a big-endian machine swaps; 1 for blocks
  std::uint32_t block_texels;  ///< texels along a block's edge
  std::uint32_t block_bytes;   ///< bytes of a block, or of a texel
};
const FormatFacts& factsOf(Format format);

/// The format of a name; none for unknown names.
std::optional<Format> formatOf(std::string_view name);

struct EncodedCube {
  Format format = Format::rgba16f;
  int size = 0;                                ///< texels along an edge of the largest mip
  std::vector<std::vector<std::byte>> levels;  ///< mips from the largest: the six faces, row after row
  std::size_t saturated = 0;                   ///< components past the format's largest number, stored as that
};

/// Encodes cubes of stacked faces as the mips of one, from the largest. There is at least one.
EncodedCube encodeLevels(const std::vector<Map>& levels, Format format);

/// Encodes a cube of stacked faces, and with `mips` every mip down to one texel. A mip is made of the unrounded texels.
EncodedCube encodeCube(const Map& cube, Format format, bool mips);

}  // namespace welkin::maps
