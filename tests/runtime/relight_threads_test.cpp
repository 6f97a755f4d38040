// SPDX-License-Identifier: Apache-2.0
// Relighting by several threads and by each kind of vectors gives the same bits.
#include <hwy/targets.h>

#include <algorithm>
#include <atomic>
#include <catch2/catch.hpp>
#include <thread>
#include <vector>

#include "tests/runtime/random_level.h"

namespace welkin::tests {
namespace {

/// The colours of places about every sector.
std::vector<WelkinColours> coloursOf(const OpenedLevel& opened) {
  std::vector<WelkinColours> all;
  for (int i = 0; i < 4000; ++i) {
    const float place[1][3] = {{-63.5F + static_cast<float>(i % 127) * 2.5F, static_cast<float>(i % 11) * 5.0F,
                                0.5F + static_cast<float>(i % 63)}};
    REQUIRE(welkin_level_colours(opened.level, 1, place, &all.emplace_back(), nullptr) == WELKIN_OK);
  }
  return all;
}

bool isSameLight(const std::vector<WelkinColours>& a, const std::vector<WelkinColours>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const WelkinColours& x, const WelkinColours& y) {
    return std::equal(&x.irradiance[0][0], &x.irradiance[0][0] + 12, &y.irradiance[0][0]);
  });
}

}  // namespace

TEST_CASE("RelightThreads, RangesOfFourThreadsGiveTheSameBits") {
  constexpr std::uint32_t kThreads = 4;
  const RandomLevel baked(5, 251, 10, transfer::SunTransfer::directional, true);
  OpenedLevel alone(baked), shared(baked);
  for (int round = 0; round < 8; ++round) {
    const double time_h = 5.0 + 1.75 * round;
    const WelkinSkySample sample = alone.relight(time_h);
    WelkinLevelLight light{};
    light.sample = &sample;
    light.sky = light.sun_bounce = light.local = 1.0F;
    REQUIRE(welkin_level_set_light(shared.level, &light) == WELKIN_OK);
    std::uint32_t count = 0;
    REQUIRE(welkin_level_relight_begin(shared.level, UINT32_MAX, &count) == WELKIN_OK);
    REQUIRE(count == 5 * 251);
    // Ranges of 1 to 29 probes, each taken by the thread that comes first, across blocks and sectors.
    std::atomic<std::uint32_t> next = 0, failures = 0;
    const auto work = [&] {
      for (;;) {
        const std::uint32_t most = 1U + static_cast<std::uint32_t>(round) * 4U, first = next.fetch_add(most);
        if (first >= count) return;
        const std::uint32_t probes = std::min(most, count - first);
        if (welkin_level_relight_range(shared.level, first, probes) != WELKIN_OK) ++failures;
      }
    };
    std::vector<std::thread> threads;
    for (std::uint32_t t = 0; t < kThreads; ++t) threads.emplace_back(work);
    for (std::thread& thread : threads) thread.join();
    CHECK(failures == 0);
    WelkinRelight result{};
    REQUIRE(welkin_level_relight_end(shared.level, &result) == WELKIN_OK);
    CHECK((result.relit == count && result.remaining == 0));
    CHECK(isSameLight(coloursOf(alone), coloursOf(shared)));
  }
}

TEST_CASE("RelightThreads, EachKindOfVectorsGivesTheSameBits") {
  const RandomLevel baked(3, 131, 10, transfer::SunTransfer::directional, true);
  OpenedLevel best(baked);
  best.relight(9.25);
  const auto wanted = coloursOf(best);
  const auto targets = hwy::SupportedAndGeneratedTargets();
#if HWY_ARCH_X86
  CHECK(targets.size() > 1);
#endif
  for (const std::int64_t target : targets) {
    INFO("target " << hwy::TargetName(target));
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().DeInit();
    OpenedLevel opened(baked);
    opened.relight(9.25);
    CHECK(isSameLight(coloursOf(opened), wanted));
  }
  hwy::SetSupportedTargetsForTest(0);
  hwy::GetChosenTarget().DeInit();
}

}  // namespace welkin::tests
