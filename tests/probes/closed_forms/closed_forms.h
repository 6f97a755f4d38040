// SPDX-License-Identifier: Apache-2.0
// Test levels whose light has a closed form: walls, canyons, wells, spheres, sealed rooms. The comment of each gives
// its sky view factor: irradiance over pi of level ground under a uniform sky of radiance 1, with black walls.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>

#include "sh/deterministic.h"
#include "tests/probes/rooms.h"

namespace welkin::tests {

/// Length that stands for infinity. It changes no sky view factor below by more than 1e-6.
inline constexpr double kEndless_m = 4000.0;

/// Level ground and, 10 m north of the origin, a wall to an elevation seen from the origin. (1 + cos g) / 2.
inline geometry::Surfaces wallTo(double elevation_rad, const Number3& ground, const Number3& wall) {
  geometry::Surfaces s = groundOf(ground, kEndless_m);
  addQuad(s, {-kEndless_m, 0, -10}, {2 * kEndless_m, 0, 0}, {0, 10 * std::tan(elevation_rad), 0}, addMaterial(s, wall));
  return s;
}
inline double skyViewOfWall(double elevation_rad) {
  return 0.5 * (1.0 + std::cos(elevation_rad));
}

/// Level ground along z and walls on both sides, the origin in the middle. cos(atan(2 H / W)).
inline geometry::Surfaces canyonOf(double width_m, double height_m, const Number3& ground, const Number3& wall) {
  geometry::Surfaces s = groundOf(ground, kEndless_m);
  const std::uint32_t material = addMaterial(s, wall);
  const double x = 0.5 * width_m;
  addQuad(s, {-x, 0, -kEndless_m}, {0, height_m, 0}, {0, 0, 2 * kEndless_m}, material);
  addQuad(s, {x, 0, -kEndless_m}, {0, 0, 2 * kEndless_m}, {0, height_m, 0}, material);
  return s;
}
inline double skyViewOfCanyon(double width_m, double height_m) {
  return std::cos(std::atan(2.0 * height_m / width_m));
}

/// Level ground within upright walls over a regular polygon about the origin, with sides at `apothem_m`. Four sides
/// make a square courtyard of width 2 apothem_m, many a round well.
inline geometry::Surfaces wellOf(double apothem_m, double height_m, int sides, const Number3& ground,
                                 const Number3& wall) {
  geometry::Surfaces s = groundOf(ground, 2.0 * apothem_m);
  const std::uint32_t material = addMaterial(s, wall);
  const double radius = apothem_m / std::cos(det::kPi / sides);
  const auto corner = [&](int i) {
    const double azimuth = det::kTwoPi * (i + 0.5) / sides;
    return Number3(radius * std::sin(azimuth), 0.0, -radius * std::cos(azimuth));
  };
  for (int i = 0; i < sides; ++i) addQuad(s, corner(i), corner(i + 1) - corner(i), {0, height_m, 0}, material);
  return s;
}
/// Sky view factor of the polygon itself (Lambert 1760): each side adds its angle times the cosine of its plane.
inline double skyViewOfWell(double apothem_m, double height_m, int sides) {
  const double away = std::sqrt(apothem_m * apothem_m + height_m * height_m);
  const double angle = 2.0 * std::atan(apothem_m * std::tan(det::kPi / sides) / away);
  return sides * angle * (apothem_m / away) / det::kTwoPi;
}
/// Sky view factor in the limit of many sides: cos^2(atan(H / R)).
inline double skyViewOfRoundWell(double radius_m, double height_m) {
  const double c = std::cos(std::atan(height_m / radius_m));
  return c * c;
}

/// A sphere about the origin as a subdivided icosahedron, seen from inside: 20 4^`levels` triangles with the area of
/// the sphere, so that the mean irradiance of light from within is exact.
inline geometry::Surfaces sphereInside(double radius_m, int levels, const Number3& albedo) {
  std::vector<Number3> vertex;
  const auto add = [&](const Number3& v) {
    vertex.push_back(v / std::sqrt(dot(v, v)));
    return static_cast<std::uint32_t>(vertex.size() - 1);
  };
  const double golden = 0.5 * (1.0 + std::sqrt(5.0));
  for (const double a : {-1.0, 1.0})
    for (const double b : {-golden, golden})
      for (const Number3& v : {Number3(0, a, b), Number3(a, b, 0), Number3(b, 0, a)}) add(v);
  using Corners = std::array<std::uint32_t, 3>;
  std::vector<Corners> triangle;
  const auto edge = [&](std::uint32_t i, std::uint32_t j) { return dot(vertex[i], vertex[j]) > 0.4; };
  for (std::uint32_t i = 0; i < 12; ++i)
    for (std::uint32_t j = i + 1; j < 12; ++j)
      for (std::uint32_t k = j + 1; k < 12; ++k)
        if (edge(i, j) && edge(j, k) && edge(i, k)) triangle.push_back({i, j, k});
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middle;
    const auto between = [&](std::uint32_t i, std::uint32_t j) {
      const auto [at, is_new] = middle.try_emplace(std::minmax(i, j), 0U);
      if (is_new) at->second = add(vertex[i] + vertex[j]);
      return at->second;
    };
    std::vector<Corners> finer;
    for (const auto& [a, b, c] : triangle) {
      const std::uint32_t ab = between(a, b);
      const std::uint32_t bc = between(b, c);
      const std::uint32_t ca = between(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    triangle = std::move(finer);
  }
  double area = 0.0;
  for (Corners& t : triangle) {
    const Number3 normal = cross(vertex[t[1]] - vertex[t[0]], vertex[t[2]] - vertex[t[0]]);
    if (dot(normal, vertex[t[0]]) > 0.0) std::swap(t[1], t[2]);
    area += 0.5 * std::sqrt(dot(normal, normal));
  }
  const double scale = radius_m * std::sqrt(4.0 * det::kPi / area);
  geometry::Surfaces s;
  s.object.push_back({"sphere", geometry::Role::fixed});
  const std::uint32_t material = addMaterial(s, albedo);
  for (const Number3& v : vertex)
    s.position.push_back(
        {static_cast<float>(scale * v.x), static_cast<float>(scale * v.y), static_cast<float>(scale * v.z)});
  for (const Corners& t : triangle) s.triangle.push_back({t, material, 0});
  return s;
}
/// Largest distance of the surface from the sphere, over the radius.
inline double roughnessOf(const geometry::Surfaces& sphere, double radius_m) {
  double worst = 0.0;
  const auto load = [&](std::uint32_t i) {
    const auto& p = sphere.position[i];
    return Number3(double{p[0]}, double{p[1]}, double{p[2]});
  };
  for (const geometry::Triangle& t : sphere.triangle) {
    const Number3 a = load(t.vertex[0]);
    const Number3 normal = cross(load(t.vertex[1]) - a, load(t.vertex[2]) - a);
    const double plane = std::abs(dot(normal, a)) / std::sqrt(dot(normal, normal));
    worst = std::max({worst, std::abs(std::sqrt(dot(a, a)) / radius_m - 1.0), std::abs(plane / radius_m - 1.0)});
  }
  return worst;
}

/// Two rooms of 4 x 3 x 4 m side by side along x. Between them at x = 0 is one wall without thickness. The room with x
/// < 0 has no roof if `open`. No light passes between them.
inline geometry::Surfaces twoRooms(const Number3& albedo, bool open) {
  geometry::Surfaces s;
  const std::uint32_t material = addMaterial(s, albedo, true);
  for (const double x : {-4.0, 0.0}) {
    addQuad(s, {x, 0, -2}, {0, 0, 4}, {4, 0, 0}, material);
    if (!open || x == 0.0) addQuad(s, {x, 3, -2}, {4, 0, 0}, {0, 0, 4}, material);
    addQuad(s, {x, 0, -2}, {4, 0, 0}, {0, 3, 0}, material);
    addQuad(s, {x, 0, 2}, {0, 3, 0}, {4, 0, 0}, material);
  }
  for (const double x : {-4.0, 0.0, 4.0}) addQuad(s, {x, 0, -2}, {0, 3, 0}, {0, 0, 4}, material);
  return s;
}

/// A vector turned about the vertical, clockwise from above like azimuths.
inline Number3 turned(const Number3& v, double azimuth_rad) {
  const double c = std::cos(azimuth_rad);
  const double s = std::sin(azimuth_rad);
  return {c * v.x - s * v.z, v.y, s * v.x + c * v.z};
}

/// A level turned about the vertical through the origin, then moved.
inline geometry::Surfaces turned(geometry::Surfaces surfaces, double azimuth_rad, const Number3& moved = Number3(0.0)) {
  for (auto& p : surfaces.position) {
    const Number3 v = turned(Number3(double{p[0]}, double{p[1]}, double{p[2]}), azimuth_rad) + moved;
    p = {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
  }
  return surfaces;
}

}  // namespace welkin::tests
