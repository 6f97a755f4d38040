// SPDX-License-Identifier: Apache-2.0
// Texels of a texture between their centres.
#pragma once

#include "probes/geometry/surfaces.h"

namespace welkin::geometry {

using f64::Number3;

struct Texel {
  Number3 colour;  ///< linear, in [0, 1]
  double alpha = 1.0;
};

/// Bilinear, in linear light; v counts from the top row's edge (glTF), wrapped as the texture says. A texture without
/// texels is white. Finite u and v.
Texel texelAt(const Texture& texture, double u, double v);

}  // namespace welkin::geometry
