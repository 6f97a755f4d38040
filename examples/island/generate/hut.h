// SPDX-License-Identifier: Apache-2.0
// A hut: plank walls with a door and windows, a room inside, a porch and a thatched roof.
#pragma once

#include "generate/mesh.h"

namespace welkin::island {

/// The door looks to -z; the origin is on the ground in the middle. Walls have the material "wall_red", which a
/// repainted mesh replaces. `onStilts` gives posts and a ladder, otherwise a base of stones and steps.
Mesh hut(bool onStilts);

}  // namespace welkin::island
