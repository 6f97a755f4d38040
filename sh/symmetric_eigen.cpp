// SPDX-License-Identifier: Apache-2.0
#include "sh/symmetric_eigen.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>

#include "sh/dot.h"

namespace welkin::sh {
namespace {

using Row = std::span<double>;

constexpr double kSquaresVanish = 1e-150;  // beside a matrix of size 1 nothing; its square is no number to divide by

struct Tridiagonal {
  std::vector<double> diagonal;
  std::vector<double> beside;    ///< between i and i + 1
  std::vector<double> strength;  ///< of the reflections 1 - strength v v^T, whose v are left in the matrix
};

Row rowOf(std::vector<double>& matrix, std::size_t n, std::size_t i) {
  return Row(matrix).subspan(i * n, n);
}

/// Reflects the part of the rows and columns after k so that only the first entry of row k is left there. Leaves v of
/// reflection k in row k, right of the diagonal. Algorithm 8.3.1 of the book.
Tridiagonal tridiagonalise(std::vector<double>& matrix, std::size_t n) {
  Tridiagonal result{std::vector<double>(n), std::vector<double>(n), std::vector<double>(n)};
  std::vector<double> product(n);
  for (std::size_t k = 0; k < n; ++k) {
    result.diagonal[k] = matrix[k * n + k];
    if (k + 1 == n) break;
    const Row v = rowOf(matrix, n, k).subspan(k + 1);
    const double length = std::sqrt(dot(v, v));
    if (length < kSquaresVanish) continue;
    const double reflected = v[0] > 0.0 ? -length : length;  // away from v: no digits cancel
    result.beside[k] = reflected;
    v[0] -= reflected;
    const double strength = 2.0 / dot(v, v);
    result.strength[k] = strength;
    const Row p = Row(product).first(v.size());
    for (std::size_t i = 0; i < v.size(); ++i) p[i] = strength * dot(v, rowOf(matrix, n, k + 1 + i).subspan(k + 1));
    addMultiple(-0.5 * strength * dot(p, v), v, p);
    for (std::size_t i = 0; i < v.size(); ++i) {
      const Row row = rowOf(matrix, n, k + 1 + i).subspan(k + 1);
      for (std::size_t j = 0; j < v.size(); ++j) row[j] -= v[i] * p[j] + p[i] * v[j];
    }
  }
  return result;
}

/// One implicit QR step on the block first..last, whose neighbours' entries are all non-zero; the rotations go into the
/// rows of `vectors`. Algorithm 8.3.2 of the book.
void stepQr(Tridiagonal& t, std::size_t first, std::size_t last, std::vector<double>& vectors) {
  const std::size_t n = t.diagonal.size();
  const double half = 0.5 * (t.diagonal[last - 1] - t.diagonal[last]);
  const double e = t.beside[last - 1];
  const double root = std::sqrt(half * half + e * e);
  const double shift = t.diagonal[last] - e * e / (half < 0.0 ? half - root : half + root);
  double x = t.diagonal[first] - shift;
  double bulge = t.beside[first];
  for (std::size_t k = first; k < last; ++k) {
    const double r = std::sqrt(x * x + bulge * bulge);
    const double c = r > 0.0 ? x / r : 1.0;
    const double s = r > 0.0 ? bulge / r : 0.0;
    if (k > first) t.beside[k - 1] = r;
    const double upper = t.diagonal[k];
    const double lower = t.diagonal[k + 1];
    const double between = t.beside[k];
    const double cross = 2.0 * c * s * between;
    t.diagonal[k] = c * c * upper + cross + s * s * lower;
    t.diagonal[k + 1] = s * s * upper - cross + c * c * lower;
    t.beside[k] = c * s * (lower - upper) + (c * c - s * s) * between;
    x = t.beside[k];
    if (k + 1 < last) {
      bulge = s * t.beside[k + 1];
      t.beside[k + 1] *= c;
    }
    const Row above = rowOf(vectors, n, k);
    const Row below = rowOf(vectors, n, k + 1);
    for (std::size_t i = 0; i < n; ++i) {
      const double a = above[i];
      const double b = below[i];
      above[i] = c * a + s * b;
      below[i] = c * b - s * a;
    }
  }
}

/// Makes `t` diagonal; returns its eigenvectors as rows. Entries below rounding count as zero; `t` is of size 1.
std::vector<double> diagonalise(Tridiagonal& t) {
  const std::size_t n = t.diagonal.size();
  std::vector<double> vectors(n * n, 0.0);
  for (std::size_t i = 0; i < n; ++i) vectors[i * n + i] = 1.0;
  const auto split = [&](std::size_t i) {
    const double scale = std::abs(t.diagonal[i]) + std::abs(t.diagonal[i + 1]);
    return std::abs(t.beside[i]) <= std::max(std::numeric_limits<double>::epsilon() * scale, kSquaresVanish);
  };
  std::size_t last = n - 1;
  const std::size_t most_steps = 30 * n;  // about 2 n are seen
  for (std::size_t step = 0; step < most_steps; ++step) {
    while (last > 0 && split(last - 1)) --last;
    if (last == 0) break;
    std::size_t first = last - 1;
    while (first > 0 && !split(first - 1)) --first;
    stepQr(t, first, last, vectors);
  }
  return vectors;
}

}  // namespace

Eigensystem leadingEigenvectors(std::vector<double> matrix, std::size_t n, std::size_t count) {
  assert(matrix.size() == n * n);
  Eigensystem result;
  if (n == 0) return result;
  double largest = 0.0;
  for (const double entry : matrix) largest = std::max(largest, std::abs(entry));
  if (largest > 0.0)
    for (double& entry : matrix) entry /= largest;
  Tridiagonal t = tridiagonalise(matrix, n);
  std::vector<double> vectors = diagonalise(t);

  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return t.diagonal[a] > t.diagonal[b]; });
  order.resize(std::min(count, n));
  for (const std::size_t i : order) {
    const Row vector = rowOf(vectors, n, i);
    for (std::size_t k = n - 1; k-- > 0;) {
      const Row v = rowOf(matrix, n, k).subspan(k + 1);
      addMultiple(-t.strength[k] * dot(v, vector.subspan(k + 1)), v, vector.subspan(k + 1));
    }
    result.value.push_back(t.diagonal[i] * largest);
    result.vector.insert(result.vector.end(), vector.begin(), vector.end());
  }
  return result;
}

}  // namespace welkin::sh
