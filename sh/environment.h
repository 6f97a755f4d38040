// SPDX-License-Identifier: Apache-2.0
// Projection of pictures of the whole sphere, cubemaps and latlongs, into spherical harmonics.
//
// A picture stands for the function that its rule interpolates between the texels. Its coefficients are integrals of
// that function. A texel's weight is thus the basis integrated over the texel's share of it, not the basis at its
// centre times a solid angle. All sums are in double, so that the error does not grow with the size. They give the same
// bytes for any number of threads.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "sh/deterministic.h"
#include "sh/texel_rule.h"

namespace welkin::sh {

inline constexpr int kMostBands = 10;

/// A face of a cube: N x N RGB texels within a picture. The texel at (s, t), both in [-1, 1] and growing with column
/// and row, lies in the direction normal + s right + t down; the three are orthogonal unit vectors.
struct CubeFace {
  const float* rgb = nullptr;  ///< texel (0, 0)
  std::ptrdiff_t row = 0;      ///< floats from a row to the next one
  det::Number3 right, down, normal;
};

/// Coefficients of RGB radiance, bands^2, world axes. `size` >= 1, with edge_centres >= 2; `bands` in [1, kMostBands].
std::vector<det::Number3> projectCube(std::span<const CubeFace, 6> faces, int size, TexelRule rule, int bands);

/// Projects a latlong of width x height texels likewise. Row 0 is at +y, the middle is +z, and columns go from -z over
/// +x, +z and -x to -z. Both sizes >= 1, with edge_centres >= 2.
std::vector<det::Number3> projectLatlong(const float* rgb, int width, int height, TexelRule rule, int bands);

}  // namespace welkin::sh
