// SPDX-License-Identifier: Apache-2.0
#include "calibrate/uneven_light.h"

#include <algorithm>
#include <cmath>

#include "calibrate/curve_models.h"
#include "calibrate/levenberg.h"

namespace welkin::calibrate {
namespace {

LightGradient limited(const Eigen::VectorXd& unknowns) {
  return {std::clamp(unknowns[0], -kMostGradient, kMostGradient),
          std::clamp(unknowns[1], -kMostGradient, kMostGradient)};
}

}  // namespace

double LightGradient::at(std::size_t patch) const {
  const auto middle = [](std::size_t i, double size) {
    return (kRim + kPatchStep * static_cast<double>(i) + 0.5 * kPatchSide) / size - 0.5;
  };
  return std::exp(along * middle(patch % kColumns, kChartWidth) + down * middle(patch / kColumns, kChartHeight));
}

LightGradient gradientOf(const Patches& patches, const ReferenceChart& reference,
                         const std::vector<std::size_t>& used) {
  const auto residuals = [&](const Eigen::VectorXd& unknowns) {
    const std::vector<Pair> pairs = pairsOf(withoutGradient(patches, limited(unknowns)), reference, used);
    Eigen::VectorXd left = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(3 * pairs.size()));
    const auto numbers = fitCurveAffine(pairs);
    if (!numbers) return left;
    for (std::size_t i = 0; i < pairs.size(); ++i)
      left.segment<3>(static_cast<Eigen::Index>(3 * i)) =
          labOfRgb(applyCurveAffine(*numbers, pairs[i].measured)) - labOfRgb(pairs[i].wanted);
    return left;
  };
  // Each fit stops a little short, so the slope is taken over a step well above that.
  constexpr double kStep = 0.02;
  return limited(leastSquaresFrom(Eigen::VectorXd::Zero(2), residuals, kStep));
}

Patches withoutGradient(Patches patches, const LightGradient& gradient) {
  for (std::size_t i = 0; i < kPatches; ++i) {
    const double light = gradient.at(i);
    patches[i].mean /= light;
    patches[i].spread /= light;
  }
  return patches;
}

}  // namespace welkin::calibrate
