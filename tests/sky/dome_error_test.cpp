// SPDX-License-Identifier: Apache-2.0
// The error of the analytic dome: the runtime's evaluation of a file against the baked model.
#include "sky/cubemap/dome_error.h"

#include <catch2/catch.hpp>
#include <welkin/welkin.hpp>

#include "sky/bake/encode.h"
#include "sky/cubemap/dome_directions.h"
#include "tests/sky/some_skies.h"

namespace welkin::tests {

using det::Number3;
namespace {

std::vector<std::byte> bakedFile(const model::Sky& sky, model::GradientFormat format) {
  bake::SkyFile file;
  file.sky = sky;
  file.settings = "{}";
  file.bake.key_time_h = {0.0};
  file.bake.cubemap_size = 0;
  file.bake.gradient_format = format;
  return bake::encodeSky(file, table::bakeDayTable(sky, 2, {0.0}, {}), {});
}

}  // namespace

TEST_CASE("DomeError, TheRuntimesDomeIsTheModelUpToFloat") {
  // docs/conventions.md states this bound, relative to a direction's largest channel. The sample holds the sun's
  // direction, the intensity, the tint and the normalising luminance as floats. Each is off by up to 6e-8 of itself,
  // and the direction by as many radians. exp(d theta), with d about -3, multiplies the latter. The result is a float.
  constexpr double kBound = 2.8e-7;
  const cubemap::DomeDirections directions({512, 256, 256});
  double worst = 0.0;
  const auto skies = someSkies();
  for (const NamedSky& named : skies) {
    const auto format = &named == &skies.back() ? model::GradientFormat::rgb9e5 : model::GradientFormat::rgb32f;
    const auto bytes = bakedFile(named.sky, format);
    model::Sky shown_sky = named.sky;
    shown_sky.gradient_sun = model::rounded(named.sky.gradient_sun, format);
    shown_sky.gradient_anti = model::rounded(named.sky.gradient_anti, format);
    welkin::Sky opened;
    REQUIRE(opened.open(bytes.data(), bytes.size()));
    for (int minute = 0; minute < 1440; minute += 13) {
      const model::SkyInstant instant(shown_sky, minute / 60.0);
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
  CHECK(worst > kBound / 1.3);
}

TEST_CASE("DomeError, OfOneColourIsItsRounding") {
  // 1, 1/2 and a blue between two codes of 2^-8, under an even luminance. The dome shows the colour divided by its
  // luminance.
  model::Sky sky;
  sky.luminance = *model::findLuminance("cie-5");
  sky.sun.path.key_time_h = {0.0};
  sky.sun.path.key_azimuth_rad = {0.4};
  sky.sun.path.key_elevation_rad = {0.7};
  const double blue = 0.25 + 0.4 * 0x1p-8;
  sky.gradient_sun = sky.gradient_anti = model::Gradient::constant({1.0, 0.5, blue});
  const auto error = cubemap::measureGradients(sky, model::GradientFormat::rgb9e5, cubemap::Effort::fast);
  const double y = 0.2126 + 0.7152 * 0.5 + 0.0722 * blue;
  const double rounded_y = 0.2126 + 0.7152 * 0.5 + 0.0722 * 0.25;
  // Blue contributes half of the luminance here, which is the divisor: both are 1 over y.
  CHECK(error.error == Approx(blue / y - 0.25 / rounded_y).epsilon(1e-4));  // the gradient's floats
  CHECK(error.channel == 2);
  CHECK(error.largest.error == Approx(error.error).epsilon(1e-9));
  CHECK(error.mean == Approx(error.error).epsilon(1e-9));
  CHECK(cubemap::measureGradients(sky, model::GradientFormat::rgb32f, cubemap::Effort::fast).error == 0.0);
}

TEST_CASE("DomeError, FastIsFullAndAGridThroughTheRuntime", "[slow]") {
  constexpr double kAgree = 0.05;
  for (const NamedSky& named : someSkies()) {
    const double fast =
        cubemap::measureGradients(named.sky, model::GradientFormat::rgb9e5, cubemap::Effort::fast).error;
    const double full =
        cubemap::measureGradients(named.sky, model::GradientFormat::rgb9e5, cubemap::Effort::full).error;
    const auto exact_bytes = bakedFile(named.sky, model::GradientFormat::rgb32f);
    const auto bytes = bakedFile(named.sky, model::GradientFormat::rgb9e5);
    CHECK(bytes.size() < exact_bytes.size());
    welkin::Sky exact;
    welkin::Sky opened;
    REQUIRE(exact.open(exact_bytes.data(), exact_bytes.size()));
    REQUIRE(opened.open(bytes.data(), bytes.size()));
    constexpr int kAzimuths = 48;
    constexpr int kHeights = 48;
    double worst = 0.0;
    for (int minute = 0; minute < 1440; minute += 10) {
      WelkinSkySample sample{};
      REQUIRE(exact.sample(minute / 60.0, sample));
      double square[3] = {};
      double mean[3] = {};
      for (int i = 0; i < kAzimuths * kHeights; ++i) {
        const double height = (i / kAzimuths + 0.5) / kHeights;
        const double turn = 2.0 * f64::kPi * (i % kAzimuths + 0.3) / kAzimuths;
        const double length = std::sqrt(1.0 - height * height);
        const float d[3] = {static_cast<float>(length * std::cos(turn)), static_cast<float>(height),
                            static_cast<float>(length * std::sin(turn))};
        float model[3];
        float shown[3];
        REQUIRE(welkin_dome_radiance(exact.get(), &sample, d, model) == WELKIN_OK);
        REQUIRE(welkin_dome_radiance(opened.get(), &sample, d, shown) == WELKIN_OK);
        for (int c = 0; c < 3; ++c) {
          const double difference = double{shown[c]} - double{model[c]};
          square[c] += difference * difference / (kAzimuths * kHeights);
          mean[c] += double{model[c]} / (kAzimuths * kHeights);
        }
      }
      const double luminance = 0.2126 * mean[0] + 0.7152 * mean[1] + 0.0722 * mean[2];
      for (int c = 0; c < 3; ++c) worst = std::max(worst, std::sqrt(square[c]) / std::max(mean[c], luminance));
    }
    CAPTURE(named.name, fast, full, worst);
    CHECK(fast == Approx(full).epsilon(kAgree));
    CHECK(worst == Approx(full).epsilon(kAgree));
    CHECK(full < 0.01);
  }
}

}  // namespace welkin::tests
