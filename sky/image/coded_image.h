// SPDX-License-Identifier: Apache-2.0
// Images as a texture stores them: codes of 8 bits, not decoded to light.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "sky/image/image.h"

namespace welkin::image {

/// Red, green, blue and alpha of every texel, rows from the top. Colours are not multiplied by alpha.
struct CodedImage {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;
};

/// Whether the first bytes, or for Targa the end of the name, are of a format that decodeImage() reads.
bool isTexture(const std::string& name, std::span<const std::byte> bytes);

/// Decodes the bytes of a PNG, JPEG, WebP, BMP, Targa or DDS file (of DDS what isReadableDds() tells). One channel is
/// grey, two are grey and alpha. Missing alpha becomes 255; 16 bits are rounded to 8. Colour spaces named in the file
/// are ignored (glTF 2.0, 3.8.3). The first bytes give the format; Targa is recognised by the end of the name. Throws
/// Error(content), naming `name`, for a damaged or foreign image, an animation, or a size out of the limits.
CodedImage decodeImage(const std::string& name, std::span<const std::byte> bytes, const ImageLimits& limits = {});

}  // namespace welkin::image
