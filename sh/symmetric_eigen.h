// SPDX-License-Identifier: Apache-2.0
// Eigenvectors of a real symmetric matrix.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace welkin::sh {

/// Eigenvalues, descending, and as many orthonormal eigenvectors of the first of them.
struct Eigensystem {
  std::vector<double> value;
  std::vector<double> vector;  ///< one a row, as long as the matrix is wide
};

/// The eigenvectors of the `count` largest eigenvalues (all of them, when there are fewer) of the symmetric n x n
/// `matrix`, row-major, finite. Householder's reduction to a tridiagonal matrix and implicit QR steps with Wilkinson's
/// shift (Golub and Van Loan, "Matrix Computations", 2013, 8.3): errors of a few n times 1e-16 of the largest
/// eigenvalue. Only + - * / and sqrt in fixed order: the same bits on every machine; those of Eigen's solver depend on
/// the size of the cache.
Eigensystem leadingEigenvectors(std::vector<double> matrix, std::size_t n, std::size_t count);

}  // namespace welkin::sh
