// SPDX-License-Identifier: Apache-2.0
// The textures and colours of a triangle at a point of it.
#pragma once

#include "probes/geometry/surfaces.h"
#include "probes/geometry/texture.h"

namespace welkin::geometry {

inline Number3 load(const std::array<float, 3>& v) {
  return {double{v[0]}, double{v[1]}, double{v[2]}};
}

/// Weights of a triangle's three vertices.
struct Barycentric {
  double w[3];
  Barycentric(double u, double v) : w{1.0 - u - v, u, v} {}
};

/// The texel of one of the level's textures at a point of a triangle. The level has texture coordinates.
Texel texelOf(const Surfaces& s, const Triangle& triangle, const Barycentric& at, int texture, const UvRows& row);

/// Base colour and alpha of a triangle at a point.
Texel surfaceAt(const Surfaces& s, const Triangle& triangle, const Barycentric& at);

}  // namespace welkin::geometry
