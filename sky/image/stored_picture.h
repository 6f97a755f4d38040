// SPDX-License-Identifier: Apache-2.0
// A picture as its file stores it, with the header fields that give its numbers their meaning.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "sky/image/colour.h"
#include "sky/image/exif.h"
#include "sky/image/image.h"

namespace welkin::image {

struct StoredPicture {
  Image image;         ///< floats as stored, or codes divided by the largest code; not yet turned
  double gamma = 0.0;  ///< exponent of the decoding; 1 is linear, 0 stands for sRGB's own curve
  std::optional<Chromaticities> colours;
  std::vector<std::byte> icc;  ///< ICC profile; it comes before gamma and colours
  ExifFields exif;             ///< or the tag Orientation of TIFF; its colours come last
};

/// Linear Rec. 709, upright. Throws Error(content), naming the file, for a profile or colours that cannot be honoured.
/// `linear_codes` is as in ImageLimits.
Image decoded(const std::string& name, StoredPicture picture, bool linear_codes = false);

}  // namespace welkin::image
