// SPDX-License-Identifier: Apache-2.0
#include <tbb/parallel_for.h>

#include <cmath>

#include "sh/basis.h"
#include "sh/environment.h"
#include "sh/rotation.h"

namespace welkin::sh {
namespace {

using det::Number3;

/// Calls give(texel, node position in [0, 1], weight) for every contribution of a cell of an axis to a texel.
template <typename Give>
void forEachShare(TexelRule rule, int size, Give&& give) {
  const GaussRule gauss = gaussLegendre(size < 16 ? 40 : 8);  // exact up to rounding for kMostBands
  for (int cell = 0; cell < cellCount(rule, size); ++cell)
    for (std::size_t g = 0; g < gauss.node.size(); ++g) {
      const CellNode node = cellNode(rule, size, cell, gauss, g);
      give(cell, node.position, node.here);
      if (rule == TexelRule::edge_centres) give(cell + 1, node.position, node.next);
    }
}

}  // namespace

std::vector<Number3> projectLatlong(const float* rgb, int width, int height, TexelRule rule, int bands) {
  const auto columns = static_cast<std::size_t>(width);
  const auto rows = static_cast<std::size_t>(height);
  const auto orders = static_cast<std::size_t>(2 * bands - 1);  // cos 0, cos m, sin m
  const auto count = static_cast<std::size_t>(coefficientCount(bands));

  std::vector<double> turn(columns * orders);
  forEachShare(rule, width, [&](int column, double u, double weight) {
    const double longitude = det::kPi - det::kTwoPi * u;  // from +z towards +x
    double* const to = turn.data() + static_cast<std::size_t>(column) * orders;
    to[0] += weight * det::kTwoPi;
    for (std::size_t m = 1; m < static_cast<std::size_t>(bands); ++m) {
      to[2 * m - 1] += weight * det::kTwoPi * det::cos(static_cast<double>(m) * longitude);
      to[2 * m] += weight * det::kTwoPi * det::sin(static_cast<double>(m) * longitude);
    }
  });
  std::vector<double> rise(rows * count);
  std::vector<double> factor(count);
  const LatitudeRecurrence recurrence(bands);
  forEachShare(rule, height, [&](int row, double v, double weight) {
    const double cosine = det::sin(det::kPi * v);  // of the elevation
    recurrence.evaluate(det::cos(det::kPi * v), cosine, factor);
    for (std::size_t k = 0; k < count; ++k)
      rise[static_cast<std::size_t>(row) * count + k] += weight * det::kPi * cosine * factor[k];
  });

  std::vector<Number3> around(rows * orders);
  tbb::parallel_for(std::size_t{0}, rows, [&](std::size_t row) {
    Number3* const sum = around.data() + row * orders;
    for (std::size_t i = 0; i < columns; ++i) {
      const float* p = rgb + 3 * (row * columns + i);
      const Number3 texel(double{p[0]}, double{p[1]}, double{p[2]});
      for (std::size_t k = 0; k < orders; ++k) sum[k] += texel * turn[i * orders + k];
    }
  });

  const Rotation to_world(bands, kPolarAxes);
  std::vector<Number3> result(count);
  std::vector<double> polar(count);
  std::vector<double> world(count);
  for (int c = 0; c < 3; ++c) {
    std::fill(polar.begin(), polar.end(), 0.0);
    for (std::size_t row = 0; row < rows; ++row)
      for (int l = 0; l < bands; ++l)
        for (int m = -l; m <= l; ++m) {
          const auto order = static_cast<std::size_t>(m > 0 ? 2 * m - 1 : -2 * m);
          polar[static_cast<std::size_t>(indexOf(l, m))] +=
              rise[row * count + static_cast<std::size_t>(indexOf(l, std::abs(m)))] * around[row * orders + order][c];
        }
    to_world.apply(polar, world);
    for (std::size_t k = 0; k < count; ++k) result[k][c] = world[k];
  }
  return result;
}

}  // namespace welkin::sh
