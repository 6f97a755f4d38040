// SPDX-License-Identifier: Apache-2.0
// The lights that local transfer tests and keeps. It is linear, the same for any threads and order, and refuses bad
// settings.
#include "probes/transfer/local_lights.h"

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>

#include "local_helpers.h"
#include "probes/transfer/local_relight.h"
#include "probes/transfer/trace_transfer.h"
#include "sky/base/error.h"
#include "tests/probes/closed_forms/closed_forms.h"
#include "tests/probes/same_bits.h"

namespace welkin::tests {

using f64::Number3;
namespace {}  // namespace

TEST_CASE("LocalTransfer, FewTestsOfManyLightsAreUnbiased") {
  const geometry::Surfaces room = furnishedRoom();
  const geometry::Tracer tracer(room);
  std::vector<Number3> lights;
  for (int i = 0; i < 40; ++i) lights.push_back({-4.5 + 1.3 * (i % 4), 0.3 + 0.06 * i, -3.5 + 0.17 * i});
  const Number3 probe(-1.5, 1.5, 0.5);
  const transfer::LocalTransferTracer few(tracer, {512, 2, 3}, lights);
  const transfer::LocalTransferTracer every(tracer, {512, 2, 40}, lights);
  for (std::uint32_t l = 0; l < lights.size(); l += 3) {
    const auto part = [&](const transfer::LocalProbe& p) { return of(p, l).radiance[0].y; };
    const Measured a = measured(few, probe, 30, part);
    const Measured b = measured(every, probe, 30, part);
    CAPTURE(l);
    checkMeasured({a.mean - b.mean, std::hypot(a.standard_error, b.standard_error)}, 0.0);
  }
  // The number of rays is limited: 512 paths of two vertices with three tests each.
  CHECK(few.trace(probe, {0, 0}, 0).rays <= 512 * 2 * 4);
}

TEST_CASE("LocalTransfer, NothingComesFromAnotherRoom") {
  const geometry::Surfaces rooms = twoRooms({0.2, 0.5, 0.9}, false);
  const geometry::Tracer tracer(rooms);
  std::vector<Number3> lights;
  for (int i = 0; i < 150; ++i)
    for (const double side : {-1.0, 1.0}) {
      const double x = 0.02 + 3.9 * (i / 10) / 15.0;
      lights.push_back({side * x, 0.3 + 0.25 * (i % 10), -1.7 + 0.022 * i});
    }
  const std::vector<Number3> some(lights.begin(), lights.begin() + 40);
  const Number3 probe(-0.1, 1.4, 0.3);
  for (const auto& list : {some, lights}) {
    const transfer::LocalTransferTracer local(tracer, {1024, 3, 8}, list);
    const transfer::LocalProbe traced = local.trace(probe, {0, 0}, 7);
    CHECK(traced.transfer.size() == std::min(list.size() / 2, transfer::kMostLocalLights));
    for (const transfer::LocalTransfer& t : traced.transfer) CHECK(list[t.light].x < 0.0);
  }
}

TEST_CASE("LocalLights, InfluenceNeedsSomeOneToSeeTheLight") {
  const geometry::Surfaces rooms = twoRooms(Number3(0.5), false);
  const geometry::Tracer tracer(rooms);
  const Number3 probe(-2.1, 1.4, 0.3);
  std::vector<Number3> lights;
  for (int i = 0; i < 100; ++i) lights.push_back({(i % 2 == 0 ? -1.0 : 1.0) * (0.1 + 0.03 * i), 1.0 + 0.01 * i, -1.0});
  const transfer::CircleTable circle;
  std::vector<transfer::PathVertex> vertices;
  transfer::traceVertices(tracer, probe, transfer::PathPoints(circle, 5, 1), 0, 16, 1, vertices);
  REQUIRE(vertices.size() == 16);
  std::uint64_t rays = 0;
  // Sixteen tests for a hundred lights: for most, only the test from the probe tells anything.
  const auto influence = transfer::influenceOf(tracer, probe, vertices, lights, 1, 0.0, rays);
  CHECK(rays == 16 + 100);
  for (std::size_t i = 0; i < lights.size(); ++i) {
    CAPTURE(i, lights[i].x);
    if (lights[i].x < 0.0)
      CHECK(influence[i] > 0.0);
    else
      CHECK(influence[i] == 0.0);
  }
  CHECK(transfer::mostInfluential(std::vector{0.0, 2.0, 3.0, 2.0, 5.0}, 3) == std::vector<std::size_t>{1, 2, 4});
  CHECK(transfer::mostInfluential(std::vector{0.0, 2.0}, 3) == std::vector<std::size_t>{1});
}

TEST_CASE("LocalLights, InfluenceInTheOpenIsThatOfTheVertices") {
  const geometry::Surfaces sphere = sphereInside(3.0, 3, Number3(0.5));
  const geometry::Tracer tracer(sphere);
  const std::vector<Number3> lights = {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {-1, 0.5, 0}, {0.2, 0.1, -2.5}};
  const transfer::CircleTable circle;
  std::vector<transfer::PathVertex> vertices;
  const Number3 probe(0.5, 1, 0.3);
  transfer::traceVertices(tracer, probe, transfer::PathPoints(circle, 5, 2), 0, 64, 2, vertices);
  REQUIRE(vertices.size() == 128);
  for (std::size_t i = 0; i < vertices.size(); i += 2)  // otherwise the bounces of a path would test the same lights
    CHECK(vertices[i].draw != vertices[i + 1].draw);
  for (const std::size_t draws : {1U, 3U, 8U}) {
    std::uint64_t rays = 0;
    const auto influence = transfer::influenceOf(tracer, probe, vertices, lights, draws, 0.5, rays);
    for (std::size_t l = 0; l < lights.size(); ++l) {
      double expected = 0.0;  // nothing is in the way, so all tests pass
      for (const transfer::PathVertex& v : vertices)
        expected += 3.0 * v.reflected.x * transfer::unshadowedIrradiance(v.origin, v.normal, lights[l], 0.5);
      CHECK(influence[l] == Approx(expected));
    }
  }
}

TEST_CASE("LocalTransfer, TheMostInfluentialLightsAreKept") {
  const geometry::Surfaces room = furnishedRoom();
  const geometry::Tracer tracer(room);
  std::vector<Number3> lights;
  for (int i = 0; i < 120; ++i)  // outside the pillar
    lights.push_back({-4.8 + 0.4 * (i % 12), 0.2 + 0.35 * (i / 12), 3.7 - 0.057 * i});
  const Number3 probe(-1.5, 1.5, 0.5);
  const transfer::LocalTransferTracer all(tracer, {16384, 2, 16}, lights);
  std::vector<double> influence;
  for (const transfer::LocalTransfer& t : all.trace(probe, {0, 0}, 0).transfer) influence.push_back(t.influence());
  std::vector<double> sorted = influence;
  std::sort(sorted.rbegin(), sorted.rend());
  const double best = std::accumulate(sorted.begin(), sorted.begin() + 30, 0.0);
  transfer::LocalSettings settings{1024, 2, 8};
  settings.lights = 30;
  const transfer::LocalTransferTracer some(tracer, settings, lights);
  double kept = 0.0;
  for (std::size_t i = 1; i <= 20; ++i) {
    const transfer::LocalProbe traced = some.trace(probe, {0, 0}, i);
    CHECK(traced.transfer.size() == 30);
    for (const transfer::LocalTransfer& t : traced.transfer) kept += influence[t.light] / 20.0;
    CHECK(traced.rays <= 1024 * 2 * 9 * 9 / 8 + 120);
  }
  CAPTURE(kept, best);
  CHECK(kept > 0.95 * best);
}

TEST_CASE("LocalTransfer, IsLinear") {
  const Number3 probe(-1.5, 1.5, 0.5);
  const std::vector<Number3> lights = {{-3, 3, 1}, {3, 1, -2}, {0, 1, 3}};
  // One bounce is proportional to the albedo.
  geometry::Surfaces box;
  addBoxInside(box, {-5, 0, -4}, {5, 4, 4}, addMaterial(box, {0.25, 0.5, 1.0}));
  const geometry::Tracer tracer(box);
  const transfer::LocalProbe p = transfer::LocalTransferTracer(tracer, {256, 1, 2}, lights).trace(probe, {0, 0}, 0);
  REQUIRE(p.transfer.size() == 3);
  for (const transfer::LocalTransfer& t : p.transfer)
    for (const Number3& k : t.radiance) {
      CHECK(k.y == Approx(2.0 * k.x));
      CHECK(k.z == Approx(4.0 * k.x));
    }
  // Irradiance is linear in the lights' colours.
  const std::vector<Number3> a = {{1, 2, 3}, {0, 0, 0}, {0.5, 0, 4}};
  const std::vector<Number3> b = {{0, 1, 0}, {2, 7, 1}, {0, 0, 0}};
  std::vector<Number3> both;
  for (std::size_t l = 0; l < 3; ++l) both.push_back(a[l] * 2.0 + b[l]);
  const auto of_a = transfer::relitLocal(p.transfer, a);
  const auto of_b = transfer::relitLocal(p.transfer, b);
  const auto of_both = transfer::relitLocal(p.transfer, both);
  for (std::size_t d = 0; d < transfer::kDirections; ++d)
    for (int c = 0; c < 3; ++c) CHECK(of_both[d][c] == Approx(2.0 * of_a[d][c] + of_b[d][c]));
}

TEST_CASE("LocalTransfer, IsTheSameForAnyThreadsAndOrder") {
  const geometry::Surfaces room = furnishedRoom();
  const geometry::Tracer tracer(room);
  geometry::PlacedSector sector;
  sector.id = {-1, 0};
  std::vector<Number3> lights;
  for (int i = 0; i < 12; ++i) {
    sector.probe.push_back({{-4.5 + 0.4 * i, 0.8, 3.0 - 0.5 * i}});
    lights.push_back(sector.probe.back().position + Number3(0, 0.5, 0));
  }
  transfer::LocalSettings settings{128, 2, 3};
  settings.lights = 8;
  const transfer::LocalTransferTracer local(tracer, settings, lights);
  tbb::global_control control(tbb::global_control::max_allowed_parallelism, 4);
  std::vector<transfer::LocalProbe> four;
  tbb::task_arena(4).execute([&] { four = local.trace(sector); });
  for (std::size_t i = sector.probe.size(); i-- > 0;)
    CHECK(sameBits(four[i], local.trace(sector.probe[i].position, sector.id, i)));
  CHECK_FALSE(sameBits(four[0], local.trace(sector.probe[0].position, sector.id, 1)));
  for (const geometry::SectorId& other : {geometry::SectorId{0, 0}, {-1, -1}})
    CHECK_FALSE(sameBits(four[0], local.trace(sector.probe[0].position, other, 0)));
}

TEST_CASE("LocalTransfer, SettingsOutsideTheirRangeAreRefused") {
  const geometry::Surfaces nothing;
  const geometry::Tracer tracer(nothing);
  const auto refused = [&](const transfer::LocalSettings& s, std::vector<Number3> lights = {}) {
    CHECK_THROWS_AS(transfer::LocalTransferTracer(tracer, s, std::move(lights)), base::Error);
  };
  refused({100, 2, 8});
  refused({0, 2, 8});
  refused({1024, 0, 8});
  refused({1024, transfer::kMostBounces + 1, 8});
  refused({1024, 2, 0});
  refused({1024, 2, 8, 0});
  refused({1024, 2, 8, transfer::kMostLocalLights + 1});
  refused({1024, 2, 8, 1, -0.1});
  refused({1024, 2, 8, 1, 65.0});
  refused({1024, 2, 8, 1, 0.0, -0.1});
  refused({1024, 2, 8, 1, 0.0, 1.0});
  refused({1024, 2, 8, 1, 0.0, std::nan("")});
  refused({1024, 2, 8}, {{0, std::nan(""), 0}});
  CHECK(transfer::LocalTransferTracer(tracer, {}, {{0, 1, 0}}).trace({0, 0, 0}, {0, 0}, 0).transfer.empty());
  CHECK(transfer::LocalTransferTracer(tracer, {}, {}).trace({0, 0, 0}, {0, 0}, 0).rays == 0);
}

}  // namespace welkin::tests
