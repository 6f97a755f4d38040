// SPDX-License-Identifier: Apache-2.0
// Meaning of a picture's texels along one axis: their centres, and the function between them.
#pragma once

#include <cstddef>
#include <vector>

#include "sh/quadrature.h"

namespace welkin::sh {

enum class TexelRule {
  half_texel,   ///< centres at (i + 1/2) / N; constant over the texel
  edge_centres  ///< centres at i / (N - 1), the outer ones on edges and poles (OpenEXR, ImfEnvmap.h); linear between
};

/// A quadrature node of one cell: its position in [0, 1] of the axis, and its weights for the cell's first texel and
/// for the next one. With half_texel a cell is a texel; with edge_centres it lies between neighbouring texels.
struct CellNode {
  double position;
  double here;
  double next;
};

/// Number of cells of an axis of `size` texels: half_texel size >= 1, edge_centres size >= 2.
inline int cellCount(TexelRule rule, int size) {
  return rule == TexelRule::half_texel ? size : size - 1;
}

/// Node `index` of a cell; the weights of all cells add up to 1.
inline CellNode cellNode(TexelRule rule, int size, int cell, const GaussRule& gauss, std::size_t index) {
  const double width = 1.0 / cellCount(rule, size);
  const double inside = 0.5 + 0.5 * gauss.node[index];
  const double weight = 0.5 * gauss.weight[index] * width;
  const double next = rule == TexelRule::half_texel ? 0.0 : inside;
  return {(cell + inside) * width, weight * (1.0 - next), weight * next};
}

}  // namespace welkin::sh
