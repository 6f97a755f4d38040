// SPDX-License-Identifier: Apache-2.0
// Decodes the texels of a PNG, JPEG or WebP in memory, by the libraries of these formats: OpenImageIO takes cut JPEGs,
// lets libpng write to the terminal and multiplies WebP's colours by alpha. Loading it would also take a second.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "sky/image/coded_image.h"

namespace welkin::image {

/// decodeImage() for a known format: "png", "jpeg" or "webp".
CodedImage decodeTexels(const std::string& name, std::string_view format, std::span<const std::byte> bytes,
                        const ImageLimits& limits);

}  // namespace welkin::image
