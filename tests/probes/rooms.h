// SPDX-License-Identifier: Apache-2.0
// Levels made of a few quadrilaterals, for tests.
#pragma once

#include "probes/geometry/surfaces.h"

namespace welkin::tests {

using f64::Number3;

/// Adds a material and returns its index.
inline std::uint32_t addMaterial(geometry::Surfaces& s, const Number3& albedo, bool double_sided = false,
                                 const Number3& emission = Number3(0.0)) {
  geometry::Material material;
  material.albedo = albedo;
  material.emission = emission;
  material.double_sided = double_sided;
  s.material.push_back(material);
  return static_cast<std::uint32_t>(s.material.size() - 1);
}

/// Adds the parallelogram at `corner` with edges `a` and `b`; its front looks along a x b.
inline void addQuad(geometry::Surfaces& s, const Number3& corner, const Number3& a, const Number3& b,
                    std::uint32_t material) {
  if (s.object.empty()) s.object.push_back({"room", geometry::Role::fixed});
  const auto first = static_cast<std::uint32_t>(s.position.size());
  for (const Number3& p : {corner, corner + a, corner + a + b, corner + b}) s.position.push_back({p.x, p.y, p.z});
  for (const auto& [i, j] : {std::pair{1U, 2U}, std::pair{2U, 3U}})
    s.triangle.push_back({{first, first + i, first + j}, material, 0});
}

/// Adds the six walls of a box, seen from inside.
inline void addBoxInside(geometry::Surfaces& s, const Number3& low, const Number3& high, std::uint32_t material) {
  const Number3 x(high.x - low.x, 0, 0);
  const Number3 y(0, high.y - low.y, 0);
  const Number3 z(0, 0, high.z - low.z);
  addQuad(s, low, z, x, material);
  addQuad(s, low + y, x, z, material);
  addQuad(s, low, x, y, material);
  addQuad(s, low + z, y, x, material);
  addQuad(s, low, y, z, material);
  addQuad(s, low + x, z, y, material);
}

/// Adds the six walls of a box, seen from outside.
inline void addBoxOutside(geometry::Surfaces& s, const Number3& low, const Number3& high, std::uint32_t material) {
  const std::size_t first = s.triangle.size();
  addBoxInside(s, low, high, material);
  for (std::size_t i = first; i < s.triangle.size(); ++i) std::swap(s.triangle[i].vertex[1], s.triangle[i].vertex[2]);
}

/// Level ground at y = 0, `half` metres to each side of the origin.
inline geometry::Surfaces groundOf(const Number3& albedo, double half = 1000.0) {
  geometry::Surfaces s;
  addQuad(s, {-half, 0, -half}, {0, 0, 2 * half}, {2 * half, 0, 0}, addMaterial(s, albedo));
  return s;
}

}  // namespace welkin::tests
