// SPDX-License-Identifier: Apache-2.0
// A level's geometry as rays see it.
#pragma once

#include "probes/geometry/surfaces.h"
#include "probes/level/scene.h"

namespace welkin::loader {

/// Every placed triangle in the world, images decoded. Triangles of transforms that mirror keep their front. Those
/// without area (the cross product of two edges is 0 in double) or with numbers that are not finite are dropped,
/// counted and warned of; emission and lights are in the files' units, cd/m2 and cd, which are scene units where
/// luminance_unit is 1. Throws Error, naming file and part: `content` too for a vertex more than 1e6 m from the origin.
geometry::Surfaces surfacesOf(const level::Scene& scene);

/// The same of level.toml's geometry.
geometry::Surfaces readSurfaces(const level::LevelFile& level);

/// Gives every instance the mean of its material's texture as its colour, for pictures that draw no textures. Throws
/// Error for an image that cannot be decoded.
void useMeanColours(level::Scene& scene);

}  // namespace welkin::loader
