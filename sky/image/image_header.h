// SPDX-License-Identifier: Apache-2.0
// What image libraries take at its word: OpenEXR and libpng make room for the bytes that a header or a chunk names
// before they look whether the file holds them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <istream>
#include <optional>
#include <string>
#include <string_view>

#include "sky/image/image.h"

namespace welkin::image {

/// Why an image's file cannot be handed to its library, when it cannot: in OpenEXR an attribute that is longer than the
/// file, a data window or a tile of more than `largest_side` a side; in PNG a chunk that is longer than the file.
/// `format` is OpenImageIO's name. All else is the libraries' to judge.
std::optional<std::string> whyHeaderUnusable(const std::filesystem::path& path, std::string_view format,
                                             int largest_side);
std::optional<std::string> whyHeaderUnusable(std::istream& file, std::string_view format, int largest_side);

/// Throws Error(content) naming the file for a size out of the limits.
void requireSize(const std::string& file, std::int64_t width, std::int64_t height, const ImageLimits& limits);

}  // namespace welkin::image
