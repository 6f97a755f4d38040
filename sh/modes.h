// SPDX-License-Identifier: Apache-2.0
// Principal modes: the few orthonormal vectors whose combinations come closest to a set of snapshots, by the weighted
// mean square or by the worst of them. Only + - * / and sqrt in fixed order: the same bits on every machine.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace welkin::sh {

/// Vectors of `dimension` finite numbers, one a row: of 1e-100 to 1e100, or 0.
struct Snapshots {
  std::span<const double> value;
  std::size_t dimension = 0;

  std::size_t count() const { return dimension == 0 ? 0 : value.size() / dimension; }
  std::span<const double> row(std::size_t i) const { return value.subspan(i * dimension, dimension); }
};

/// Orthonormal vectors, the most energetic first; of each, the component that is largest in magnitude (the first of
/// equals) is positive.
struct Modes {
  std::size_t dimension = 0;
  std::vector<double> vector;  ///< one a row
  std::vector<double> energy;  ///< of each: weighted mean square of the snapshots' coefficients; descending

  std::size_t count() const { return energy.size(); }
  std::span<const double> row(std::size_t k) const { return std::span(vector).subspan(k * dimension, dimension); }
};

/// The `count` leading modes, or as many as the snapshots have independent directions. `weights`: one a snapshot, not
/// negative, not all 0; none: all alike. What a snapshot has outside the span of the others counts when it is longer
/// than 1e-10 of the snapshot; modes are orthonormal to 1e-13.
Modes leadingModes(const Snapshots& snapshots, std::span<const double> weights, std::size_t count);

/// Coefficients of the combination of modes nearest to `snapshot` in the mean square, and what is left of it.
/// `coefficients` holds a number a mode, `residual` as many as the snapshot.
void projectOntoModes(const Modes& modes, std::span<const double> snapshot, std::span<double> coefficients,
                      std::span<double> residual);

/// How bad it is that snapshot i is wrong by `residual`: not negative, finite, 0 for no residual.
using ErrorMeasure = std::function<double(std::size_t i, std::span<const double> residual)>;

/// ErrorMeasure: the largest component of residual i in magnitude, of its image under a linear map (points x dimension,
/// row-major) when there is one, divided by scale[i] when there are scales.
struct MaximumNorm {
  std::span<const double> map = {};
  std::span<const double> scale = {};

  double operator()(std::size_t i, std::span<const double> residual) const;
};

/// Modes that lower the worst snapshot's error.
struct RefinedModes {
  Modes modes;
  double start_error = 0.0;  ///< the worst, by the modes that `weights` give
  double error = 0.0;        ///< the worst, by `modes`
  std::size_t worst = 0;     ///< the snapshot that has it
  std::size_t step = 0;      ///< after how many steps `modes` came up; 0: the start was never bettered
};

/// Starts from leadingModes and lowers the worst error by `measure`: each of `steps` steps multiplies a snapshot's
/// weight by a little and its error over the worst one and takes the leading modes anew (the iteration of Lawson,
/// "Contributions to the Theory of Linear Least Maximum Approximation", 1961, for a space of best approximation that
/// moves). It need not end at the best modes there are; the best step is kept, so it is never worse than the start. A
/// step costs the measure once a snapshot, and r^3 + r^2 snapshots for r independent directions.
RefinedModes refineModes(const Snapshots& snapshots, std::span<const double> weights, std::size_t count,
                         const ErrorMeasure& measure, std::size_t steps);

}  // namespace welkin::sh
