// SPDX-License-Identifier: Apache-2.0
// The sums of vectors that dense linear algebra is made of, in an order that does not depend on the compiler or the
// processor. Eigen's matrix products are no substitute: their blocks, and so the order of their sums, follow the size
// of the cache that they run on.
#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace welkin::sh {

/// Sum of a[i] b[i]; `b` is at least as long as `a`. Eight partial sums, so that additions need not wait for each
/// other; term i is added to sum i mod 8, then the sums pairwise.
inline double dot(std::span<const double> a, std::span<const double> b) {
  std::array<double, 8> sum{};
  std::size_t i = 0;
  for (; i + sum.size() <= a.size(); i += sum.size())
    for (std::size_t lane = 0; lane < sum.size(); ++lane) sum[lane] += a[i + lane] * b[i + lane];
  for (std::size_t lane = 0; i + lane < a.size(); ++lane) sum[lane] += a[i + lane] * b[i + lane];
  return ((sum[0] + sum[4]) + (sum[2] + sum[6])) + ((sum[1] + sum[5]) + (sum[3] + sum[7]));
}

/// Adds `factor` times `x` to `y`, which is at least as long.
inline void addMultiple(double factor, std::span<const double> x, std::span<double> y) {
  for (std::size_t i = 0; i < x.size(); ++i) y[i] += factor * x[i];
}

}  // namespace welkin::sh
