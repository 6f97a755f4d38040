// SPDX-License-Identifier: Apache-2.0
// Puts a level into an order that depends only on its content. The order in which files, nodes and meshes name things
// leaves no trace in a bake.
#pragma once

#include <utility>

#include "probes/geometry/surfaces.h"
#include "sky/base/hash.h"

namespace welkin::geometry {

/// The same surfaces in canonical order.
/// - Triangles are ordered by patches of 16 m, then by a hash of their role and of everything that a ray finds on them.
/// Each triangle has three vertices of its own.
/// - Of equal textures, and of equal materials, only the first is used.
/// - Of equal triangles that are not vegetation, only the first stays: a ray finds no other.
/// - Lights are ordered by position, then intensity, then the rest.
/// - Equal triangles of several vegetation objects are ordered by the triangles of those objects.
/// The order within any part of the level depends on that part's surfaces alone. Objects keep their numbers.
Surfaces inCanonicalOrder(Surfaces level);

/// The same, with a hash of each triangle: of its role, its material with its texture, and its vertices. Positions
/// count from the corner of its patch, so the hash is the same in every sector.
struct OrderedLevel {
  Surfaces surfaces;
  std::vector<base::Hash128> content;  ///< by triangle
};
OrderedLevel orderedLevel(Surfaces level);

/// Side of a patch, metres: a part of a sector's side.
inline constexpr double kPatch_m = 16.0;

/// Numbers of a triangle's patch along x and z, by its first vertex.
std::pair<int, int> patchOf(const Surfaces& level, const Triangle& triangle);

}  // namespace welkin::geometry
