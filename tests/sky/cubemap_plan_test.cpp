// SPDX-License-Identifier: Apache-2.0
// Plans of cubemaps: closed forms, budgets that hold when measured fully from what is rendered, limits, determinism.
#include "sky/cubemap/cubemap_plan.h"

#include <tbb/global_control.h>

#include <catch2/catch.hpp>
#include <cmath>

#include "sky/bake/sky_file.h"
#include "sky/cubemap/cubemap_times.h"
#include "sky/cubemap/day_bends.h"
#include "sky/cubemap/dome_directions.h"
#include "tests/sky/some_skies.h"

namespace welkin::tests {

using det::Number3;
namespace {

using format::CubemapFormat;

model::Sky uniformSky(base::Curve intensity) {
  model::Sky sky;
  sky.luminance = *model::findLuminance("cie-5");
  sky.sun.path.key_time_h = {0.0};
  sky.sun.path.key_azimuth_rad = {0.4};
  sky.sun.path.key_elevation_rad = {0.7};
  sky.intensity = std::move(intensity);
  return sky;
}

void requireSound(const cubemap::CubemapPlan& plan, const cubemap::CubemapLimits& limits) {
  REQUIRE(plan.size >= 8);
  REQUIRE(plan.size <= limits.largest_size);
  REQUIRE((plan.size & (plan.size - 1)) == 0);
  REQUIRE(format::areKeyTimes(plan.time_h));
  REQUIRE(plan.time_h.size() <= limits.most_times);
  for (std::size_t i = 1; i < plan.time_h.size(); ++i)
    REQUIRE(cubemap::millisecondOf(plan.time_h[i]) > cubemap::millisecondOf(plan.time_h[i - 1]));
  REQUIRE(plan.bytes == 6.0 * plan.size * plan.size * static_cast<double>(format::texelBytes(plan.format)) *
                            static_cast<double>(plan.time_h.size()));
  REQUIRE(plan.bytes <= limits.most_bytes);
  REQUIRE(plan.reason.empty() == plan.met);
}

}  // namespace

TEST_CASE("DomeDay, ABlendIsAsFarFromTheDomeAsTheBlendedDomesAre") {
  const model::Sky sky = tests::someSkies()[1].sky;
  const cubemap::DomeDay day(sky);
  const cubemap::DomeScale scale(sky);
  const auto& time_h = day.time_h();
  const std::size_t n = time_h.size();
  const cubemap::DomeDirections even({768, 0, 0});
  // Short and long gaps, by day, by night, over midnight and around the whole day.
  for (const auto& [first, apart] :
       {std::pair(n / 2, std::size_t{30}), std::pair(n / 4, std::size_t{2}), std::pair(n - 20, std::size_t{60}),
        std::pair(n / 3, n / 2), std::pair(n / 5, n)}) {
    const std::size_t second = first + apart;
    const std::size_t at = first + std::max<std::size_t>(1, apart / 3);
    const auto hour = [&](std::size_t i) { return time_h[i % n] + 24.0 * static_cast<double>(i / n); };
    const double weight = (hour(at) - hour(first)) / (hour(second) - hour(first));
    const model::SkyInstant before(sky, time_h[first % n]);
    const model::SkyInstant after(sky, time_h[second % n]);
    const model::SkyInstant model(sky, time_h[at % n]);
    Number3 mean(0.0);
    Number3 square(0.0);
    for (const Number3& d : even.staying()) {
      const Number3 want = model.dome(d, Number3(0.0));
      const Number3 off = mix(before.dome(d, Number3(0.0)), after.dome(d, Number3(0.0)), weight) - want;
      mean += want * (1.0 / 768.0);
      square += off * off * (1.0 / 768.0);
    }
    double worst = 0.0;
    for (int c = 0; c < 3; ++c) worst = std::max(worst, std::sqrt(square[c]) / scale.of(mean, c));
    constexpr double kFloats = 1e-5;  // domes are held as floats, whose roundings a short blend shows most
    CAPTURE(first, apart, worst);
    CHECK(day.blendError(first, second, at) == Approx(worst).epsilon(kFloats).margin(1e-7));
    CHECK(day.blendError(first, second, at) == day.blendError(first, second, at));
  }
}

TEST_CASE("DomeRay, ShowsTheDomeToTheLastBit") {
  for (const tests::NamedSky& named : tests::someSkies()) {
    const model::IndicatrixTable table(named.sky.luminance.d);
    for (const double time_h : {5.5, 12.0, 23.0}) {
      const model::SkyInstant instant(named.sky, time_h);
      const cubemap::DomeDirections directions({64, 0, 64});
      for (const Number3& d : directions.staying()) {
        const model::DomeRay ray(named.sky.luminance, d);
        const Number3 exact = instant.chromaticity(d) * instant.luminance(d) * instant.intensity() *
                              named.sky.polarising_tint.colourAt(time_h);
        CHECK(instant.dome(ray, nullptr) == exact);
        const Number3 near = instant.dome(ray, &table);
        for (int c = 0; c < 3; ++c) CHECK(near[c] == Approx(exact[c]).epsilon(1e-7));
      }
    }
  }
}

TEST_CASE("CubemapPlan, ASkyThatDoesNotChangeGetsOneSmallCubemap") {
  const auto plan = cubemap::planCubemaps(uniformSky(base::Curve::constant(0.7)), 0.01);
  requireSound(plan, {});
  CHECK(plan.met);
  CHECK(plan.size == 8);
  CHECK(plan.time_h.size() == 1);
  CHECK(format::texelBytes(plan.format) == 4);
}

TEST_CASE("CubemapPlan, TimesAreTheKeysOfABrokenLine") {
  // Nothing but the four keys shows a uniform sky whose intensity bends there, and they show it exactly.
  const std::vector<double> keys = {3.25, 7.1, 12.0, 20.35};
  const auto plan = cubemap::planCubemaps(uniformSky({1, keys, {0.5, 3.0, 1.0, 2.0}}), 0.004);
  requireSound(plan, {});
  CHECK(plan.met);
  CHECK(plan.size == 8);
  REQUIRE(plan.time_h.size() == keys.size());
  for (std::size_t i = 0; i < keys.size(); ++i) CHECK(plan.time_h[i] == Approx(keys[i]).margin(1e-3));
}

TEST_CASE("CubemapPlan, BudgetsHoldMeasuredFullyFromWhatIsRendered", "[slow]") {
  constexpr double kFast = 0.05;     // of Effort::fast
  constexpr double kWasteful = 0.8;  // a plan spends its budget; a size is a power of two
  double budget = 0.2;
  for (const NamedSky& named : someSkies()) {
    const auto plan = cubemap::planCubemaps(named.sky, budget);
    requireSound(plan, {});
    std::vector<cubemap::Cubemap> cubemaps;
    cubemap::CubemapSet set{plan.size, plan.format, plan.time_h, {}};
    for (const double t : plan.time_h)
      cubemaps.push_back(cubemap::renderCubemap(model::SkyInstant(named.sky, t), Number3(0.1), plan.size, plan.format));
    for (const cubemap::Cubemap& c : cubemaps) set.texels.emplace_back(c.texels);
    const auto fast = cubemap::measureCubemaps(named.sky, set, cubemap::Effort::fast);
    const auto full = cubemap::measureCubemaps(named.sky, set, cubemap::Effort::full);
    CAPTURE(named.name, budget, plan.size, format::nameOf(plan.format), plan.time_h.size(), plan.predicted, fast.error,
            full.error);
    CHECK(plan.met);
    CHECK(fast.error == Approx(plan.measured.error).epsilon(1e-12));
    CHECK(fast.error <= budget);
    CHECK(full.error <= (1.0 + kFast) * budget);
    CHECK(full.error == Approx(fast.error).epsilon(kFast));
    CHECK(fast.error > kWasteful * budget);
    CHECK(plan.predicted < 1.2 * budget);
    budget = budget > 0.1 ? 0.06 : 0.2;
  }
}

TEST_CASE("CubemapPlan, ATighterBudgetCostsMore", "[slow]") {
  const model::Sky sky = someSkies()[3].sky;
  double bytes = 0.0;
  for (const double budget : {0.2, 0.05, 0.01}) {
    const auto plan = cubemap::planCubemaps(sky, budget);
    CHECK(plan.met);
    CHECK(plan.bytes > bytes);
    bytes = plan.bytes;
  }
}

TEST_CASE("CubemapPlan, FewerTimesThanEvenlySpacedOnes", "[slow]") {
  const NamedSky named = someSkies()[0];
  const auto plan = cubemap::planCubemaps(named.sky, 0.1);
  cubemap::CubemapSet even{plan.size, plan.format, {}, {}};
  for (std::size_t i = 0; i < 2 * plan.time_h.size(); ++i)
    even.time_h.push_back(12.0 * static_cast<double>(i) / static_cast<double>(plan.time_h.size()));
  CHECK(cubemap::measureCubemaps(named.sky, even, cubemap::Effort::fast).error > 1.2 * plan.measured.error);
}

TEST_CASE("CubemapPlan, LimitsGiveTheBestAndWhy", "[slow]") {
  const model::Sky sky = someSkies()[0].sky;
  const cubemap::CubemapLimits limits{16, 12, 1e5};
  const auto plan = cubemap::planCubemaps(sky, 0.001, limits);
  requireSound(plan, limits);
  CHECK_FALSE(plan.met);
  CHECK(plan.measured.error > 0.001);
  CHECK(plan.reason.find("16 texels") != std::string::npos);
  CHECK(plan.reason.find("12 times") != std::string::npos);
  const auto possible = cubemap::planCubemaps(sky, 1.2 * plan.measured.error, limits);
  requireSound(possible, limits);
  CHECK(possible.met);
}

/// The rounds of this sky end just past the budget, far below the bytes that may be had.
TEST_CASE("CubemapPlan, ABudgetThatTheLimitsAllowIsMet", "[slow]") {
  model::Sky sky;
  sky.luminance = *model::findLuminance("cie-15");
  sky.intensity = base::Curve::constant(1.0);
  sky.sun.path = model::sunPathFromPlace(52.0, 0.0, 0.0, 2012, 172);
  cubemap::CubemapLimits limits;
  limits.most_bytes = 64e6;
  const auto plan = cubemap::planCubemaps(sky, 0.03, limits);
  requireSound(plan, limits);
  INFO(plan.reason << "; " << plan.bytes << " bytes");
  CHECK(plan.met);
  CHECK(plan.measured.error <= 0.03);
  CHECK(plan.bytes < 8e6);
}

TEST_CASE("CubemapPlan, TheSameForAnyNumberOfThreads", "[slow]") {
  const model::Sky sky = someSkies()[2].sky;
  const auto many = cubemap::planCubemaps(sky, 0.2);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const auto single = cubemap::planCubemaps(sky, 0.2);
  CHECK(single.size == many.size);
  CHECK(single.format == many.format);
  CHECK(single.time_h == many.time_h);
  CHECK(single.measured.error == many.measured.error);
  CHECK(single.predicted == many.predicted);
}

}  // namespace welkin::tests
