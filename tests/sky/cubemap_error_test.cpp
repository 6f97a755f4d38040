// SPDX-License-Identifier: Apache-2.0
// The error of cubemaps: closed forms, the fast measure against the full one, and the full one against a plain grid of
// directions and times through the runtime.
#include "sky/cubemap/cubemap_error.h"

#include <tbb/global_control.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <welkin/welkin.hpp>

#include "sky/bake/encode.h"
#include "tests/sky/some_skies.h"

namespace welkin::tests {

using det::Number3;
namespace {

using format::CubemapFormat;

/// Cubemaps rendered as a bake does.
struct Rendered {
  std::vector<cubemap::Cubemap> cubemap;
  cubemap::CubemapSet set;

  Rendered(const model::Sky& sky, int size, CubemapFormat format, const std::vector<double>& time_h)
      : set{size, format, time_h, {}} {
    for (const double t : time_h)
      cubemap.push_back(cubemap::renderCubemap(model::SkyInstant(sky, t), Number3(0.3), size, format));
    for (const cubemap::Cubemap& c : cubemap) set.texels.emplace_back(c.texels);
  }
};

/// The error by its definition, through the runtime: an even grid of azimuths and heights, `instants` a day.
cubemap::CubemapError denseCheck(const model::Sky& sky, const Rendered& rendered, int azimuths, int heights,
                                 int instants) {
  bake::SkyFile file;
  file.sky = sky;
  file.settings = "{}";
  file.bake.key_time_h = {0.0};
  file.bake.cubemap_size = rendered.set.size;
  file.bake.cubemap_time_h = rendered.set.time_h;
  const auto bytes = bake::encodeSky(file, table::bakeDayTable(sky, 2, {0.0}, {}), rendered.cubemap);
  welkin::Sky opened;
  REQUIRE(opened.open(bytes.data(), bytes.size()));
  struct AtTime {
    double square[3] = {};
    double mean[3] = {};
    double largest[3] = {};
  };
  std::vector<AtTime> at(static_cast<std::size_t>(instants));
  double brightest = 0.0;
  for (int i = 0; i < instants; ++i) {
    AtTime& sum = at[static_cast<std::size_t>(i)];
    WelkinSkySample sample{};
    REQUIRE(opened.sample(24.0 * i / instants, sample));
    WelkinCubemap cube[2];
    for (std::size_t k = 0; k < 2; ++k)
      REQUIRE(welkin_sky_cubemap(opened.get(), sample.cubemap[k], &cube[k]) == WELKIN_OK);
    int compared = 0;
    for (int row = 0; row < heights; ++row)
      for (int column = 0; column < azimuths; ++column) {
        const double height = (row + 0.5) / heights;
        const double turn = 2.0 * f64::kPi * (column + 0.37) / azimuths;
        const double length = std::sqrt(1.0 - height * height);
        const float d[3] = {static_cast<float>(length * std::sin(turn)), static_cast<float>(height),
                            static_cast<float>(length * std::cos(turn))};
        float model[3];
        REQUIRE(welkin_dome_radiance(opened.get(), &sample, d, model) == WELKIN_OK);
        const Number3 direction{double{d[0]}, double{d[1]}, double{d[2]}};
        Number3 shown[2];
        for (std::size_t k = 0; k < 2; ++k)
          shown[k] = cubemap::filterTexels(static_cast<const unsigned char*>(cube[k].texels),
                                           static_cast<CubemapFormat>(cube[k].format),
                                           cubemap::footprintOf(static_cast<int>(cube[k].size), direction));
        const bool clear = height / std::max(std::abs(direction.x), std::abs(direction.z)) >= 2.0 / rendered.set.size;
        if (clear) ++compared;
        const double w = double{sample.cubemap_weight};
        for (int c = 0; c < 3; ++c) {
          sum.mean[c] += double{model[c]} / (heights * azimuths);
          if (!clear) continue;
          const double difference = (1.0 - w) * shown[0][c] + w * shown[1][c] - double{model[c]};
          sum.square[c] += difference * difference;
          sum.largest[c] = std::max(sum.largest[c], std::abs(difference));
        }
      }
    for (double& square : sum.square) square /= compared;
    brightest = std::max(brightest, 0.2126 * sum.mean[0] + 0.7152 * sum.mean[1] + 0.0722 * sum.mean[2]);
  }
  cubemap::CubemapError result;
  for (int i = 0; i < instants; ++i) {
    const AtTime& sum = at[static_cast<std::size_t>(i)];
    const double luminance = 0.2126 * sum.mean[0] + 0.7152 * sum.mean[1] + 0.0722 * sum.mean[2];
    double worst = 0.0;
    for (int c = 0; c < 3; ++c) {
      const double scale = std::max({sum.mean[c], luminance, 1e-4 * brightest});
      const double error = std::sqrt(sum.square[c]) / scale;
      worst = std::max(worst, error);
      if (error > result.error) result.error = error, result.time_h = 24.0 * i / instants, result.channel = c;
      result.largest.error = std::max(result.largest.error, sum.largest[c] / scale);
    }
    result.mean += worst / instants;
  }
  return result;
}

model::Sky uniformSky() {
  model::Sky sky;
  sky.luminance = *model::findLuminance("cie-5");
  sky.sun.path.key_time_h = {0.0};
  sky.sun.path.key_azimuth_rad = {0.4};
  sky.sun.path.key_elevation_rad = {0.7};
  return sky;
}

}  // namespace

TEST_CASE("CubemapError, OfANightIsOverAShareOfTheDay") {
  // At 6 h the cubemaps of 0 and 12 h show half the noon, and the sky has a millionth of it: less than the floor.
  model::Sky sky = uniformSky();
  sky.intensity = {1, {6.0, 12.0, 18.0}, {1e-6, 1.0, 1e-6}};
  const auto error = cubemap::measureCubemaps(sky, {8, CubemapFormat::rgba16f, {0.0, 12.0}, {}}, cubemap::Effort::fast);
  constexpr double kHalf = 1e-3;  // 1e-6 in half floats
  CHECK(error.error == Approx(0.5 / 1e-4).epsilon(kHalf));
  CHECK((error.time_h == 6.0 || error.time_h == 18.0));
}

TEST_CASE("CubemapError, OfAUniformSkyIsTheBlendsAndTheRoundings") {
  model::Sky sky = uniformSky();
  sky.intensity = {1, {0.0, 6.0}, {1.0, 2.0}};  // shown by cubemaps at 0 and 12 h of 1 and 5/3
  const cubemap::CubemapSet set{16, CubemapFormat::rgba16f, {0.0, 12.0}, {}};
  const auto blended = cubemap::measureCubemaps(sky, set, cubemap::Effort::fast);
  const double half = static_cast<double>(0x1p-11);
  CHECK(blended.error == Approx((2.0 - 4.0 / 3.0) / 2.0).epsilon(half));
  CHECK(blended.time_h == 6.0);
  CHECK(blended.parts.time == Approx((2.0 - 4.0 / 3.0) / 2.0).epsilon(1e-9));
  CHECK(blended.parts.resolution < 1e-12);
  CHECK(blended.largest.error == Approx(blended.error).epsilon(1e-9));
  // Linear between the keys at 0 and 6 h, and between 6 and 24 h: cubemaps there leave the rounding.
  const auto exact = cubemap::measureCubemaps(sky, {16, CubemapFormat::rgba16f, {0.0, 6.0}, {}}, cubemap::Effort::fast);
  CHECK(exact.error < 1e-12);
  // Quantities between two codes: 1 + 2^-10 lies on a code of half floats, not of the others.
  sky.intensity = base::Curve::constant(1.0 + 0x1p-10);
  const double relative = 0x1p-10 / (1.0 + 0x1p-10);
  CHECK(cubemap::measureCubemaps(sky, {8, CubemapFormat::rgba16f, {3.0}, {}}, cubemap::Effort::fast).error < 1e-12);
  for (const auto format : {CubemapFormat::rgb9e5, CubemapFormat::b10g11r11}) {
    const auto rounded = cubemap::measureCubemaps(sky, {8, format, {3.0}, {}}, cubemap::Effort::fast);
    CHECK(rounded.error == Approx(relative).epsilon(1e-9));
    CHECK(rounded.parts.encoding == Approx(relative).epsilon(1e-9));
    CHECK(rounded.mean == Approx(relative).epsilon(1e-9));
    CHECK(rounded.parts.time == 0.0);
  }
}

TEST_CASE("CubemapError, DarkInstantsAreDividedByTheFloor") {
  model::Sky sky = uniformSky();
  sky.intensity = {1, {0.0, 1.0, 12.0, 23.0}, {1e-6, 1e-6, 1.0, 1e-6}};
  // At 0 h the cubemap of 23 h is exact; one of twice the night's radiance is off by 1e-6 of a floor of 1e-4.
  model::Sky brighter = sky;
  brighter.intensity.value = {2e-6, 2e-6, 1.0, 2e-6};
  const Rendered rendered(brighter, 8, CubemapFormat::rgba16f, {0.0, 1.0, 12.0, 23.0});
  CHECK(cubemap::measureCubemaps(sky, rendered.set, cubemap::Effort::fast).error ==
        Approx(0.01).epsilon(0.04));  // codes of 2^-24
}

TEST_CASE("CubemapError, OfTexelsNotRenderedIsThatOfTheFilesBytes") {
  const model::Sky sky = someSkies()[1].sky;
  for (const auto format : {CubemapFormat::rgba16f, CubemapFormat::rgb9e5, CubemapFormat::b10g11r11}) {
    const Rendered rendered(sky, 12, format, {5.0, 6.5, 13.0, 18.5});
    cubemap::CubemapSet absent = rendered.set;
    absent.texels.clear();
    const auto a = cubemap::measureCubemaps(sky, rendered.set, cubemap::Effort::fast);
    const auto b = cubemap::measureCubemaps(sky, absent, cubemap::Effort::fast);
    CHECK(a.error == Approx(b.error).epsilon(1e-12));
    CHECK(a.largest.error == Approx(b.largest.error).epsilon(1e-12));
    CHECK(a.mean == Approx(b.mean).epsilon(1e-12));
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    CHECK(cubemap::measureCubemaps(sky, rendered.set, cubemap::Effort::fast).error == a.error);
  }
}

TEST_CASE("CubemapError, FastIsWithinFivePercentOfFull", "[slow]") {
  constexpr double kFast = 0.05;  // Bound of Effort::fast.
  double worst = 0.0;
  int size = 16;
  for (const NamedSky& named : someSkies()) {
    const cubemap::CubemapSet set{size, CubemapFormat::rgba16f, named.time_h, {}};
    const double fast = cubemap::measureCubemaps(named.sky, set, cubemap::Effort::fast).error;
    const double full = cubemap::measureCubemaps(named.sky, set, cubemap::Effort::full).error;
    CAPTURE(named.name, size, fast, full);
    CHECK(fast == Approx(full).epsilon(kFast));
    worst = std::max(worst, std::abs(fast / full - 1.0));
    size *= 2;
  }
  WARN("fast against full: " << worst);
}

TEST_CASE("CubemapError, FullIsADenseGridThroughTheRuntime", "[slow]") {
  constexpr double kGrid = 0.05;
  constexpr int kSize = 20;  // texels of 5 degrees: the grid has several in each
  for (const NamedSky& named : someSkies()) {
    const Rendered rendered(named.sky, kSize, CubemapFormat::b10g11r11, named.time_h);
    const auto dense = denseCheck(named.sky, rendered, 180, 100, 192);
    const auto full = cubemap::measureCubemaps(named.sky, rendered.set, cubemap::Effort::full);
    CAPTURE(named.name, dense.error, dense.time_h, full.error, full.time_h, full.largest.error);
    CHECK(full.error == Approx(dense.error).epsilon(kGrid));
    CHECK(full.mean == Approx(dense.mean).epsilon(0.1));
    CHECK(full.largest.error > 0.9 * dense.largest.error);
    CHECK(full.channel == dense.channel);
  }
}

TEST_CASE("CubemapError, PartsAddUpInSquares") {
  // Case in which no part hides another. At the whole's own instant the parts may be smaller, so their sum bounds it.
  for (const NamedSky& named : someSkies()) {
    const auto e =
        cubemap::measureCubemaps(named.sky, {32, CubemapFormat::b10g11r11, named.time_h, {}}, cubemap::Effort::fast);
    const double sum = std::sqrt(e.parts.resolution * e.parts.resolution + e.parts.time * e.parts.time +
                                 e.parts.encoding * e.parts.encoding);
    CAPTURE(named.name, e.error, sum, e.parts.resolution, e.parts.time, e.parts.encoding);
    CHECK(e.error < 1.1 * sum);
    CHECK(e.error > 0.5 * sum);
  }
}

TEST_CASE("DomeDirections, IntegrateTheHemisphere") {
  // 1, the height and its square: 2 pi, pi, 2 pi/3; and a lobe of one degree about the sun, exp(-(chord/w)^2): pi w^2.
  const cubemap::DomeDirections directions({1536, 768, 768});
  for (const double elevation : {0.7, 0.1, 1.5, -0.3}) {
    const Number3 sun = det::directionOf(0.8, elevation);
    double moment[4] = {};
    constexpr double kWidth = 0.0175;
    for (const auto& [d, solid_angle] : directions.around(sun)) {
      REQUIRE(dot(d, d) == Approx(1.0).epsilon(1e-12));
      REQUIRE(d.y > 0.0);
      const Number3 away = d - sun;
      moment[0] += solid_angle;
      moment[1] += solid_angle * d.y;
      moment[2] += solid_angle * d.y * d.y;
      moment[3] += solid_angle * std::exp(-dot(away, away) / (kWidth * kWidth));
    }
    CAPTURE(elevation);
    CHECK(moment[0] == Approx(2.0 * f64::kPi).epsilon(0.005));
    CHECK(moment[1] == Approx(f64::kPi).epsilon(0.005));
    CHECK(moment[2] == Approx(2.0 * f64::kPi / 3.0).epsilon(0.005));
    if (elevation > 0.05) CHECK(moment[3] == Approx(f64::kPi * kWidth * kWidth).epsilon(0.02));
  }
}

TEST_CASE("DomeDirections, NoDirectionStandsForACuspAlone") {
  // A sun that one of the even directions hits: a lobe of a thousandth of a radian is still no more than its integral.
  const cubemap::DomeDirections directions({1536, 768, 768});
  constexpr double kWidth = 1e-3;
  for (const std::size_t hit : {700U, 1100U, 1300U}) {
    double lobe = 0.0;
    for (const auto& [d, solid_angle] : directions.around(directions.staying()[hit])) {
      const Number3 away = d - directions.staying()[hit];
      lobe += solid_angle * std::exp(-dot(away, away) / (kWidth * kWidth));
    }
    CHECK(lobe == Approx(f64::kPi * kWidth * kWidth).epsilon(0.3));  // 2.5e-7 sr of it are the nearest of the crowd's
  }
}

}  // namespace welkin::tests
