// SPDX-License-Identifier: Apache-2.0
// The errors that local transfer states for itself, and the paths and rays that it takes.
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>

#include "local_helpers.h"
#include "probes/geometry/directions.h"
#include "probes/transfer/sums.h"
#include "tests/probes/closed_forms/closed_forms.h"

namespace welkin::tests {

using f64::Number3;
namespace {

const Number3 kProbe(-1.5, 1.5, 0.5);
const std::vector<Number3> kLights = {{-3, 3, 1}, {-1, 1, -3}, {-4, 3, 3}, {-2, 2, 2}};

transfer::LocalSettings within(double max_error, std::size_t most) {
  transfer::LocalSettings settings{most, 2, 2};
  settings.max_error = max_error;
  return settings;
}

}  // namespace

TEST_CASE("LocalEffort, IntervalsAreThoseOfTheSpread") {
  const geometry::Surfaces room = furnishedRoom();
  const geometry::Tracer tracer(room);
  const transfer::LocalTransferTracer local(tracer, {128, 2, 2}, kLights);
  constexpr std::size_t kTraced = 4000;
  std::vector<transfer::LocalProbe> probes;
  for (std::size_t i = 0; i < kTraced; ++i) probes.push_back(local.trace(kProbe, {0, 0}, i));
  for (std::uint32_t l = 0; l < kLights.size(); ++l) {
    double mean = 0.0;
    for (const transfer::LocalProbe& p : probes) mean += of(p, l).radiance[0].y / double{kTraced};
    double spread = 0.0;
    double stated = 0.0;
    double held = 0.0;
    for (const transfer::LocalProbe& p : probes) {
      REQUIRE(p.transfer.size() == kLights.size());
      const double off = p.transfer[l].radiance[0].y - mean;
      const double error = p.standard_error[l].y;
      spread += off * off / double{kTraced};
      stated += error * error / double{kTraced};
      if (std::abs(off) <= transfer::kStudent * error) held += 1.0 / double{kTraced};
    }
    // The variance of 4000 probes is known to 2.2 %. Each probe's own, from 8 replicates, is known to 53 %, and their
    // mean to 0.8 %. The tolerance is three standard errors. Dividing by eight replicates instead of seven degrees of
    // freedom would be 14 % off.
    CHECK(stated == Approx(spread).epsilon(0.07));
    // Nineteen of twenty intervals contain the truth, a share known to 0.3 %. With 1.96 for Student's 2.36 it would be
    // 91 %.
    CHECK(held == Approx(0.95).margin(0.02));
  }
}

TEST_CASE("LocalEffort, TheErrorIsThatOfTheInfluence") {
  const geometry::Surfaces room = furnishedRoom();
  const geometry::Tracer tracer(room);
  const transfer::LocalProbe p = transfer::LocalTransferTracer(tracer, {512, 2, 2}, kLights).trace(kProbe, {0, 0}, 0);
  double interval = 0.0;
  double influence = 0.0;
  for (std::size_t l = 0; l < p.transfer.size(); ++l) {
    for (int c = 0; c < 3; ++c) interval += 2.3646 * p.standard_error[l][c];  // from a printed table
    influence += p.transfer[l].influence();
  }
  REQUIRE(p.transfer.size() == 4);
  CHECK(p.error == Approx(interval / influence).epsilon(1e-4));
  CHECK(p.paths == 512);
}

TEST_CASE("LocalEffort, TracesUntilTheErrorIsMet") {
  const geometry::Surfaces room = furnishedRoom();
  const geometry::Tracer tracer(room);
  std::size_t paths = 0;
  for (const double budget : {0.2, 0.05, 0.02}) {
    const transfer::LocalProbe p =
        transfer::LocalTransferTracer(tracer, within(budget, 1U << 18), kLights).trace(kProbe, {0, 0}, 0);
    CHECK(p.error <= budget);
    CHECK(p.paths > paths);
    CHECK(p.paths < 1U << 18);
    paths = p.paths;
    // The bits equal those of as many paths at once; half as many would not be enough.
    const transfer::LocalProbe once =
        transfer::LocalTransferTracer(tracer, {p.paths, 2, 2}, kLights).trace(kProbe, {0, 0}, 0);
    REQUIRE(once.transfer.size() == p.transfer.size());
    CHECK(once.error == p.error);
    CHECK(once.rays == p.rays);
    for (std::size_t i = 0; i < p.transfer.size(); ++i)
      CHECK(std::memcmp(&once.transfer[i].radiance, &p.transfer[i].radiance, sizeof p.transfer[i].radiance) == 0);
    if (p.paths > 256)
      CHECK(transfer::LocalTransferTracer(tracer, {p.paths / 2, 2, 2}, kLights).trace(kProbe, {0, 0}, 0).error >
            budget);
  }
  // The rays do not suffice: all are spent, and the error says so.
  const transfer::LocalProbe cut =
      transfer::LocalTransferTracer(tracer, within(0.001, 1000), kLights).trace(kProbe, {0, 0}, 0);
  CHECK(cut.paths == 1000);
  CHECK(cut.error > 0.001);
  // Nothing arrives, so there is no error and only the first round.
  const transfer::LocalProbe dark =
      transfer::LocalTransferTracer(tracer, within(0.01, 1U << 18), {{90, 1, 0}}).trace(kProbe, {0, 0}, 0);
  CHECK(dark.transfer.empty());
  CHECK(dark.error == 0.0);
  CHECK(dark.paths == 256);
}

TEST_CASE("LocalEffort, TheClosedFormIsWithinTheBudget") {
  // A light at the centre of a sphere gives radiance wall / pi (albedo + albedo^2) from everywhere.
  const geometry::Surfaces sphere = sphereInside(3.0, 4, Number3(0.5));
  const geometry::Tracer tracer(sphere);
  const double roughness = roughnessOf(sphere, 3.0);
  std::vector<Number3> lights = {{0, 0, 0}, {1.5, 0.2, 0.3}, {-0.4, -1.9, 0.1}, {0.3, 0.3, 2}};
  const double expected = 4.0 * det::kShConstant * 0.75 / 9.0;
  const transfer::LocalTransferTracer local(tracer, within(0.05, 1U << 18), lights);
  std::size_t held = 0;
  for (std::size_t i = 0; i < 40; ++i) {
    const transfer::LocalProbe p = local.trace({0.7, 1.2, -0.9}, {0, 0}, i);
    CHECK(p.error <= 0.05);
    const double off = std::abs(of(p, 0).radiance[0].y - expected);
    if (off <= transfer::kStudent * p.standard_error[0].y + 3.0 * roughness * expected) ++held;
  }
  // 38 of 40 are expected; fewer than 33 has a chance of 1 in 300.
  CHECK(held >= 33);
}

TEST_CASE("LocalEffort, EveryRayIsCounted") {
  // In a sphere every surface point faces every light, and no path ends early. Each bounce takes one segment and then
  // the tests.
  const geometry::Surfaces sphere = sphereInside(3.0, 3, Number3(0.5));
  const geometry::Tracer tracer(sphere);
  const std::vector<Number3> lights = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0.5, 0}, {0.2, 0.1, -1}};
  transfer::LocalSettings settings{1024, 3, 8};
  const auto raysOf = [&] {
    return transfer::LocalTransferTracer(tracer, settings, lights).trace({0, 1, 1}, {0, 0}, 0);
  };
  CHECK(raysOf().rays == 1024 * 3 * (1 + 5));
  settings.light_rays = 1;
  CHECK(raysOf().rays == 1024 * 3 * (1 + 1));
  settings.lights = 5;  // all lights, so there is nothing to choose
  CHECK(raysOf().rays == 1024 * 3 * (1 + 1));
  // The choice takes a replicate's paths with every light tested, and one ray from the probe to each light.
  settings.light_rays = 8;
  settings.lights = 3;
  CHECK(raysOf().transfer.size() == 3);
  CHECK(raysOf().rays == 128 * 3 * (1 + 5) + 5 + 1024 * 3 * (1 + 3));
  settings.rays = 8192;
  CHECK(raysOf().rays == 1024 * 3 * (1 + 5) + 5 + 8192 * 3 * (1 + 3));
  // Under a budget the choice is as for 1024 paths, however many paths the measurement takes.
  settings.max_error = 0.3;
  for (const double budget : {0.3, 0.003}) {
    settings.max_error = budget;
    const transfer::LocalProbe p = raysOf();
    CHECK(p.rays == 128 * 3 * (1 + 5) + 5 + p.paths * 3 * (1 + 3));
    CHECK((p.paths > 1024) == (budget < 0.1));
  }
}

TEST_CASE("LocalEffort, TheChoiceIsOfPathsOfItsOwn") {
  // Paths favour the lights of which most arrived by them. Measured with the same paths, these lights would be too
  // bright.
  const geometry::Surfaces sphere = sphereInside(3.0, 3, Number3(0.5));
  const geometry::Tracer tracer(sphere);
  std::vector<Number3> lights;
  for (int i = 0; i < 60; ++i)
    lights.push_back(geometry::sphereDirection((i + 0.5) / 60.0, std::fmod(0.618 * i, 1.0)) * 2.6);
  const Number3 probe(0.0);
  const transfer::LocalTransferTracer all(tracer, {1U << 16, 1, 8}, lights);
  const transfer::LocalProbe truth = all.trace(probe, {0, 0}, 0);
  transfer::LocalSettings settings{64, 1, 8};
  settings.lights = 5;
  const transfer::LocalTransferTracer few(tracer, settings, lights);
  const Measured ratio = measured(few, probe, 3000, [&](const transfer::LocalProbe& p) {
    double sum = 0.0;
    double expected = 0.0;
    for (const transfer::LocalTransfer& t : p.transfer) {
      sum += t.influence();
      expected += of(truth, t.light).influence();
    }
    return sum / expected;
  });
  checkMeasured(ratio, 1.0, 0.01);
}

}  // namespace welkin::tests
