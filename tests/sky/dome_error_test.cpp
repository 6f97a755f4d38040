// SPDX-License-Identifier: Apache-2.0
// The error of the analytic dome: what the runtime evaluates from a file against the model that was baked.
#include <catch2/catch.hpp>
#include <welkin/welkin.hpp>

#include "sky/dome_directions.h"
#include "sky/encode.h"
#include "tests/sky/some_skies.h"

namespace welkin::sky {

TEST_CASE("DomeError, TheRuntimesDomeIsTheModelUpToFloat") {
  // docs/conventions.md states this bound, of a direction's largest channel. The sample hands over the sun's direction,
  // the intensity, the tint and the luminance that it divides by as floats: each is off by up to 6e-8 of itself, and
  // the direction by as many radians, which exp(d theta), d about -3, multiplies; the result is a float.
  constexpr double kBound = 2.8e-7;
  const DomeDirections directions({512, 256, 256});
  double worst = 0.0;
  for (const NamedSky& named : someSkies()) {
    SkyFile file;
    file.sky = named.sky;
    file.settings = "{}";
    file.bake.key_time_h = {0.0};
    file.bake.cubemap_size = 0;
    const auto bytes = encodeSky(file, bakeDayTable(named.sky, 2, {0.0}, [] { return true; }), {});
    welkin::Sky opened;
    REQUIRE(opened.open(bytes.data(), bytes.size()));
    for (int minute = 0; minute < 1440; minute += 13) {
      const SkyInstant instant(named.sky, minute / 60.0);
      WelkinSkySample sample{};
      REQUIRE(opened.sample(minute / 60.0, sample));
      for (const auto& [direction, solid_angle] : directions.around(instant.sunDirection())) {
        const float d[3] = {static_cast<float>(direction.x), static_cast<float>(direction.y),
                            static_cast<float>(direction.z)};
        float shown[3];
        REQUIRE(welkin_dome_radiance(opened.get(), &sample, d, shown) == WELKIN_OK);
        const Number3 model = instant.dome({double{d[0]}, double{d[1]}, double{d[2]}}, Number3(0.0));
        const double largest = std::max({model.x, model.y, model.z});
        for (int c = 0; c < 3; ++c) {
          const double error = std::abs(double{shown[c]} - model[c]) / largest;
          if (error > worst) worst = error;
          if (error > kBound) {
            CAPTURE(named.name, minute, direction.x, direction.y, direction.z, c, error);
            CHECK(error <= kBound);
          }
        }
      }
    }
  }
  CAPTURE(worst);
  CHECK(worst > kBound / 1.2);
}

}  // namespace welkin::sky
