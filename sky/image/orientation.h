// SPDX-License-Identifier: Apache-2.0
// Turns and mirrors a picture from the order of its file to rows from the top and columns from the left.
#pragma once

#include "sky/image/image.h"

namespace welkin::image {

/// The order of a file's texels. A line is a row, or a column if `columns` is set. `up` and `left` tell that rows come
/// from the bottom and columns from the right.
struct Orientation {
  bool columns = false;
  bool up = false;
  bool left = false;
};

/// The order by the tag Orientation of TIFF 6.0 and Exif 2.3, 1 to 8; others are read as 1.
Orientation orientationOfTag(int tag);

/// Reorders an image whose `width` is the length of the file's lines and whose `height` is their number.
void turnUpright(Orientation orientation, Image& image);

}  // namespace welkin::image
