// SPDX-License-Identifier: Apache-2.0
// Albedo as a file: linear OpenEXR of half floats, or a PNG of 16 bits in encoded sRGB.
#pragma once

#include <filesystem>

#include "sky/image/image.h"

namespace welkin::calibrate {

/// Writes to the path, whose ending is .exr or .png. A PNG clamps to [0, 1]. Throws Error(file).
void writeAlbedo(const std::filesystem::path& path, const image::Image& albedo);

}  // namespace welkin::calibrate
