// SPDX-License-Identifier: Apache-2.0
// Decodes PNG by libpng, which OpenImageIO lets write to the terminal and asks for no chunk but gAMA and iCCP.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sky/image/colour.h"
#include "sky/image/exif.h"
#include "sky/image/image.h"

namespace welkin::image {

struct PngPicture {
  int width = 0;
  int height = 0;
  int channels = 1;                ///< grey, grey and alpha, RGB, RGBA
  int bits = 8;                    ///< or 16
  std::vector<std::uint8_t> code;  ///< 16 bits in the order of this machine
  double gamma = 0.0;              ///< exponent of the decoding; 0 stands for sRGB
  std::optional<Chromaticities> colours;
  std::vector<std::byte> icc;
  std::optional<std::array<std::uint8_t, 4>> cicp;  ///< code points of ITU-T H.273
  ExifFields exif;                                  ///< its colours are unsaid where a chunk says them
  double pixel_aspect = 1.0;                        ///< width of a pixel over its height, by pHYs
  std::vector<std::string> notes;                   ///< parts that were left out
};

/// Throws Error(content), naming the file, for a damaged or cut file and sizes out of the limits.
PngPicture decodePng(const std::string& name, std::span<const std::byte> bytes, const ImageLimits& limits);

}  // namespace welkin::image
