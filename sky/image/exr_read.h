// SPDX-License-Identifier: Apache-2.0
// Reads an EXR file.
#pragma once

#include <filesystem>

#include "sky/image/image.h"

namespace welkin::image {

/// Reads the channels R, G and B of a flat file's first part, or Y for all three, of any type, without conversion, and
/// the `envmap` attribute. This is readImage's part for EXR and throws the same errors. It does not check the values.
Image readExr(const std::filesystem::path& path, const ImageLimits& limits);

}  // namespace welkin::image
