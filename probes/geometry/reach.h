// SPDX-License-Identifier: Apache-2.0
// The part of a level that one sector's bake reads: the surfaces within reach of its square.
#pragma once

#include "probes/geometry/sector.h"
#include "probes/geometry/surfaces.h"
#include "sky/base/hash.h"

namespace welkin::geometry {

using f64::Number3;

/// A square of the ground with everything above and below it, metres.
struct Column {
  double low_x = 0.0, high_x = 0.0;
  double low_z = 0.0, high_z = 0.0;

  bool touches(double from_x, double to_x, double from_z, double to_z) const {
    return from_x <= high_x && to_x >= low_x && from_z <= high_z && to_z >= low_z;
  }
  bool holds(const Number3& p) const { return touches(p.x, p.x, p.z, p.z); }
};

/// The sector's square, extended by `reach_m` on each side.
Column columnOf(SectorId sector, double reach_m);

/// A part of a level in canonical order, the same whatever else the level holds.
/// - Every triangle has three vertices of its own.
/// - Only materials and textures that the triangles use are there, in the order of first use.
/// - Objects are in the order of first use. Each vegetation object stays; all other objects of one role become one.
/// - Texture coordinates are there only if a texture uses them, and vertex colours only if one is not white.
/// - Objects have no names but those of their roles.
struct NearSurfaces {
  Surfaces surfaces;                   ///< without texels; `texture` has only wraps and sizes
  std::vector<std::uint32_t> texture;  ///< index of each texture in the level
};

/// The triangles whose boxes touch the column, in the level's order, the lights within the column, and
/// every directional light.
NearSurfaces surfacesWithin(const Surfaces& level, const Column& column);

/// The same with positions from the sector's corner: the same numbers wherever in the world the sector is.
NearSurfaces surfacesAbout(const Surfaces& level, SectorId sector, const Column& column);

/// Adds the level's texels, so that rays can be traced.
Surfaces withTexels(NearSurfaces near, const Surfaces& level);

/// Hashes of a level's textures, as addTo needs them.
std::vector<base::Hash128> textureHashes(const Surfaces& level);

/// Adds a material to a hash, with the indices of its textures.
void addTo(base::Hasher& hasher, const Material& material);

/// A hash of everything that a bake can see of the surfaces and lights within the column, from the sector's corner.
/// `content` as in OrderedLevel. It copies no surface.
base::Hash128 hashAbout(const Surfaces& level, const std::vector<base::Hash128>& content, SectorId sector,
                        const Column& column);

/// Adds everything that a bake can see of the surfaces to a hash.
void addTo(base::Hasher& hasher, const NearSurfaces& near, const std::vector<base::Hash128>& texture_hash);

}  // namespace welkin::geometry
