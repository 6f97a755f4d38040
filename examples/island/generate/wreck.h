// SPDX-License-Identifier: Apache-2.0
// The wreck: a rusty coaster of 28 m with a broken side.
#pragma once

#include "generate/mesh.h"

namespace welkin::island {

/// Bow to -z, upright, the keel at y = 0; the node tilts it.
Mesh wreck();

}  // namespace welkin::island
