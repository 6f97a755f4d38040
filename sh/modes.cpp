// SPDX-License-Identifier: Apache-2.0
#include "sh/modes.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "sh/dot.h"
#include "sh/symmetric_eigen.h"

namespace welkin::sh {
namespace {

/// An orthonormal basis (rows) of the snapshots' span and their coordinates in it.
struct Span {
  std::size_t rank = 0;
  std::vector<double> basis;
  std::vector<double> coordinates;  ///< a snapshot a row
};

/// Gram and Schmidt's method, with the snapshot next of which the largest part is outside the span so far.
Span spanOf(const Snapshots& snapshots) {
  constexpr double kInside = 1e-20;  // square of the relative length outside that counts as none
  const std::size_t count = snapshots.count();
  const std::size_t n = snapshots.dimension;
  std::vector<double> outside(snapshots.value.begin(), snapshots.value.end());
  const auto row = [&](std::size_t i) { return std::span(outside).subspan(i * n, n); };
  std::vector<double> square(count);
  for (std::size_t i = 0; i < count; ++i) square[i] = dot(row(i), row(i));

  Span span;
  std::vector<double> left(count, 1.0);  // squares of the relative lengths outside; 0 for what is inside
  for (std::size_t i = 0; i < count; ++i)
    if (square[i] == 0.0) left[i] = 0.0;
  std::vector<std::vector<double>> coordinate;  // of every snapshot, along each basis vector
  while (span.rank < n) {
    const auto next = std::max_element(left.begin(), left.end());
    if (next == left.end() || *next <= kInside) break;
    const auto pivot = row(static_cast<std::size_t>(next - left.begin()));
    std::vector<double> direction(pivot.begin(), pivot.end());
    for (std::size_t pass = 0; pass < 2; ++pass) {  // the second makes up for the digits lost to cancellation
      const double length = std::sqrt(dot(direction, direction));
      for (double& component : direction) component /= length;
      for (std::size_t k = 0; k < span.rank; ++k) {
        const auto earlier = std::span<const double>(span.basis).subspan(k * n, n);
        addMultiple(-dot(earlier, direction), earlier, direction);
      }
    }
    const double length = std::sqrt(dot(direction, direction));
    for (double& component : direction) component /= length;

    std::vector<double>& along = coordinate.emplace_back(count, 0.0);
    for (std::size_t i = 0; i < count; ++i) {
      if (left[i] == 0.0) continue;
      along[i] = dot(direction, row(i));
      addMultiple(-along[i], direction, row(i));
      left[i] = dot(row(i), row(i)) / square[i];
    }
    *next = 0.0;
    span.basis.insert(span.basis.end(), direction.begin(), direction.end());
    ++span.rank;
  }
  span.coordinates.resize(count * span.rank);
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t k = 0; k < span.rank; ++k) span.coordinates[i * span.rank + k] = coordinate[k][i];
  return span;
}

/// The weights, or a 1 for every snapshot, made to add up to 1.
std::vector<double> sharesOf(std::span<const double> weights, std::size_t count) {
  assert(weights.empty() || weights.size() == count);
  std::vector<double> share(weights.begin(), weights.end());
  if (share.empty()) share.assign(count, 1.0);
  const double largest = share.empty() ? 1.0 : *std::max_element(share.begin(), share.end());
  double sum = 0.0;
  for (const double weight : share) sum += weight / largest;
  for (double& weight : share) weight = weight / largest / sum;
  return share;
}

void makeLargestPositive(std::span<double> vector) {
  double largest = 0.0;
  for (const double component : vector)
    if (std::abs(component) > std::abs(largest)) largest = component;
  if (largest < 0.0)
    for (double& component : vector) component = -component;
}

/// The leading eigenvectors of the snapshots' weighted Gram matrix in the coordinates of their span.
Modes modesIn(const Span& span, std::size_t dimension, std::span<const double> share, std::size_t count) {
  const std::size_t r = span.rank;
  std::vector<double> gram(r * r, 0.0);
  for (std::size_t i = 0; i < share.size(); ++i) {
    const auto at = std::span(span.coordinates).subspan(i * r, r);
    for (std::size_t k = 0; k < r; ++k)
      addMultiple(share[i] * at[k], at.first(k + 1), std::span(gram).subspan(k * r, r));
  }
  for (std::size_t k = 0; k < r; ++k)
    for (std::size_t j = k + 1; j < r; ++j) gram[k * r + j] = gram[j * r + k];
  const Eigensystem eigen = leadingEigenvectors(std::move(gram), r, count);

  Modes modes;
  modes.dimension = dimension;
  modes.vector.assign(eigen.vector.size() / std::max<std::size_t>(r, 1) * dimension, 0.0);
  for (std::size_t k = 0; k * dimension < modes.vector.size(); ++k) {
    const auto mode = std::span(modes.vector).subspan(k * dimension, dimension);
    for (std::size_t j = 0; j < r; ++j)
      addMultiple(eigen.vector[k * r + j], std::span(span.basis).subspan(j * dimension, dimension), mode);
    makeLargestPositive(mode);
    modes.energy.push_back(std::max(eigen.value[k], 0.0));
  }
  return modes;
}

}  // namespace

Modes leadingModes(const Snapshots& snapshots, std::span<const double> weights, std::size_t count) {
  return modesIn(spanOf(snapshots), snapshots.dimension, sharesOf(weights, snapshots.count()), count);
}

void projectOntoModes(const Modes& modes, std::span<const double> snapshot, std::span<double> coefficients,
                      std::span<double> residual) {
  std::copy(snapshot.begin(), snapshot.end(), residual.begin());
  for (std::size_t k = 0; k < modes.count(); ++k) {
    coefficients[k] = dot(modes.row(k), residual);
    addMultiple(-coefficients[k], modes.row(k), residual);
  }
}

double MaximumNorm::operator()(std::size_t i, std::span<const double> residual) const {
  double largest = 0.0;
  if (map.empty())
    for (const double component : residual) largest = std::max(largest, std::abs(component));
  for (std::size_t row = 0; row < map.size(); row += residual.size())
    largest = std::max(largest, std::abs(dot(residual, map.subspan(row, residual.size()))));
  return scale.empty() ? largest : largest / scale[i];
}

RefinedModes refineModes(const Snapshots& snapshots, std::span<const double> weights, std::size_t count,
                         const ErrorMeasure& measure, std::size_t steps) {
  constexpr double kKept = 0.1;  // so that a snapshot that was once exact can come back; 0 to 0.1 do equally well
  const Span span = spanOf(snapshots);
  std::vector<double> share = sharesOf(weights, snapshots.count());
  std::vector<double> error(snapshots.count());
  std::vector<double> residual(snapshots.dimension);
  RefinedModes best;
  for (std::size_t step = 0; step <= steps; ++step) {
    Modes modes = modesIn(span, snapshots.dimension, share, count);
    std::vector<double> coefficients(modes.count());
    for (std::size_t i = 0; i < error.size(); ++i) {
      projectOntoModes(modes, snapshots.row(i), coefficients, residual);
      error[i] = measure(i, residual);
    }
    const auto worst = std::max_element(error.begin(), error.end());
    if (worst == error.end()) return best;
    if (step == 0) best.start_error = *worst;
    if (step == 0 || *worst < best.error) {
      best.modes = std::move(modes);
      best.error = *worst;
      best.worst = static_cast<std::size_t>(worst - error.begin());
      best.step = step;
    }
    if (*worst == 0.0) break;
    for (std::size_t i = 0; i < error.size(); ++i) share[i] *= kKept + error[i] / *worst;
    share = sharesOf(share, share.size());
  }
  return best;
}

}  // namespace welkin::sh
