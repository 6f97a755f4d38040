// SPDX-License-Identifier: Apache-2.0
// Colour images from files: PNG, TIFF and EXR, and whatever else OpenImageIO reads.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace welkin::sky {

/// Linear Rec. 709, rows from the top.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<float> rgb;
};

/// Reads the first subimage. Integer images are sRGB-encoded (IEC 61966-2-1) unless the file says linear or names a
/// gamma; floating-point images are linear. One channel is grey; alpha is ignored.
/// Errors: Error(content) for a damaged or foreign file, more than 16384 texels a side or 2^24 in all, a
/// negative or non-finite value,
/// naming file, column, row (from the top) and value.
Image readImage(const std::filesystem::path& path);

}  // namespace welkin::sky
