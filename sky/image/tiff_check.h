// SPDX-License-Identifier: Apache-2.0
// Decodes every strip and tile of a TIFF file by libtiff and throws the texels away. OpenImageIO takes a strip that
// libtiff decodes in part for a whole one, and returns memory that nothing wrote.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "sky/image/colour.h"
#include "sky/image/exif.h"
#include "sky/image/image.h"

namespace welkin::image {

/// Fields of the first picture that OpenImageIO does not honour.
struct TiffFields {
  ExifFields exif;  ///< and the tag Orientation
  std::optional<Chromaticities> colours;
  double pixel_aspect = 1.0;  ///< width of a pixel over its height, by XResolution and YResolution
  double nits = 1.0;          ///< StoNits: cd/m2 of a value of 1
  bool has_more = false;      ///< whether further pictures follow
};

/// Throws Error(content), naming the file, for a damaged or cut picture, sizes out of the limits, and what is not read:
/// colours that are neither grey, RGB, palette nor YCbCr; a transfer function.
TiffFields checkTiff(const std::string& name, std::span<const std::byte> bytes, const ImageLimits& limits);

}  // namespace welkin::image
