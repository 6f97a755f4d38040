// SPDX-License-Identifier: Apache-2.0
// Decodes JPEG by libjpeg, whose warnings of damage are errors here: OpenImageIO takes a cut file for a whole one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "sky/image/exif.h"
#include "sky/image/image.h"

namespace welkin::image {

struct JpegPicture {
  int width = 0;
  int height = 0;
  int channels = 1;  ///< 1 or 3
  std::vector<std::uint8_t> code;
  std::vector<std::byte> icc;  ///< the profile, if there is one
  ExifFields exif;
  double pixel_aspect = 1.0;  ///< width of a pixel over its height, by JFIF's densities
};

/// Throws Error(content), naming the file, for a damaged or cut file, sizes out of the limits, or colours in CMYK.
JpegPicture decodeJpeg(const std::string& name, std::span<const std::byte> bytes, const ImageLimits& limits);

}  // namespace welkin::image
