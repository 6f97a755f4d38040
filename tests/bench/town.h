// SPDX-License-Identifier: Apache-2.0
// A town for benchmarks of probes.
#pragma once

#include <cmath>

#include "probes/random.h"
#include "probes/tracer.h"

namespace welkin::bench {

using f64::Number3;

inline void addTriangles(probes::Surfaces& s, std::initializer_list<Number3> corner, std::uint32_t material) {
  const auto first = static_cast<std::uint32_t>(s.position.size());
  for (const Number3& p : corner)
    s.position.push_back({static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
  s.triangle.push_back({{first, first + 1, first + 2}, material, 0});
  s.triangle.push_back({{first, first + 2, first + 3}, material, 0});
}

/// Hills of 1 m triangles over 160 m and a house in most squares of 12 m, each of its own colour.
inline probes::Surfaces town() {
  using probes::Random;
  probes::Surfaces s;
  s.object.push_back({"town", probes::Role::fixed});
  s.material.resize(1);
  s.material[0].albedo = {0.3, 0.35, 0.2};
  const auto height = [](double x, double z) { return 2.0 * std::sin(0.07 * x) * std::cos(0.05 * z + 1.0); };
  const auto at = [&](double x, double z) { return Number3(x, height(x, z), z); };
  for (int i = -80; i < 80; ++i)
    for (int j = -80; j < 80; ++j) addTriangles(s, {at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)}, 0);
  Random random(5);
  for (double x = -76; x < 76; x += 12)
    for (double z = -76; z < 76; z += 12) {
      const double w = 3.0 + 5.0 * random.unit();
      const double h = height(x, z) + 3.0 + 9.0 * random.unit();
      const Number3 colour(0.1 + 0.8 * random.unit(), 0.1 + 0.8 * random.unit(), 0.1 + 0.8 * random.unit());
      if (random.unit() < 0.2) continue;
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
  return s;
}

/// Positions 1 m above what rays from above meet in the middle 60 m.
inline std::vector<Number3> probesIn(const probes::Tracer& tracer, int count) {
  std::vector<Number3> position;
  probes::Random random(1);
  while (position.size() < static_cast<std::size_t>(count)) {
    const Number3 above(2 + 60 * random.unit(), 50, 2 + 60 * random.unit());
    const auto hit = tracer.closest(above, {0, -1, 0}, 100);
    if (hit) position.push_back(hit->position + Number3(0, 1, 0));
  }
  return position;
}

}  // namespace welkin::bench
