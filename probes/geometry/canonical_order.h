// SPDX-License-Identifier: Apache-2.0
// A level in an order of its own: that in which its files, nodes and meshes name things leaves no trace in a bake.
#pragma once

#include "probes/geometry/surfaces.h"

namespace welkin::geometry {

/// The same surfaces: triangles ordered by patches of 16 m, then by a hash of what a ray meets of them and their role,
/// each with three vertices of its own; of equal textures and of equal materials only the first is named; lights
/// ordered by position, then intensity. Equal triangles of several objects of vegetation are ordered by those objects'
/// triangles. Any part of it, taken in this order, depends on that part's surfaces alone. Objects keep their numbers.
Surfaces inCanonicalOrder(Surfaces level);

}  // namespace welkin::geometry
