// SPDX-License-Identifier: Apache-2.0
// Decodes the texels of an image in memory. OpenImageIO does so for BMP, Targa and DDS. PNG, JPEG and WebP go to their
// own libraries: OpenImageIO takes cut JPEGs, lets libpng write to the terminal and multiplies WebP's colours by alpha.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "sky/image/coded_image.h"

namespace welkin::image {

/// decodeImage() for a known format: OpenImageIO's name of it, or "webp".
CodedImage decodeTexels(const std::string& name, const char* format, std::span<const std::byte> bytes,
                        const ImageLimits& limits);

}  // namespace welkin::image
