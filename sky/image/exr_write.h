// SPDX-License-Identifier: Apache-2.0
// Writes numbers that are no light, such as normals and gloss, as an EXR file of floats.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace welkin::image {

/// The bytes of a scanline EXR, ZIP-compressed, without a date: channels R, G and B for three channels, Y for one.
/// Texels are side by side, rows from the top; `texels` has width x height x channels numbers.
std::vector<std::byte> encodeExr(int width, int height, int channels, std::span<const float> texels);

}  // namespace welkin::image
