// SPDX-License-Identifier: Apache-2.0
#include "probes/geometry/surface_at.h"

namespace welkin::geometry {

Texel texelOf(const Surfaces& s, const Triangle& triangle, const Barycentric& at, int texture, const UvRows& row) {
  double x = 0.0;
  double y = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    x += double{s.uv[triangle.vertex[i]][0]} * at.w[i];
    y += double{s.uv[triangle.vertex[i]][1]} * at.w[i];
  }
  return texelAt(s.texture[static_cast<std::size_t>(texture)], row[0][0] * x + row[0][1] * y + row[0][2],
                 row[1][0] * x + row[1][1] * y + row[1][2]);
}

Texel surfaceAt(const Surfaces& s, const Triangle& triangle, const Barycentric& at) {
  const Material& m = s.material[triangle.material];
  Texel result{m.albedo, m.alpha};
  if (!s.colour.empty()) {
    Number3 colour(0.0);
    for (std::size_t i = 0; i < 3; ++i) colour += load(s.colour[triangle.vertex[i]]) * at.w[i];
    result.colour = result.colour * colour;
  }
  if (m.texture < 0 || s.uv.empty()) return result;
  const Texel texel = texelOf(s, triangle, at, m.texture, m.uv_row);
  return {result.colour * texel.colour, result.alpha * texel.alpha};
}

}  // namespace welkin::geometry
