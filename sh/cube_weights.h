// SPDX-License-Identifier: Apache-2.0
// Integrals of the basis over the texels of a cube's face, in the face's own frame: x to the right, y down, z along the
// normal.
#pragma once

#include <span>

#include "sh/basis.h"
#include "sh/texel_rule.h"

namespace welkin::sh {

/// Whether a basis function of the face's frame is odd in x, and whether it is odd in y.
struct Parity {
  bool odd_x;
  bool odd_y;
};
Parity parityOf(int m);

/// Immutable; `rowWeights` may be called from many threads.
class CubeWeights {
 public:
  CubeWeights(int size, TexelRule rule, int bands);

  /// Number of texels in the left half of a row, including the middle texel of an odd size.
  int half() const { return half_; }
  /// Writes the weights of the left half of row `row` < half() to out[indexOf(l, m) * stride + column], stride >=
  /// half(). Columns from half() on are set to 0. The other three quarters of the face follow by parityOf.
  void rowWeights(int row, std::size_t stride, std::span<double> out) const;

 private:
  void addCellRow(double t, double weight, std::size_t stride, std::span<double> out) const;

  int size_;
  int half_;
  TexelRule rule_;
  GaussRule gauss_;
  LatitudeRecurrence recurrence_;
};

}  // namespace welkin::sh
