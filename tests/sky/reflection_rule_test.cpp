// SPDX-License-Identifier: Apache-2.0
// The rule by which the runtime averages the sky over a reflected lobe, against closed forms and the slow integral.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "materials.h"
#include "sh/spiral.h"
#include "sky/reflection/lobe.h"
#include "sky/reflection/lobe_reference.h"
#include "tests/sky/lobe_mean.h"
#include "tests/sky/some_skies.h"

namespace welkin::tests {
namespace {

using det::Number3;

/// The widest lobe of each number of panels, which asks most of them, and the narrowest of all.
constexpr double kPowers[] = {1.0, 10.1, 100.1, 1000.1, 4000.1, 8192.0};

}  // namespace

TEST_CASE("LobeRule, EvenLightStaysAndTheWeightsAreTheLobes") {
  for (const double m : kPowers)
    for (int i = 0; i < 20; ++i) {
      const f64::Number3 axis(sh::onSpiral(0.999 - 0.1 * i, i));
      CAPTURE(m, axis.y);
      const f64::Number3 light = lobeMean([](const f64::Number3&) { return f64::Number3(0.25, 1.0, 65504.0); },
                                          f64::Number3(0.25, 1.0, 65504.0), m, axis);
      REQUIRE(light.x == Approx(0.25).epsilon(1e-13));
      REQUIRE(light.z == Approx(65504.0).epsilon(1e-13));
      double total = 0.0;  // 6 of the weight's factors are left out, and pi: half of each panel
      const int panels = f64::lobePanelsOut(m);
      for (int k = 0; k < 8 * panels; ++k) total += f64::lobeCircle(m, axis, k, panels).weight;
      REQUIRE(total * 6.0 * f64::kPi / panels == Approx(reflection::lobeIntegral(m)).epsilon(3e-3));
    }
}

TEST_CASE("LobeRule, LightBelowTheHorizonIsTheGrounds") {
  const auto none = [](const f64::Number3& d) {
    CHECK(d.y > -1e-12);  // of rounding: the dome is asked above the horizon alone
    return f64::Number3(0.0);
  };
  const f64::Number3 ground(2.0), down(0.0, -1.0, 0.0), up(0.0, 1.0, 0.0), level(1.0, 0.0, 0.0);
  for (const double m : kPowers) {
    CHECK(lobeMean(none, ground, m, down).x == Approx(2.0));
    CHECK(lobeMean(none, ground, m, up).x == Approx(0.0).margin(1e-12));
    CHECK(lobeMean(none, ground, m, level).x == Approx(1.0).epsilon(1e-12));  // half of the lobe
  }
}

TEST_CASE("LobeRule, EverySkyIsWithinItsStatedError") {
  // docs/materials.md states 0.4 % of each component, dark ground included.
  for (const NamedSky& named : someSkies())
    for (const double time_h : {7.0, 12.0}) {
      const model::SkyInstant instant(named.sky, time_h);
      const Number3 ground = instant.radiance(Number3(0, 1, 0), Number3(0.0)) * 0.1;
      const reflection::Radiance dome = [&](const Number3& d) { return instant.radiance(d, ground); };
      for (const double m : kPowers)
        for (int i = 0; i < 24; ++i) {
          const Number3 axis = sh::onSpiral(0.99 - 0.0825 * i, i);
          const Number3 truth = reflection::lobeReference(dome, m, axis);
          const f64::Number3 mean = lobeMean(dome, f64::Number3(ground), m, f64::Number3(axis));
          CAPTURE(named.name, time_h, m, axis.y);
          for (int c = 0; c < 3; ++c) {
            if (truth[c] == 0.0) continue;
            REQUIRE(mean[c] == Approx(truth[c]).epsilon(4e-3));
          }
        }
    }
}

}  // namespace welkin::tests
