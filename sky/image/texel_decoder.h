// SPDX-License-Identifier: Apache-2.0
// Decodes the texels of an image in memory, by OpenImageIO and, for WebP, libwebp: OpenImageIO multiplies WebP's
// colours by their alpha.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "sky/image/coded_image.h"

namespace welkin::image {

/// decodeImage() of a known format: OpenImageIO's name of it, or "webp".
CodedImage decodeTexels(const std::string& name, const char* format, std::span<const std::byte> bytes,
                        const ImageLimits& limits);

}  // namespace welkin::image
