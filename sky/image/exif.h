// SPDX-License-Identifier: Apache-2.0
// Orientation and colours in the Exif data of JPEG, PNG and TIFF (CIPA DC-008, 4.6; Adobe RGB as in DCF 2.0, 6.1).
#pragma once

#include <cstddef>
#include <span>

namespace welkin::image {

/// What Exif says of a picture's colours.
enum class ExifColours {
  unsaid,        ///< sRGB, or nothing
  adobe_rgb,     ///< ColorSpace 65535 with InteroperabilityIndex R03, or ColorSpace 2
  uncalibrated,  ///< ColorSpace 65535 alone
};

struct ExifFields {
  int orientation = 1;  ///< the tag Orientation, 1 to 8
  ExifColours colours = ExifColours::unsaid;
};

/// Fields of Exif data that start with their byte order, as a TIFF file does. Missing and damaged ones have defaults.
ExifFields readExif(std::span<const std::byte> exif);

}  // namespace welkin::image
