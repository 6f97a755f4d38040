// SPDX-License-Identifier: Apache-2.0
// Guesses at what is wrong with a level as a whole, from its shape alone: a mesh for the sky around it, centimetres for
// metres. A level may be so on purpose, so these are hints.
#pragma once

#include <optional>
#include <string>

#include "probes/geometry/surfaces.h"

namespace welkin::build {

/// The name of a static object that encloses all other surfaces with room to spare and hides their sky, as a sky dome
/// or a skybox does. Nothing if there is none. Its box exceeds the others' to each side and above, by a tenth of their
/// extent, and it stops nine tenths of the rays upward from their middle.
std::optional<std::string> domeAround(const geometry::Surfaces& level);

/// Whether a level of so many sectors seems to be in centimetres: it has 256 or more, and half of its static triangles
/// have a side of 30 m or more.
bool seemsInCentimetres(const geometry::Surfaces& level, std::size_t sectors);

}  // namespace welkin::build
