// SPDX-License-Identifier: Apache-2.0
// Palms, bushes and ferns.
#pragma once

#include "generate/mesh.h"

namespace welkin::island {

inline constexpr int kPalmVariants = 3;
inline constexpr int kBushVariants = 4;

/// A palm whose trunk leans to -z.
Mesh palm(int variant);

/// Variant 0: a round bush; 1: a bush in flower; 2: a fern of arched blades; 3: a tuft of grass.
Mesh bush(int variant);

}  // namespace welkin::island
