// SPDX-License-Identifier: Apache-2.0
// Pictures in PNG and JPEG, by libpng and libjpeg.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "sky/image/image.h"
#include "sky/image/stored_picture.h"

namespace welkin::image {

/// Reads a picture whose format is "png" or "jpeg". Throws Error(content) if it is damaged, cut or too large.
StoredPicture readCodedPicture(const std::string& name, std::string_view format, std::span<const std::byte> bytes,
                               const ImageLimits& limits);

}  // namespace welkin::image
