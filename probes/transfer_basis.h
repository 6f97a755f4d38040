// SPDX-License-Identifier: Apache-2.0
// The transfer basis of Deferred Radiance Transfer Volumes (Stefanov, GDC 2012) and the weights that shade with it.
#pragma once

#include <array>

#include "shared.h"

namespace welkin::probes {

using f64::Number3;

inline constexpr std::size_t kDirections = 4;

/// Three orthonormal directions up, and down.
std::array<Number3, kDirections> transferBasis();

/// What each direction's irradiance counts for a normal: exact for every irradiance that is linear in the normal,
/// sum 1.
std::array<double, kDirections> shadingWeights(const Number3& normal);

}  // namespace welkin::probes
