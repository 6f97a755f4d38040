// SPDX-License-Identifier: Apache-2.0
// The frame of the day's table against sh::Rotation.
#include "core/polar_frame.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <vector>

#include "sh/rotation.h"
#include "shared.h"

namespace welkin::tests {

TEST_CASE("PolarFrame, TurnsAsARotationDoes") {
  constexpr double kTolerance = 1e-13;  // sums of some fifty products of numbers below 1, in double
  std::mt19937 random(33);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  const core::PolarFrame frame;
  for (const std::size_t bands : {2U, 3U, 4U, 5U})
    for (const double azimuth_rad : {0.0, 0.4, -2.2, 3.1, M_PI_2}) {
      const det::Number3 towards(std::sin(azimuth_rad), 0.7, -std::cos(azimuth_rad));
      const core::Azimuth azimuth(f64::Number3(towards.x, towards.y, towards.z));
      std::vector<core::Channels> polar(bands * (bands + 1) / 2);
      for (auto& p : polar) p = {number(random), number(random), number(random), number(random)};
      std::vector<core::Channels> world(bands * bands);
      frame.toWorld(bands, polar, azimuth, world);
      // The frame's x points to the sun's azimuth and its z up; y completes it.
      const sh::Matrix3 axes = {det::Number3(towards.x, 0, towards.z), det::Number3(towards.z, 0, -towards.x),
                                det::Number3(0, 1, 0)};
      const sh::Rotation rotation(static_cast<int>(bands), axes);
      for (std::size_t c = 0; c < 4; ++c) {
        std::vector<double> all(bands * bands), turned(bands * bands);
        for (std::size_t l = 0; l < bands; ++l)
          for (std::size_t m = 0; m <= l; ++m) all[l * (l + 1) + m] = polar[l * (l + 1) / 2 + m][c];
        rotation.apply(all, turned);
        for (std::size_t i = 0; i < bands * bands; ++i) {
          CAPTURE(bands, azimuth_rad, i, c);
          CHECK(world[i][c] == Approx(turned[i]).margin(kTolerance).epsilon(0.0));
        }
      }
    }
  // A sun in the zenith has no azimuth. The frame's azimuth is then that of the world's +z, and nothing is NaN.
  const core::Azimuth none(f64::Number3(0.0, 1.0, 0.0));
  CHECK((none.cosine == 1.0 && none.sine == 0.0));
}

}  // namespace welkin::tests
