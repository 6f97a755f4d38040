// SPDX-License-Identifier: Apache-2.0
// Reads an EXR file.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "sky/image/image.h"

namespace welkin::image {

/// readImage()'s part for EXR; it throws the same errors and does not check the values. With the attribute `envmap` the
/// picture is the data window, as in OpenEXR's own maps. Without, it is the display window: texels outside of it are
/// left out, and texels that the data window lacks are black; a note says so. Luminance and chroma become RGB by linear
/// interpolation between the samples of the chroma, which is exact where the chroma is linear.
Image readExr(const std::string& name, std::span<const std::byte> bytes, const ImageLimits& limits,
              const std::string& layer);

}  // namespace welkin::image
