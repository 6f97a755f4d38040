// SPDX-License-Identifier: Apache-2.0
// The skies that a fit prepares probes for. Probes know a sky by the four coefficients of its first two bands alone, so
// the fit needs skies to learn from what a sky with such coefficients is like.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "sh/deterministic.h"

namespace welkin::fit {

using f64::Number3;

/// Grey skies of horizontal irradiance 1: a uniform one, an overcast one (Moon and Spencer 1942), and clear ones (type
/// 12 of CIE S 011/E:2003) with the sun along its path by day, and below the horizon where the path begins and ends.
/// Their radiance is constant within texels of an octahedral map of the upper hemisphere.
class TrainingSkies {
 public:
  /// `light_directions` as in transfer::TransferSettings. Without any above the horizon, suns stand low in four
  /// directions.
  explicit TrainingSkies(const std::vector<Number3>& light_directions);

  std::size_t count() const { return coefficient_.size(); }

  /// How much the fit heeds a sky, in means of all of them. Overcast skies weigh as much as all clear ones, so that
  /// light under an even sky is not traded for the clear skies' shape, which four coefficients do not hold anyway.
  double weight(std::size_t sky) const {
    constexpr std::size_t kEven = 2;
    return 0.5 * static_cast<double>(count()) / static_cast<double>(sky < kEven ? kEven : count() - kEven);
  }

  /// Projection of a sky on Y_k, upper hemisphere only.
  const std::array<double, 4>& coefficient(std::size_t sky) const { return coefficient_[sky]; }

  /// The radiance of every sky in a unit direction with y >= 0.
  std::span<const double> radiance(const Number3& direction) const;

  /// The irradiance of a surface by the whole of every sky, pi included.
  std::vector<double> irradiance(const Number3& normal) const;

 private:
  struct Texel {
    Number3 direction;
    double solid_angle;
  };
  template <typename Radiance>
  void add(const Radiance& radiance);
  void arrange();

  std::vector<Texel> texel_;
  std::vector<std::vector<double>> sky_;  ///< [sky][texel], until arrange()
  std::vector<double> radiance_;          ///< [texel][sky]
  std::vector<std::array<double, 4>> coefficient_;
};

}  // namespace welkin::fit
