// SPDX-License-Identifier: Apache-2.0
// shaders/shared/transfer_basis.glsl as arrays, with the bits that reach a file.
#pragma once

#include <array>

#include "sh/deterministic.h"

namespace welkin::transfer {

using f64::Number3;

inline constexpr std::size_t kDirections = 4;

/// Three orthonormal directions up, and down.
inline std::array<Number3, kDirections> transferBasis() {
  const det::TransferBasis basis = det::transferBasis();
  return std::to_array(basis.v);
}

/// What each direction's irradiance counts for a normal: exact for every irradiance that is linear in the normal,
/// sum 1.
inline std::array<double, kDirections> shadingWeights(const Number3& normal) {
  const det::TransferWeights weight = det::transferWeights(normal);
  return std::to_array(weight.v);
}

}  // namespace welkin::transfer
