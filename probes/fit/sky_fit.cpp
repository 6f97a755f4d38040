// SPDX-License-Identifier: Apache-2.0
#include "probes/fit/sky_fit.h"

#include <algorithm>

#include "probes/transfer/transfer_basis.h"

namespace welkin::fit {
namespace {

constexpr std::size_t kUp = 3;  ///< directions that see the sky
constexpr std::size_t kBands = 4;
constexpr std::size_t kColumns = 3 * kBands;  ///< of an unknown: [coefficient][channel]

/// The pull of each coefficient to what was traced, relative to the weight that it has in the fit. It settles the
/// combinations of coefficients that no sky has.
constexpr double kRidge = 1e-3;
/// The pull of visibility to what was traced, relative to the weight that it has in the fit. It decides how much of the
/// light is the sky's own and how much has bounced, where both would do.
constexpr double kVisibilityPull = 0.02;
/// Rounds of visibility and transfer of one unknown, in each sweep.
constexpr int kRounds = 8;

using Moments = std::array<std::array<double, kBands>, kBands>;

/// Means of the products of the skies' coefficients.
Moments momentsOf(const TrainingSkies& skies) {
  Moments m{};
  const auto count = static_cast<double>(skies.count());
  for (std::size_t l = 0; l < skies.count(); ++l)
    for (std::size_t j = 0; j < kBands; ++j)
      for (std::size_t k = 0; k < kBands; ++k)
        m[j][k] += skies.weight(l) * skies.coefficient(l)[j] * skies.coefficient(l)[k] / count;
  return m;
}

class SkyFit {
 public:
  SkyFit(const NormalMatrix& matrix, const TrainingSkies& skies, std::span<transfer::ProbeTransfer* const> probes)
      : matrix_(matrix),
        skies_(skies),
        probes_(probes),
        moments_(momentsOf(skies)),
        x_(matrix.unknowns() * kColumns),
        wanted_(x_.size(), 0.0) {
    const auto basis = transfer::transferBasis();
    for (std::size_t b = 0; b < kUp; ++b) {
      const det::ShBasis y = det::shBasis(basis[b]);
      for (std::size_t k = 0; k < kBands; ++k) open_[b][k] = det::cosineLobe(k == 0 ? 0 : 1) * y.v[k];
    }
    for (std::size_t u = 0; u < matrix.unknowns(); ++u) combine(u);
    for (std::size_t u = 0; u < matrix.unknowns(); ++u) traced_.push_back(visibility(u));
    start_ = x_;
    for (std::size_t u = 0; u < matrix.unknowns(); ++u)
      for (std::size_t i = 0; i < kColumns; ++i)
        for (std::size_t j = 0; j < kBands; ++j)
          wanted_[u * kColumns + i] += matrix.pull() * moments_[i / 3][j] * x_[u * kColumns + 3 * j + i % 3];
  }

  void add(const Row& row, const PointLight& light) {
    std::array<double, kColumns> mean{};
    const auto count = static_cast<double>(skies_.count());
    for (std::size_t i = 0; i < kColumns; ++i)
      for (std::size_t l = 0; l < skies_.count(); ++l)
        mean[i] += skies_.weight(l) * light.sky[l][static_cast<int>(i % 3)] * skies_.coefficient(l)[i / 3] / count;
    for (const Row::Entry& e : row.entry)
      for (std::size_t i = 0; i < kColumns; ++i) wanted_[e.unknown * kColumns + i] += row.weight * e.factor * mean[i];
  }

  void solve() {
    for (int sweep = 0; sweep < kSweeps; ++sweep)
      for (std::size_t u = 0; u < matrix_.unknowns(); ++u) {
        std::array<double, kColumns> others{};
        matrix_.addOthers(u, x_, kColumns, others);
        for (int round = 0; round < kRounds; ++round) {
          if (u % transfer::kDirections < kUp) moveVisibility(u, others);
          moveTransfer(u, others);
        }
      }
  }

 private:
  double& visibility(std::size_t u) {
    return probes_[u / transfer::kDirections]->visibility[u % transfer::kDirections];
  }
  double& transfer(std::size_t u, std::size_t i) {
    return probes_[u / transfer::kDirections]->sky[u % transfer::kDirections][i / 3][static_cast<int>(i % 3)];
  }

  void combine(std::size_t u) {
    for (std::size_t i = 0; i < kColumns; ++i)
      x_[u * kColumns + i] = transfer(u, i) + visibility(u) * open_[u % transfer::kDirections][i / 3];
  }

  /// Minus half of the gradient along one number of X.
  double gradient(std::size_t u, const std::array<double, kColumns>& others, std::size_t i) const {
    double g = wanted_[u * kColumns + i];
    for (std::size_t j = 0; j < kBands; ++j) {
      const std::size_t at = 3 * j + i % 3;
      g -= moments_[i / 3][j] * (others[at] + matrix_.diagonal(u) * x_[u * kColumns + at]);
    }
    const std::size_t at = u * kColumns + i;
    return g + kRidge * moments_[i / 3][i / 3] * matrix_.diagonal(u) * (start_[at] - x_[at]);
  }

  void moveVisibility(std::size_t u, const std::array<double, kColumns>& others) {
    const auto& open = open_[u % transfer::kDirections];
    double along = 0.0, curvature = 0.0;
    for (std::size_t i = 0; i < kColumns; ++i) along += open[i / 3] * gradient(u, others, i);
    for (std::size_t j = 0; j < kBands; ++j)
      for (std::size_t k = 0; k < kBands; ++k)
        curvature += 3.0 * matrix_.diagonal(u) * open[j] * moments_[j][k] * open[k];
    const double pull = kVisibilityPull * curvature;
    double& v = visibility(u);
    v = std::clamp(v + (along + pull * (traced_[u] - v)) / (curvature + pull), 0.0, 1.0);
    combine(u);
  }

  void moveTransfer(std::size_t u, const std::array<double, kColumns>& others) {
    for (std::size_t i = 0; i < kColumns; ++i) {
      double& t = transfer(u, i);
      t += gradient(u, others, i) / ((1.0 + kRidge) * moments_[i / 3][i / 3] * matrix_.diagonal(u));
      if (i / 3 < 2) t = std::max(t, 0.0);
      x_[u * kColumns + i] = t + visibility(u) * open_[u % transfer::kDirections][i / 3];
    }
  }

  const NormalMatrix& matrix_;
  const TrainingSkies& skies_;
  std::span<transfer::ProbeTransfer* const> probes_;
  Moments moments_;
  std::array<std::array<double, kBands>, transfer::kDirections> open_{};  ///< A_k Y_k(b)
  std::vector<double> x_, start_, wanted_;                                ///< [unknown][coefficient][channel]
  std::vector<double> traced_;                                            ///< visibility at the start
};

}  // namespace

void fitSky(const NormalMatrix& matrix, std::span<const Row> rows, std::span<const PointLight> light,
            const TrainingSkies& skies, std::span<transfer::ProbeTransfer* const> probes) {
  SkyFit fit(matrix, skies, probes);
  for (std::size_t i = 0; i < rows.size(); ++i) fit.add(rows[i], light[i]);
  fit.solve();
}

}  // namespace welkin::fit
