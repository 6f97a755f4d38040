// SPDX-License-Identifier: Apache-2.0
// The orientation in the Exif data of JPEG and PNG (CIPA DC-008, 4.6.4).
#pragma once

#include <cstddef>
#include <span>

namespace welkin::image {

/// The tag Orientation, 1 to 8, of Exif data that starts with its byte order. 1 if it has none or is damaged.
int exifOrientation(std::span<const std::byte> exif);

}  // namespace welkin::image
