// SPDX-License-Identifier: Apache-2.0
// Triangles of a polygon by cutting ears. Meisters, "Polygons have ears", 1975.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "shared.h"

namespace welkin::loader {

/// The corners of n - 2 triangles that cover a simple polygon, convex or not, and turn as it does; its corners need not
/// lie exactly in a plane. What is not simple, or not finite, gives n - 2 triangles all the same. At least 3 corners.
std::vector<std::array<std::size_t, 3>> trianglesOf(std::span<const f64::Number3> polygon);

}  // namespace welkin::loader
