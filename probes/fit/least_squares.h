// SPDX-License-Identifier: Apache-2.0
// Least squares with many right-hand sides, and bounds on the unknowns: minimises
//   sum_i weight_i |row_i x - wanted_i|^2 + pull |x - start|^2
// The matrix is the same for all right-hand sides. The method is projected coordinate descent (Gauss and Seidel's
// sweeps; each unknown is put within its bounds as it is solved for), which converges for a positive definite matrix.
// Sums have a fixed order.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace welkin::fit {

/// A row of the matrix, without zeros.
struct Row {
  struct Entry {
    std::uint32_t unknown;
    double factor;
  };
  std::vector<Entry> entry;
  double weight = 1.0;
};

/// The normal matrix: sum of weight row^T row, with the pull on its diagonal.
class NormalMatrix {
 public:
  /// `pull` > 0 counts in means of the diagonal of all unknowns that a row has.
  NormalMatrix(std::size_t unknowns, std::span<const Row> rows, double pull);

  std::size_t unknowns() const { return diagonal_.size(); }
  double diagonal(std::size_t unknown) const { return diagonal_[unknown]; }
  /// The pull on each unknown.
  double pull() const { return pull_; }

  /// Adds the products of one unknown's row, without its diagonal, and `x`, which has `columns` numbers an unknown.
  void addOthers(std::size_t unknown, std::span<const double> x, std::size_t columns, std::span<double> sum) const;

 private:
  struct Entry {
    std::uint32_t unknown;
    double value;
  };
  std::vector<double> diagonal_;
  std::vector<std::vector<Entry>> other_;
  double pull_ = 0.0;
};

/// Sweeps over the unknowns. The error of the solution falls by about a third with each.
inline constexpr int kSweeps = 32;

/// Solves for the `columns` right-hand sides `moment`, the sum of weight row^T wanted: [unknown][column]. `x` holds the
/// start, to which unknowns are pulled, and then the solution. bound(unknown, numbers) puts an unknown's numbers within
/// their bounds.
template <typename Bound>
void solveBounded(const NormalMatrix& matrix, std::size_t columns, std::span<const double> moment, std::span<double> x,
                  const Bound& bound) {
  const std::vector<double> start(x.begin(), x.end());
  std::vector<double> rest(columns);
  for (int sweep = 0; sweep < kSweeps; ++sweep)
    for (std::size_t u = 0; u < matrix.unknowns(); ++u) {
      rest.assign(columns, 0.0);
      matrix.addOthers(u, x, columns, rest);
      const std::span<double> here = x.subspan(u * columns, columns);
      for (std::size_t c = 0; c < columns; ++c) {
        const std::size_t i = u * columns + c;
        here[c] = (moment[i] + matrix.pull() * start[i] - rest[c]) / matrix.diagonal(u);
      }
      bound(u, here);
    }
}

}  // namespace welkin::fit
