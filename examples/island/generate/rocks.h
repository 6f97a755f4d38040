// SPDX-License-Identifier: Apache-2.0
// Boulders, and the cave: a tunnel of rock that ends in a chamber.
#pragma once

#include "generate/mesh.h"

namespace welkin::island {

inline constexpr int kRockVariants = 3;

/// A boulder about 2 m across, its middle at the origin.
Mesh rock(int variant);

/// The cave's inside and the collar of rock round its mouth. -z leads in; the origin is the middle of the floor at the
/// mouth.
Mesh cave();

}  // namespace welkin::island
