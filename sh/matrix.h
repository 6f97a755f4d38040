// SPDX-License-Identifier: Apache-2.0
// Arrays seen as Eigen's matrices. Only .cpp files and headers private to a folder include this: Eigen compiles slowly.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <type_traits>

#if !defined(EIGEN_DONT_VECTORIZE) || !defined(EIGEN_DONT_PARALLELIZE) || !defined(EIGEN_NO_CPUID)
#error "Baked bytes need Eigen as the target welkin_eigen defines it: no vectors, no threads, no look at the cache"
#endif

namespace welkin::sh {

using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// The contiguous doubles of `range` as a column vector.
template <typename Range>
auto asVector(Range&& range) {
  using Value = std::remove_pointer_t<decltype(range.data())>;
  using Vector = std::conditional_t<std::is_const_v<Value>, const Eigen::VectorXd, Eigen::VectorXd>;
  return Eigen::Map<Vector>(range.data(), static_cast<Eigen::Index>(range.size()));
}

/// The contiguous doubles of `range` as a matrix of `columns` > 0 columns, row by row.
template <typename Range>
auto asRows(Range&& range, std::size_t columns) {
  using Value = std::remove_pointer_t<decltype(range.data())>;
  using Matrix = std::conditional_t<std::is_const_v<Value>, const RowMatrix, RowMatrix>;
  return Eigen::Map<Matrix>(range.data(), static_cast<Eigen::Index>(range.size() / columns),
                            static_cast<Eigen::Index>(columns));
}

}  // namespace welkin::sh
