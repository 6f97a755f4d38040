// SPDX-License-Identifier: Apache-2.0
// What of a level a sector's bake reads: the surfaces within reach of its square.
#pragma once

#include "probes/geometry/sector.h"
#include "probes/geometry/surfaces.h"
#include "sky/base/hash.h"

namespace welkin::geometry {

using f64::Number3;

/// A square of the ground and all above and below it, metres.
struct Column {
  double low_x = 0.0, high_x = 0.0;
  double low_z = 0.0, high_z = 0.0;

  bool touches(double from_x, double to_x, double from_z, double to_z) const {
    return from_x <= high_x && to_x >= low_x && from_z <= high_z && to_z >= low_z;
  }
  bool holds(const Number3& p) const { return touches(p.x, p.x, p.z, p.z); }
};

/// The sector's square, wider by `reach_m` on each side.
Column columnOf(SectorId sector, double reach_m);

/// A part of a level that says the same whatever else the level holds, where the level is inCanonicalOrder: every
/// triangle has three vertices of its own; materials and textures are those that the triangles use, in the order of
/// their first use; so are objects, of which each of vegetation is one and all others of a role are one; texture
/// coordinates only where a texture uses them, vertex colours only where one is not white; no names but of roles.
struct NearSurfaces {
  Surfaces surfaces;                   ///< without texels: `texture` has the wraps and sizes
  std::vector<std::uint32_t> texture;  ///< which of the level's they are
};

/// The triangles whose boxes touch the column, in the level's order, and the lights within it.
NearSurfaces surfacesWithin(const Surfaces& level, const Column& column);

/// With the level's texels: what rays are traced through.
Surfaces withTexels(NearSurfaces near, const Surfaces& level);

/// The hashes of a level's textures, which surfacesHash needs.
std::vector<base::Hash128> textureHashes(const Surfaces& level);

/// Of a material, its texture by number.
void addTo(base::Hasher& hasher, const Material& material);

/// Of everything that a bake can see of the surfaces.
void addTo(base::Hasher& hasher, const NearSurfaces& near, const std::vector<base::Hash128>& texture_hash);

}  // namespace welkin::geometry
