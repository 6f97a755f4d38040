// SPDX-License-Identifier: Apache-2.0
// Albedo as a file: linear OpenEXR of half floats, or a PNG or TIFF of 16 bits in encoded sRGB.
#pragma once

#include <filesystem>

#include "sky/image/image.h"

namespace welkin::calibrate {

/// Writes to the path, whose ending is .exr, .png or .tif. The last two clamp to [0, 1]. Throws Error(file).
void writeAlbedo(const std::filesystem::path& path, const image::Image& albedo);

}  // namespace welkin::calibrate
