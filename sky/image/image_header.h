// SPDX-License-Identifier: Apache-2.0
// Checks sizes that image libraries trust: OpenEXR and libpng allocate the bytes that a header or a chunk names before
// they check that the file holds them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "sky/image/image.h"

namespace welkin::image {

/// Returns the reason why a file must not be passed to its library, if there is one. OpenEXR: an attribute longer than
/// the file, or a data window or tile with a side above `largest_side`. PNG: a chunk longer than the file. BMP and
/// Targa that are not packed: texels that the file does not hold, or that start in the header. `format` is
/// OpenImageIO's name. The libraries check everything else.
std::optional<std::string> whyHeaderUnusable(std::span<const std::byte> file, std::string_view format,
                                             int largest_side);

/// Throws Error(content), naming the file, for a size out of the limits.
void requireSize(const std::string& file, std::int64_t width, std::int64_t height, const ImageLimits& limits);

}  // namespace welkin::image
