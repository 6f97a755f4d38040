// SPDX-License-Identifier: Apache-2.0
// The errors that the transfer states for itself. It is the same for any threads and order, and refuses bad settings.
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <catch2/catch.hpp>

#include "sky/base/error.h"
#include "tests/probes/closed_forms/closed_forms.h"
#include "tests/probes/same_bits.h"
#include "transfer_helpers.h"

namespace welkin::tests {

using base::Progress;

using f64::Number3;
namespace {

transfer::TransferSettings settingsWith(std::size_t rays) {
  transfer::TransferSettings settings;
  settings.rays = rays;
  for (int i = 0; i < 12; ++i) settings.light_directions.push_back(towards(1.5 + 0.25 * i, 0.1 + 0.1 * i));
  return settings;
}

}  // namespace

TEST_CASE("TransferEffort, IsTheSameForAnyThreadsAndOrder") {
  const geometry::Surfaces level = canyonOf(9, 7, {0.2, 0.4, 0.5}, {0.7, 0.3, 0.5});
  const geometry::Tracer tracer(level);
  const transfer::TransferTracer transfer(tracer, settingsWith(128));
  geometry::PlacedSector sector;
  sector.id = {-1, 0};
  for (int i = 0; i < 20; ++i) sector.probe.push_back({{-3.9 + 0.4 * i, 1.0, 3.0 * i}});
  tbb::global_control control(tbb::global_control::max_allowed_parallelism, 4);
  std::vector<transfer::TracedProbe> four;
  tbb::task_arena(4).execute([&] { four = transfer.trace(sector); });
  for (std::size_t i = sector.probe.size(); i-- > 0;)
    CHECK(sameBits(four[i], transfer.trace(sector.probe[i].position, sector.id, i)));
  // Another probe, and another sector, have other random numbers.
  CHECK_FALSE(sameBits(four[0], transfer.trace(sector.probe[0].position, sector.id, 1)));
  CHECK_FALSE(sameBits(four[0], transfer.trace(sector.probe[0].position, {0, -1}, 0)));
}

TEST_CASE("TransferEffort, StandardErrorsAreTheSpread") {
  const geometry::Surfaces level = wallTo(0.9, Number3(0.4), Number3(0.8));
  const geometry::Tracer tracer(level);
  const transfer::TransferTracer transfer(tracer, settingsWith(256));
  const Number3 at(0, 1, -8);
  constexpr std::size_t kCount = 100;
  // The variance of 100 probes is known to 14 %. Each probe's, from 8 replicates, is known to 53 %, and their mean to 5
  // %.
  constexpr double kRelative = 0.45;
  for (std::size_t b = 0; b < transfer::kDirections; ++b) {
    const auto spread =
        measured(transfer, at, kCount, [&](const transfer::TracedProbe& p) { return uniformSky(p.transfer, b); });
    const auto stated = measured(transfer, at, kCount, [&](const transfer::TracedProbe& p) {
      return p.effort.sky_error[b].y * p.effort.sky_error[b].y;
    });
    CHECK(stated.mean == Approx(spread.standard_error * spread.standard_error * kCount).epsilon(kRelative));
  }
}

TEST_CASE("TransferEffort, TracesUntilTheErrorIsMet") {
  transfer::TransferSettings settings = settingsWith(1U << 15);
  settings.max_error = 0.03;
  settings.ground_albedo = Number3(0.3);
  const geometry::Surfaces plain = groundOf(Number3(0.3));
  const geometry::Surfaces canyon = canyonOf(4, 3, Number3(0.3), Number3(0.8));
  const geometry::Tracer easy(plain);
  const geometry::Tracer hard(canyon);
  const transfer::TracedProbe open = transfer::TransferTracer(easy, settings).trace({0, 1, 0}, {0, 0}, 0);
  const transfer::TracedProbe narrow = transfer::TransferTracer(hard, settings).trace({0, 1, 0}, {0, 0}, 0);
  CHECK(open.effort.error <= settings.max_error);
  CHECK(narrow.effort.error <= settings.max_error);
  CHECK(open.effort.paths < narrow.effort.paths);
  CHECK(narrow.effort.paths < settings.rays);
  CHECK(narrow.effort.rays > narrow.effort.paths);
  // The rays do not suffice: all are spent, and the error says so.
  settings.rays = 256;
  const transfer::TracedProbe cut = transfer::TransferTracer(hard, settings).trace({0, 1, 0}, {0, 0}, 0);
  CHECK(cut.effort.paths == 256);
  CHECK(cut.effort.error > settings.max_error);
}

TEST_CASE("TransferEffort, TellsOfItsRaysAndEndsWithinAProbe") {
  const geometry::Surfaces level = canyonOf(9, 7, Number3(0.3), Number3(0.5));
  const geometry::Tracer tracer(level);
  for (const std::size_t rays : {std::size_t{1024}, std::size_t{1} << 16}) {
    transfer::TransferSettings settings = settingsWith(rays);
    std::size_t calls = 0;
    const Progress::Listener count = [&](const Progress::Stage&, Progress::Event event) {
      calls += event == Progress::Event::went_on ? 1 : 0;
      return true;
    };
    const Progress add(count);
    const transfer::TracedProbe probe = transfer::TransferTracer(tracer, settings).trace({0, 1, 0}, {0, 0}, 0, add);
    CHECK(add.done() == probe.effort.rays);
    CHECK(calls >= rays / 2048);
    CHECK(calls <= rays / 1024);
    CHECK(sameBits(probe, transfer::TransferTracer(tracer, settings).trace({0, 1, 0}, {0, 0}, 0)));
    settings.max_error = 1e-6;  // all rays are spent, in rounds
    const Progress rounds(count);
    const transfer::TracedProbe spent = transfer::TransferTracer(tracer, settings).trace({0, 1, 0}, {0, 0}, 0, rounds);
    CHECK(spent.effort.rays == rounds.done());
  }
  const transfer::TransferTracer endless(tracer, settingsWith(transfer::kMostRays));
  std::size_t calls = 0;
  const Progress third(
      [&](const Progress::Stage&, Progress::Event event) { return event != Progress::Event::went_on || ++calls < 3; });
  CHECK_THROWS_AS(endless.trace({0, 1, 0}, {0, 0}, 0, third), base::Error);
  CHECK(calls == 3);
}

TEST_CASE("TransferEffort, SettingsOutsideTheirRangeAreRefused") {
  const geometry::Surfaces level = groundOf(Number3(0.5));
  const geometry::Tracer tracer(level);
  const auto refused = [&](auto&& change) {
    transfer::TransferSettings settings;
    settings.light_directions = {Number3(0, 1, 0)};
    change(settings);
    CHECK_THROWS_AS(transfer::TransferTracer(tracer, settings), base::Error);
  };
  refused([](transfer::TransferSettings& s) { s.rays = 1001; });
  refused([](transfer::TransferSettings& s) { s.rays = 8; });
  refused([](transfer::TransferSettings& s) { s.bounces = -1; });
  refused([](transfer::TransferSettings& s) { s.bounces = transfer::kMostBounces + 1; });
  refused([](transfer::TransferSettings& s) { s.max_error = -0.1; });
  refused([](transfer::TransferSettings& s) { s.max_error = std::nan(""); });
  refused([](transfer::TransferSettings& s) { s.ground_albedo.y = 1.5; });
  refused([](transfer::TransferSettings& s) { s.light_rays = 0; });
  refused([](transfer::TransferSettings& s) { s.reach_m = -1.0; });
  refused([](transfer::TransferSettings& s) { s.reach_m = std::nan(""); });
  refused([](transfer::TransferSettings& s) { s.light_directions[0] = {0, 2, 0}; });
}

}  // namespace welkin::tests
