// SPDX-License-Identifier: Apache-2.0
// Reads an EXR file.
#pragma once

#include <filesystem>

#include "sky/image/image.h"

namespace welkin::image {

/// The channels R, G and B of a flat file's first part, or Y thrice, any type, as they are stored; and its `envmap`
/// attribute. readImage's part for this format, and its errors; the values are not looked at.
Image readExr(const std::filesystem::path& path, const ImageLimits& limits);

}  // namespace welkin::image
