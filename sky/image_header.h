// SPDX-License-Identifier: Apache-2.0
// What image libraries take at its word: OpenEXR and libpng make room for the bytes that a header or a chunk names
// before they look whether the file holds them, and OpenImageIO aborts at a pixel type that it does not know.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace welkin::sky {

/// Why an image's file cannot be handed to its library, when it cannot: in OpenEXR an attribute that is longer than the
/// file, a data window or a tile of more than `largest_side` a side, a channel of no known type; in PNG a chunk that is
/// longer than the file. `format` is OpenImageIO's name. All else is the libraries' to judge.
std::optional<std::string> whyHeaderUnusable(const std::filesystem::path& path, std::string_view format,
                                             int largest_side);

}  // namespace welkin::sky
