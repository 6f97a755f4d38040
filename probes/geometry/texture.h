// SPDX-License-Identifier: Apache-2.0
// Interpolates a texture between its texels.
#pragma once

#include "probes/geometry/surfaces.h"

namespace welkin::geometry {

using f64::Number3;

struct Texel {
  Number3 colour;  ///< linear, in [0, 1]
  double alpha = 1.0;
};

/// Bilinear interpolation in linear light. v counts from the edge of the top row (glTF), and the texture's wraps apply.
/// A texture without texels is white. u and v must be finite.
Texel texelAt(const Texture& texture, double u, double v);

}  // namespace welkin::geometry
