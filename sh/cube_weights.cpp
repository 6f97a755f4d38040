// SPDX-License-Identifier: Apache-2.0
#include "sh/cube_weights.h"

#include <algorithm>
#include <cmath>

#include "sh/basis.h"

namespace welkin::sh {
namespace {

/// Nodes per cell and axis that integrate basis times solid angle to 1e-10 of c0. The integrand has its poles at
/// +-i sqrt(1 + t^2), so the error of n nodes on cells of width h falls as (h / 4)^(2 n).
int nodesOf(int size) {
  return size >= 256 ? 2 : size >= 64 ? 3 : size >= 16 ? 6 : size >= 6 ? 12 : 40;
}

}  // namespace

Parity parityOf(int m) {
  // Parts of (x + i y)^|m|: m >= 0 uses the real part, m < 0 the imaginary part.
  const bool odd = m % 2 != 0;
  return m >= 0 ? Parity{odd, false} : Parity{!odd, true};
}

CubeWeights::CubeWeights(int size, TexelRule rule, int bands)
    : size_(size), half_((size + 1) / 2), rule_(rule), gauss_(gaussLegendre(nodesOf(size))), recurrence_(bands) {}

void CubeWeights::addCellRow(double t, double weight, std::size_t stride, std::span<double> out) const {
  const auto n = static_cast<std::size_t>(half_);
  std::vector<double> scratch(7 * n);
  double* const x = scratch.data();
  double* const y = x + n;
  double* const z = y + n;
  double* const real = z + n;
  double* const imaginary = real + n;
  double* const before = imaginary + n;
  double* const current = before + n;
  for (std::size_t g = 0; g < gauss_.node.size(); ++g) {
    const CellNode first = cellNode(rule_, size_, 0, gauss_, g);
    const double step = 2.0 / cellCount(rule_, size_);
    for (std::size_t i = 0; i < n; ++i) {
      const double s = 2.0 * first.position - 1.0 + static_cast<double>(i) * step;
      z[i] = 1.0 / std::sqrt(1.0 + s * s + t * t);
      x[i] = s * z[i];
      y[i] = t * z[i];
      real[i] = z[i] * z[i] * z[i];  // the solid angle of ds dt
      imaginary[i] = 0.0;
    }
    const double here = 4.0 * weight * first.here;  // 4: both axes run from -1 to 1
    const double next = 4.0 * weight * first.next;
    const auto deposit = [&](int l, int m, const double* part) {
      double* const to = out.data() + static_cast<std::size_t>(indexOf(l, m)) * stride;
      for (std::size_t i = 0; i < n; ++i) to[i] += here * (current[i] * part[i]);
      if (next > 0.0)
        for (std::size_t i = 0; i + 1 < n; ++i) to[i + 1] += next * (current[i] * part[i]);
    };
    for (int m = 0; m < recurrence_.bands(); ++m) {
      if (m > 0)
        for (std::size_t i = 0; i < n; ++i) {
          const double grown = real[i] * x[i] - imaginary[i] * y[i];
          imaginary[i] = imaginary[i] * x[i] + real[i] * y[i];
          real[i] = grown;
        }
      std::fill_n(before, n, 0.0);
      std::fill_n(current, n, recurrence_.diagonal(m));
      for (int l = m; l < recurrence_.bands(); ++l) {
        if (l > m) {
          const double climb = recurrence_.climb(l, m);
          const double fall = recurrence_.fall(l, m);
          for (std::size_t i = 0; i < n; ++i) {
            const double grown = climb * z[i] * current[i] - fall * before[i];
            before[i] = current[i];
            current[i] = grown;
          }
        }
        deposit(l, m, real);
        if (m > 0) deposit(l, -m, imaginary);
      }
    }
  }
}

void CubeWeights::rowWeights(int row, std::size_t stride, std::span<double> out) const {
  std::fill(out.begin(), out.end(), 0.0);
  for (std::size_t g = 0; g < gauss_.node.size(); ++g) {
    const CellNode own = cellNode(rule_, size_, row, gauss_, g);
    if (row < cellCount(rule_, size_)) addCellRow(2.0 * own.position - 1.0, own.here, stride, out);
    if (rule_ == TexelRule::edge_centres && row > 0) {
      const CellNode above = cellNode(rule_, size_, row - 1, gauss_, g);
      addCellRow(2.0 * above.position - 1.0, above.next, stride, out);
    }
  }
}

}  // namespace welkin::sh
