// SPDX-License-Identifier: Apache-2.0
// A whole day of frames: the light follows the sky without a pop, whether all probes are relit in a frame or a few.
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/runtime/random_level.h"

namespace welkin::tests {
namespace {

using Lights = std::vector<std::array<float, 3>>;

/// Largest changes between frames of a day.
struct Steps {
  double largest = 0.0;         ///< of an irradiance
  double light = 0.0;           ///< the largest irradiance itself
  double at_h = 0.0;            ///< hour of the largest change
  std::uint32_t remaining = 0;  ///< most probes that waited after a frame
};

/// Plays a day in `frames` equal steps and relights `budget` probes in each. Looks up 24 points with two normals.
Steps playDay(const RandomLevel& baked, int frames, std::uint32_t budget) {
  OpenedLevel opened(baked);
  opened.relight(0.0);
  std::vector<std::array<float, 3>> position, normal;
  for (int i = 0; i < 24; ++i)
    for (const float up : {1.0F, -0.6F}) {
      const auto n = static_cast<float>(i);
      position.push_back({-60.0F + 7.0F * n, 1.0F + 2.0F * n, 5.0F + 2.3F * n});
      normal.push_back({up == 1.0F ? 0.0F : 0.8F, up, 0.0F});
    }
  const auto* at = reinterpret_cast<const float(*)[3]>(position.data());
  const auto* facing = reinterpret_cast<const float(*)[3]>(normal.data());
  Lights before(position.size()), now(position.size());
  const auto lookUp = [&](Lights& light) {
    REQUIRE(welkin_level_irradiance(opened.level, position.size(), at, facing,
                                    reinterpret_cast<float(*)[3]>(light.data()), nullptr) == WELKIN_OK);
  };
  lookUp(before);
  Steps steps;
  for (int i = 1; i <= frames; ++i) {
    const double time_h = 24.0 * (i % frames) / frames;
    const WelkinSkySample sample = opened.sampleAt(time_h);
    WelkinLevelLight light{};
    light.sample = &sample;
    light.sky = light.sun_bounce = light.local = 1.0F;
    WelkinRelight result{};
    REQUIRE(welkin_level_set_light(opened.level, &light) == WELKIN_OK);
    REQUIRE(welkin_level_relight(opened.level, budget, &result) == WELKIN_OK);
    steps.remaining = std::max(steps.remaining, result.remaining);
    lookUp(now);
    for (std::size_t p = 0; p < now.size(); ++p)
      for (std::size_t c = 0; c < 3; ++c) {
        steps.light = std::max(steps.light, double{now[p][c]});
        const double change = std::abs(double{now[p][c]} - double{before[p][c]});
        if (change <= steps.largest) continue;
        steps.largest = change;
        steps.at_h = time_h;
      }
    std::swap(before, now);
  }
  return steps;
}

TEST_CASE("LevelDay, ItsSlopeIsBoundedAndABudgetAddsNoPop") {
  constexpr int kFrames = 20000;
  for (const auto sun : {transfer::SunTransfer::sh, transfer::SunTransfer::directional}) {
    const RandomLevel baked(3, 40, sun == transfer::SunTransfer::directional ? 6 : 0, sun, false);
    const Steps coarse = playDay(baked, kFrames / 4, UINT32_MAX), exact = playDay(baked, kFrames, UINT32_MAX);
    INFO("coarse " << coarse.largest << " at " << coarse.at_h << " h, exact " << exact.largest << " at " << exact.at_h
                   << " h, of " << exact.light);
    CHECK(exact.light > 0.1);
    CHECK(exact.remaining == 0);
    // A slope gives a quarter of the change to frames of a quarter of the length. A jump would give all of it.
    CHECK(exact.largest < 0.3 * coarse.largest);
    // The steepest moment is the rise of a light: the visible share of a disc of 0.25 degrees grows by 2 / pi a radius,
    // and a light climbs by at most 15 degrees an hour. A tenth more is for the rest of the light.
    constexpr double kRise = 2.0 / 3.14159 * 15.0 * (24.0 / kFrames) / 0.25;
    CHECK(exact.largest < 1.1 * kRise * exact.light);
    // An eighth of the probes a frame: each probe gets the change of eight frames at once.
    const Steps eighth = playDay(baked, kFrames, 3 * 40 / 8);
    INFO("by a budget " << eighth.largest << " at " << eighth.at_h << " h");
    CHECK(eighth.remaining > 0);
    CHECK(eighth.largest < 9.0 * exact.largest);
  }
}

}  // namespace
}  // namespace welkin::tests
