// SPDX-License-Identifier: Apache-2.0
// Puts a level into an order that depends only on its content. The order in which files, nodes and meshes name things
// leaves no trace in a bake.
#pragma once

#include "probes/geometry/surfaces.h"

namespace welkin::geometry {

/// The same surfaces in canonical order.
/// - Triangles are ordered by patches of 16 m, then by a hash of their role and of everything that a ray finds on them.
/// Each triangle has three vertices of its own.
/// - Of equal textures, and of equal materials, only the first is used.
/// - Lights are ordered by position, then intensity, then the rest.
/// - Equal triangles of several vegetation objects are ordered by the triangles of those objects.
/// The order within any part of the level depends on that part's surfaces alone. Objects keep their numbers.
Surfaces inCanonicalOrder(Surfaces level);

}  // namespace welkin::geometry
