// SPDX-License-Identifier: Apache-2.0
#include "probes/transfer/sums.h"

#include <algorithm>
#include <cmath>

#include "sh/deterministic.h"

namespace welkin::transfer {
namespace {

struct RatioEstimate {
  double value = 0.0;
  double variance = 0.0;
};

/// Ratio estimates of one basis direction's irradiance.
class DirectionEstimator {
 public:
  DirectionEstimator(const TransferSums& sums, std::size_t b, double basis_y) {
    for (std::size_t h = 0; h < 2; ++h) {
      double total = 0.0;
      for (std::size_t r = 0; r < kReplicates; ++r) total += weight_[r][h] = sums[r][h].weight[b];
      const double integral = det::kPi * (h == 0 ? 1.0 + basis_y : 1.0 - basis_y) / 2.0;
      factor_[h] = total > 0.0 ? integral / total : 0.0;
    }
  }

  /// The estimate for summand(r, h), a replicate's sum of weights times radiance in one half.
  template <typename Summand>
  RatioEstimate of(const Summand& summand) const {
    std::array<std::array<double, 2>, kReplicates> value;
    std::array<double, 2> sum{};
    std::array<double, 2> weight{};
    for (std::size_t r = 0; r < kReplicates; ++r) {
      for (std::size_t h = 0; h < 2; ++h) {
        sum[h] += value[r][h] = summand(r, h);
        weight[h] += weight_[r][h];
      }
    }
    RatioEstimate result;
    result.value = factor_[0] * sum[0] + factor_[1] * sum[1];
    for (std::size_t r = 0; r < kReplicates; ++r) {
      double rest = 0.0;
      for (std::size_t h = 0; h < 2; ++h)
        if (weight[h] > 0.0) rest += factor_[h] * (value[r][h] - sum[h] / weight[h] * weight_[r][h]);
      result.variance += rest * rest;
    }
    result.variance *= double{kReplicates} / (kReplicates - 1);
    return result;
  }

 private:
  std::array<std::array<double, 2>, kReplicates> weight_{};
  std::array<double, 2> factor_{};
};

}  // namespace

TracedProbe summedUp(const TransferSums& sums, const Number3& plane_albedo, const std::vector<Number3>& light_direction,
                     const Number3& plane_radiance) {
  // Irradiance over pi of the plane, by coefficient of the distant light: the whole upper hemisphere, cosine-weighted.
  constexpr std::array<double, 4> kPlane{det::kShConstant, det::kShLinear * 2.0 / 3.0, 0.0, 0.0};
  const auto basis = transferBasis();
  double highest = 0.0;
  for (const Number3& light : light_direction) highest = std::max(highest, light.y);

  TracedProbe result;
  for (std::size_t b = 0; b < kDirections; ++b) {
    const DirectionEstimator estimator(sums, b, basis[b].y);
    const double open = estimator.of([&](std::size_t r, std::size_t h) { return sums[r][h].open[b]; }).value;
    const double unoccluded =
        estimator.of([&](std::size_t r, std::size_t h) { return h == 0 ? sums[r][h].weight[b] : 0.0; }).value;
    // Both use the same sum of weights and round alike, so an open probe gets exactly 1.
    result.transfer.visibility[b] = unoccluded > 0.0 ? open / unoccluded : 0.0;
    result.transfer.sun[b].resize(light_direction.size());
    for (int c = 0; c < 3; ++c) {
      const auto channel = static_cast<std::size_t>(c);
      const auto sky = [&](std::size_t k, std::size_t r, std::size_t h) {
        return sums[r][h].sky[k][b][channel] + sums[r][h].plane[b][channel] * plane_albedo[c] * kPlane[k];
      };
      for (std::size_t k = 0; k < 4; ++k)
        result.transfer.sky[b][k][c] = estimator.of([&](std::size_t r, std::size_t h) { return sky(k, r, h); }).value;
      result.transfer.emitted[b][c] =
          estimator
              .of([&](std::size_t r, std::size_t h) {
                return sums[r][h].emitted[b][channel] + sums[r][h].plane[b][channel] * plane_radiance[c];
              })
              .value;
      const RatioEstimate uniform = estimator.of(
          [&](std::size_t r, std::size_t h) { return sums[r][h].open[b] + sky(0, r, h) / det::kShConstant; });
      const double sky_error = std::sqrt(uniform.variance);
      result.effort.sky_error[b][c] = sky_error;
      result.effort.error = std::max(result.effort.error, kStudent * sky_error / det::kPi);
      for (std::size_t i = 0; i < light_direction.size(); ++i) {
        const double plane = plane_albedo[c] / det::kPi * std::max(light_direction[i].y, 0.0);
        const RatioEstimate light = estimator.of([&](std::size_t r, std::size_t h) {
          return sums[r][h].light[i][b][channel] + sums[r][h].plane[b][channel] * plane;
        });
        result.transfer.sun[b][i][c] = light.value;
        result.effort.sun_error[b] = std::max(result.effort.sun_error[b], std::sqrt(light.variance));
      }
    }
    if (highest > 0.0)
      result.effort.error = std::max(result.effort.error, kStudent * result.effort.sun_error[b] / highest);
  }
  return result;
}

}  // namespace welkin::transfer
