// SPDX-License-Identifier: Apache-2.0
// A cubemap as a device shows it: bilinear between the four texels around a direction, across the edges of faces
// (Vulkan 1.3, "Cube Map Face Selection", "Cube Map Edge Handling"; at a corner the missing texel is the mean of the
// three that meet there). In double; a device may round the weights to 8 bits (subTexelPrecisionBits) and the result.
#pragma once

#include <array>
#include <cstddef>

#include "sky/cubemap/cubemap.h"

namespace welkin::cubemap {

using det::Number3;

/// A texel that a direction sees.
struct TexelShare {
  std::size_t texel;  ///< (face size + row) size + column
  double weight;      ///< in [0, 1]
};

/// The texels that a direction sees; their weights add up to 1. At a corner one share has no texel and weight 0.
using Footprint = std::array<TexelShare, 4>;

/// The footprint in a cubemap of `size` >= 1 texels, in Vulkan's orientation. `direction` need not be unit; it is
/// finite and not 0.
Footprint footprintOf(int size, const Number3& direction);

/// Unit direction of a texel's centre.
Number3 directionOfTexel(int size, std::size_t texel);

/// Radiance in a direction of texels as a file holds them.
Number3 filterTexels(const unsigned char* texels, format::CubemapFormat format, const Footprint& footprint);

}  // namespace welkin::cubemap
