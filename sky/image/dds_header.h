// SPDX-License-Identifier: Apache-2.0
// Headers of DDS files (Microsoft's "DDS file layout for textures" and DDS_HEADER_DXT10). OpenImageIO fills cut files
// with zeros and knows few codes of DXGI, so it gets a header of the old kind that holds no more than was checked here.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace welkin::image {

/// Whether a file starts as a DDS file does.
bool isDds(std::span<const std::byte> file);

/// Whether the header's pixels are ones that are read, if the file holds a whole header: BC1, BC2, BC3 and BC7, RGB
/// with or without alpha of at most 8 bits a channel, and grey of 8 bits with or without alpha. Other pixels, colours
/// that are multiplied by alpha, cubes, volumes and arrays are not. True where the header is cut.
bool isReadableDds(std::span<const std::byte> file);

/// The largest mip level of a file for which isReadableDds() is true.
struct DdsLevel {
  std::string why_unusable;     ///< why it is damaged or cut; empty if it is not
  std::vector<std::byte> file;  ///< the level alone, as a DDS file with a header of the old kind
};
DdsLevel ddsLevel(std::span<const std::byte> file, int largest_side);

}  // namespace welkin::image
