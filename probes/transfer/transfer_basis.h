// SPDX-License-Identifier: Apache-2.0
// The formulas of shaders/shared/transfer_basis.glsl as arrays, with the bits that the files store.
#pragma once

#include <array>

#include "sh/deterministic.h"

namespace welkin::transfer {

using f64::Number3;

inline constexpr std::size_t kDirections = 4;

/// Three orthonormal directions that point up, then the direction down.
inline std::array<Number3, kDirections> transferBasis() {
  const det::TransferBasis basis = det::transferBasis();
  return std::to_array(basis.v);
}

/// Weight of each direction's irradiance for a normal; the weights sum to 1. Exact for irradiance that is linear in the
/// normal.
inline std::array<double, kDirections> shadingWeights(const Number3& normal) {
  const det::TransferWeights weight = det::transferWeights(normal);
  return std::to_array(weight.v);
}

}  // namespace welkin::transfer
