// SPDX-License-Identifier: Apache-2.0
// Value noise in three dimensions, smooth and the same on every machine.
#pragma once

#include "generate/geometry.h"

namespace welkin::island {

/// Noise in [0, 1] with period 2^32 and lattice spacing 1.
double noise(const Vec3& p, uint32_t seed);

/// A sum of octaves of noise, each half as large and twice as fine as the one before; in [0, 1], mean 0.5.
double fractalNoise(const Vec3& p, int octaves, uint32_t seed);

}  // namespace welkin::island
