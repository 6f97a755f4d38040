// SPDX-License-Identifier: Apache-2.0
// Turns a level's geometry into surfaces for ray tracing.
#pragma once

#include "probes/geometry/surfaces.h"
#include "probes/level/scene.h"

namespace welkin::loader {

/// Every placed triangle in the world, with images decoded. Positions are multiples of 2^-24 m. Mirrored triangles keep
/// their front. Triangles are dropped, counted and warned of if they have no area (the cross product of two edges is 0
/// in double) or numbers that are not finite. Emission and lights, which the files give in cd/m2, cd and lux, come in
/// scene units: divided by the sky's `luminance_unit`, cd/m2, above 0. Throws Error, naming file and part; `content`
/// also for a vertex more than 1e6 m from the origin.
geometry::Surfaces surfacesOf(const level::Scene& scene, double luminance_unit);

/// Colours every instance with the mean of its material's texture, for pictures that draw no textures. Emission gets
/// the mean colour of its texture, blended materials the mean alpha, and glass the mean transmission; roughness and
/// metal the means of their own. Throws Error if an image cannot be decoded.
void useMeanColours(level::Scene& scene);

}  // namespace welkin::loader
