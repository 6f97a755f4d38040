// SPDX-License-Identifier: Apache-2.0
// Principal modes: the few orthonormal vectors whose combinations come closest to a set of snapshots, by the weighted
// mean square or by the largest error. They have the same bits on every machine, because of how sh/matrix.h uses Eigen.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace welkin::sh {

/// Vectors of `dimension` finite numbers, one a row. Each number is 0, or its magnitude is 1e-100 to 1e100.
struct Snapshots {
  std::span<const double> value;
  std::size_t dimension = 0;

  std::size_t count() const { return dimension == 0 ? 0 : value.size() / dimension; }
  std::span<const double> row(std::size_t i) const { return value.subspan(i * dimension, dimension); }
};

/// Orthonormal vectors, the most energetic first. The component of largest magnitude (the first of equals) is positive
/// in each vector.
struct Modes {
  std::size_t dimension = 0;
  std::vector<double> vector;  ///< one a row
  std::vector<double> energy;  ///< weighted mean square of the snapshots' coefficients of each mode; descending

  std::size_t count() const { return energy.size(); }
  std::span<const double> row(std::size_t k) const { return std::span(vector).subspan(k * dimension, dimension); }
};

/// The `count` leading modes, or fewer if the snapshots have fewer independent directions. `weights`: one per snapshot,
/// not negative, not all 0; empty: all equal. A direction counts as independent if the part of a snapshot along it is
/// longer than 1e-10 of the snapshot. Modes are orthonormal to 1e-13.
Modes leadingModes(const Snapshots& snapshots, std::span<const double> weights, std::size_t count);

/// Coefficients of the combination of modes nearest to `snapshot` in the mean square, and the residual.
/// `coefficients` holds one number per mode. `residual` is as long as `snapshot`, and must not overlap it.
void projectOntoModes(const Modes& modes, std::span<const double> snapshot, std::span<double> coefficients,
                      std::span<double> residual);

/// Error of snapshot i from its `residual`: not negative, finite, 0 for a residual of zeros.
using ErrorMeasure = std::function<double(std::size_t i, std::span<const double> residual)>;

/// ErrorMeasure: the largest magnitude among the components of the residual. If there is a `map` (points x dimension,
/// row-major), the residual is mapped first. If there are scales, the result is divided by scale[i].
struct MaximumNorm {
  std::span<const double> map = {};
  std::span<const double> scale = {};

  double operator()(std::size_t i, std::span<const double> residual) const;
};

/// Modes that lower the largest error of a snapshot.
struct RefinedModes {
  Modes modes;
  double start_error = 0.0;  ///< largest error with the leading modes of `weights`
  double error = 0.0;        ///< largest error with `modes`
  std::size_t worst = 0;     ///< index of the snapshot with that error
  std::size_t step = 0;      ///< the step that gave `modes`; 0: no step improved on the start
};

/// Starts from leadingModes and lowers the largest error by `measure`. Each of `steps` steps multiplies a snapshot's
/// weight by a constant plus its error over the largest one, and computes the leading modes again. This is the
/// iteration of Lawson, "Contributions to the Theory of Linear Least Maximum Approximation", 1961, for an approximating
/// space that changes. It may miss the best modes, but it keeps its best step and so is never worse than the start. A
/// step costs one measure per snapshot, and about r^3 + r^2 n operations for n snapshots of r independent directions.
RefinedModes refineModes(const Snapshots& snapshots, std::span<const double> weights, std::size_t count,
                         const ErrorMeasure& measure, std::size_t steps);

}  // namespace welkin::sh
