// SPDX-License-Identifier: Apache-2.0
// Points of static triangles: those that contact factors are fitted to, and those that check them.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "probes/contact/placed_vertices.h"
#include "probes/geometry/tracer.h"

namespace welkin::contact {

/// A point of a triangle, on its front.
struct TrianglePoint {
  Number3 position, normal;             ///< metres, world; unit, of the triangle's plane
  std::array<std::uint32_t, 3> vertex;  ///< of PlacedVertices
  std::array<double, 3> share;          ///< of the corners, >= 0, 1 in all
  double area_m2 = 0.0;                 ///< that the point stands for
};

/// At least two points of every triangle, and one a square of `spacing_m` > 0 up to 64 of them.
std::vector<TrianglePoint> pointsToFit(const PlacedVertices& vertices, double spacing_m);

/// Random points, as many on every square metre. None of a level without triangles.
std::vector<TrianglePoint> pointsToCheck(const PlacedVertices& vertices, std::size_t count);

/// Whether a player can see the point: neither water above it nor a body about it.
bool isVisible(const geometry::Tracer& tracer, const TrianglePoint& point);

}  // namespace welkin::contact
