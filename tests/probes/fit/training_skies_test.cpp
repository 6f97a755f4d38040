// SPDX-License-Identifier: Apache-2.0
#include "probes/fit/training_skies.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "probes/geometry/directions.h"

namespace welkin::tests {
namespace {

/// Of 48 x 48 texels beside the integral, relative to the horizontal irradiance.
constexpr double kTexels = 0.003;

/// A path of the sun from the east over the south-west to the north-west, without symmetry.
std::vector<Number3> somePath() {
  std::vector<Number3> path;
  for (int i = 0; i < 12; ++i) {
    const double azimuth = 0.1 + 0.3 * i, elevation = 0.9 * std::sin(det::kPi * i / 11.0) - 0.1;
    path.emplace_back(std::cos(elevation) * std::cos(azimuth), std::sin(elevation),
                      std::cos(elevation) * std::sin(azimuth));
  }
  return path;
}

}  // namespace

using f64::Number3;

TEST_CASE("TrainingSkies, EachHasAHorizontalIrradianceOfOne") {
  for (const auto& path : {somePath(), std::vector<Number3>{}}) {
    const fit::TrainingSkies skies(path);
    REQUIRE(skies.count() >= 6);
    for (const double e : skies.irradiance({0, 1, 0})) CHECK(e == Approx(1.0).margin(1e-12));
    double weights = 0.0;
    for (std::size_t l = 0; l < skies.count(); ++l) weights += skies.weight(l);
    CHECK(weights == Approx(double(skies.count())));
  }
}

TEST_CASE("TrainingSkies, EvenAndOvercastSkiesHaveTheirClosedForms") {
  const fit::TrainingSkies skies(somePath());
  for (int i = 0; i < 50; ++i) {
    const Number3 n = geometry::sphereDirection((i + 0.5) / 50.0, std::fmod(0.618 * i, 1.0));
    const std::vector<double> e = skies.irradiance(n);
    CHECK(e[0] == Approx((1.0 + n.y) / 2.0).margin(kTexels));
  }
  // Radiance 1/pi: Y_0 integrates to sqrt(pi), Y_1 to sqrt(3 pi) / 2 over the upper hemisphere.
  CHECK(skies.coefficient(0)[0] == Approx(std::sqrt(det::kPi) / det::kPi).epsilon(kTexels));
  CHECK(skies.coefficient(0)[1] == Approx(std::sqrt(3.0 * det::kPi) / 2.0 / det::kPi).epsilon(kTexels));
  CHECK(skies.coefficient(0)[2] == Approx(0.0).margin(kTexels));
  // Moon and Spencer: (1 + 2 y) of horizontal irradiance pi + 4 pi / 3.
  const Number3 low(std::sqrt(1.0 - 0.3 * 0.3), 0.3, 0.0);
  CHECK(skies.radiance(low)[1] == Approx(1.6 / (det::kPi * 7.0 / 3.0)).epsilon(0.03));  // a texel's height
}

TEST_CASE("TrainingSkies, ClearSkiesAreBrightestAtTheirSuns") {
  const std::vector<Number3> path = somePath();
  const fit::TrainingSkies skies(path);
  constexpr std::size_t kFirst = 2, kByDay = 6;
  REQUIRE(skies.count() == kFirst + kByDay + 4);
  for (std::size_t l = kFirst; l < kFirst + kByDay; ++l) {
    double most = 0.0;
    for (const Number3& sun : path)
      if (sun.y > 0.05) most = std::max(most, skies.radiance(sun)[l] / skies.radiance({-sun.x, sun.y, -sun.z})[l]);
    CHECK(most > 3.0);
  }
}

TEST_CASE("TrainingSkies, RadianceSumsToTheIrradiance") {
  const fit::TrainingSkies skies(somePath());
  constexpr int kDirections = 200000;
  const Number3 normal = geometry::unit({0.4, 0.3, -0.8});
  std::vector<double> sum(skies.count(), 0.0);
  for (int i = 0; i < kDirections; ++i) {
    const Number3 d = geometry::sphereDirection((i + 0.5) / kDirections, std::fmod(0.6180339887498949 * i, 1.0));
    if (d.y <= 0.0) continue;
    const double weight = std::max(dot(d, normal), 0.0) * 4.0 * det::kPi / kDirections;
    for (std::size_t l = 0; l < sum.size(); ++l) sum[l] += weight * skies.radiance(d)[l];
  }
  const std::vector<double> e = skies.irradiance(normal);
  for (std::size_t l = 0; l < sum.size(); ++l) CHECK(sum[l] == Approx(e[l]).margin(2.0 * kTexels));
}

}  // namespace welkin::tests
