// SPDX-License-Identifier: Apache-2.0
// The sky seen between black walls, as a convex polygon of directions. Its irradiance for any normal has a closed form
// (Lambert, "Photometria", 1760).
#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include "probes/geometry/directions.h"
#include "sh/deterministic.h"

namespace welkin::tests {

using f64::Number3;

/// Unit corners. Edges are arcs of less than half a circle, and for an edge from a to b, a x b points into the polygon.
using SkyPolygon = std::vector<Number3>;

/// The whole upper hemisphere.
inline SkyPolygon openSky() {
  return {{1, 0, 0}, {0, 0, -1}, {-1, 0, 0}, {0, 0, 1}};
}

/// The sky above a wall in the north that reaches an elevation.
inline SkyPolygon skyOverWall(double elevation_rad) {
  return {{1, 0, 0}, {0, std::sin(elevation_rad), -std::cos(elevation_rad)}, {-1, 0, 0}, {0, 0, 1}};
}

/// The sky between walls along z.
inline SkyPolygon skyOfCanyon(double width_m, double height_m) {
  const Number3 east = geometry::unit({0.5 * width_m, height_m, 0});
  return {{0, 0, 1}, east, {0, 0, -1}, {-east.x, east.y, 0}};
}

/// The sky from the middle of a well of closed_forms.h.
inline SkyPolygon skyOfWell(double apothem_m, double height_m, int sides) {
  SkyPolygon sky;
  const double radius = apothem_m / std::cos(det::kPi / sides);
  for (int i = sides; i > 0; --i) {
    const double azimuth = det::kTwoPi * (i + 0.5) / sides;
    sky.push_back(geometry::unit({radius * std::sin(azimuth), height_m, -radius * std::cos(azimuth)}));
  }
  return sky;
}

/// Irradiance over pi of a surface with this normal, by radiance 1 within the polygon. Take the part above the
/// surface's horizon: half the sum, over its edges, of the angle times the cosine of the edge's plane. Along the
/// horizon itself, from where the polygon sinks below it to where it rises, the cosine is 1.
inline double irradianceOverPi(const SkyPolygon& sky, const Number3& normal) {
  constexpr double kOnHorizon = 1e-12;
  const auto side = [&](const Number3& w) {
    const double cosine = dot(w, normal);
    return cosine > kOnHorizon ? 1 : cosine < -kOnHorizon ? -1 : 0;
  };
  const auto angle = [](const Number3& a, const Number3& b) {
    const Number3 across = cross(a, b);
    return std::atan2(std::sqrt(dot(across, across)), dot(a, b));
  };
  double sum = 0.0;
  std::vector<Number3> crossings;  // in turn, from the first one that rises
  std::optional<Number3> sinks_first;
  for (std::size_t i = 0; i < sky.size(); ++i) {
    Number3 a = sky[i];
    Number3 b = sky[(i + 1) % sky.size()];
    const int at_a = side(a);
    const int at_b = side(b);
    if (at_a <= 0 && at_b <= 0) continue;
    const Number3 crossing = geometry::unit(a * std::abs(dot(b, normal)) + b * std::abs(dot(a, normal)));
    const Number3 plane = geometry::unit(cross(a, b));
    if (at_a < 0) a = crossing;
    if (at_b < 0) b = crossing;
    if (at_a <= 0) crossings.push_back(a);
    if (at_b <= 0) (crossings.empty() ? sinks_first.emplace(b) : crossings.emplace_back(b));
    sum += angle(a, b) * dot(normal, plane);
  }
  if (sinks_first) crossings.push_back(*sinks_first);
  for (std::size_t i = 1; i < crossings.size(); i += 2)
    sum += angle(crossings[i], crossings[(i + 1) % crossings.size()]);
  return sum / det::kTwoPi;
}

}  // namespace welkin::tests
