// SPDX-License-Identifier: Apache-2.0
// A town for benchmarks of probes.
#pragma once

#include <cmath>

#include "probes/geometry/random.h"
#include "probes/geometry/tracer.h"

namespace welkin::bench {

using f64::Number3;

inline void addTriangles(geometry::Surfaces& s, std::initializer_list<Number3> corner, std::uint32_t material) {
  const auto first = static_cast<std::uint32_t>(s.position.size());
  for (const Number3& p : corner)
    s.position.push_back({static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
  s.triangle.push_back({{first, first + 1, first + 2}, material, 0});
  s.triangle.push_back({{first, first + 2, first + 3}, material, 0});
}

struct Ground {
  int low_x, high_x, low_z, high_z;  ///< metres
};

/// Adds hills of triangles `step_m` wide; the ground's sides are multiples of it. Squares of 12 m, except the share
/// `empty`, get a house each, in a colour of its own. Grounds that touch fit together.
inline void addTown(geometry::Surfaces& s, const Ground& ground, int step_m, double empty) {
  using geometry::Random;
  if (s.object.empty()) s.object.push_back({"town", geometry::Role::fixed});
  const auto soil = static_cast<std::uint32_t>(s.material.size());
  s.material.emplace_back().albedo = {0.3, 0.35, 0.2};
  const auto height = [](double x, double z) { return 2.0 * std::sin(0.07 * x) * std::cos(0.05 * z + 1.0); };
  const auto at = [&](double x, double z) { return Number3(x, height(x, z), z); };
  for (int i = ground.low_x; i < ground.high_x; i += step_m)
    for (int j = ground.low_z; j < ground.high_z; j += step_m)
      addTriangles(s, {at(i, j), at(i, j + step_m), at(i + step_m, j + step_m), at(i + step_m, j)}, soil);
  Random random(5);
  for (double x = ground.low_x + 4; x < ground.high_x - 4; x += 12)
    for (double z = ground.low_z + 4; z < ground.high_z - 4; z += 12) {
      const double w = 3.0 + 5.0 * random.unit();
      const double h = height(x, z) + 3.0 + 9.0 * random.unit();
      const Number3 colour(0.1 + 0.8 * random.unit(), 0.1 + 0.8 * random.unit(), 0.1 + 0.8 * random.unit());
      if (random.unit() < empty || x + w > ground.high_x || z + w > ground.high_z) continue;
      const auto house = static_cast<std::uint32_t>(s.material.size());
      s.material.emplace_back().albedo = colour;
      const Number3 a(x, -3, z), b(x + w, -3, z), c(x + w, -3, z + w), d(x, -3, z + w);
      const Number3 up(0, h + 3, 0);
      addTriangles(s, {a, a + up, b + up, b}, house);
      addTriangles(s, {b, b + up, c + up, c}, house);
      addTriangles(s, {c, c + up, d + up, d}, house);
      addTriangles(s, {d, d + up, a + up, a}, house);
      addTriangles(s, {a + up, d + up, c + up, b + up}, house);
    }
}

/// The town on 160 x 160 m.
inline geometry::Surfaces town() {
  geometry::Surfaces s;
  addTown(s, {-80, 80, -80, 80}, 1, 0.2);
  return s;
}

/// Positions 1 m above the surfaces that rays from above hit in the middle 60 m.
inline std::vector<Number3> probesIn(const geometry::Tracer& tracer, int count) {
  std::vector<Number3> position;
  geometry::Random random(1);
  while (position.size() < static_cast<std::size_t>(count)) {
    const Number3 above(2 + 60 * random.unit(), 50, 2 + 60 * random.unit());
    const auto hit = tracer.closest(above, {0, -1, 0}, 100);
    if (hit) position.push_back(hit->position + Number3(0, 1, 0));
  }
  return position;
}

}  // namespace welkin::bench
