// SPDX-License-Identifier: Apache-2.0
// Splits a polygon into triangles by cutting ears. Meisters, "Polygons have ears", 1975.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "shared.h"

namespace welkin::obj {

/// The corners of n - 2 triangles that cover a simple polygon of n >= 3 corners, convex or not. They turn as the
/// polygon does, and its corners need not lie exactly in a plane. A polygon that is not simple or not finite also gives
/// n - 2 triangles. Time grows at most with n times the number of corners that turn inwards.
std::vector<std::array<std::size_t, 3>> trianglesOf(std::span<const f64::Number3> polygon);

}  // namespace welkin::obj
