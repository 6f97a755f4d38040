// SPDX-License-Identifier: Apache-2.0
// A probe sees the level within its own reach. Neither the level beyond nor the probe's sector changes it.
#include <catch2/catch.hpp>

#include "probes/geometry/reach.h"
#include "tests/probes/closed_forms/closed_forms.h"
#include "tests/probes/same_bits.h"
#include "tests/probes/transfer/transfer_helpers.h"

namespace welkin::tests {
namespace {

constexpr double kReach_m = 64.0;

/// A sun's whole path and, as the last direction, one low in the west.
transfer::TransferSettings settingsWithin(double reach_m) {
  transfer::TransferSettings settings;
  settings.rays = 512;
  settings.reach_m = reach_m;
  settings.ground_albedo = {0.2, 0.1, 0.3};
  for (int i = 0; i < 12; ++i) settings.light_directions.push_back(towards(1.5 + 0.25 * i, 0.1 + 0.1 * i));
  settings.light_directions.push_back(towards(1.5 * det::kPi, 0.15));
  return settings;
}

/// The part of a level that a sector's bake reads.
geometry::Surfaces readBy(geometry::SectorId sector, const geometry::Surfaces& level) {
  return geometry::withTexels(geometry::surfacesWithin(level, geometry::columnOf(sector, kReach_m)), level);
}

/// Ground with a house near x = 64. Out of the house's sight at x = -60 to -40 is a ridge of 60 m that emits.
geometry::Surfaces ridge() {
  geometry::Surfaces s = groundOf({0.4, 0.5, 0.3}, 400.0);
  addBoxOutside(s, {70, 0, 20}, {75, 6, 33}, addMaterial(s, {0.7, 0.2, 0.1}));
  addBoxOutside(s, {-60, -1, -300}, {-40, 60, 300}, addMaterial(s, {0.8, 0.8, 0.6}, false, {1.0, 2.0, 3.0}));
  return s;
}

/// Ground in the square of kReach_m about (10, 20), with walls inside, across and beyond its edges and its corner.
geometry::Surfaces walls(bool beyond) {
  geometry::Surfaces s = groundOf({0.4, 0.5, 0.3}, 90.0);
  const auto wall = addMaterial(s, {0.7, 0.2, 0.1}, true);
  addQuad(s, {30, 0, 10}, {0, 0, 15}, {0, 12, 0}, wall);
  addQuad(s, {70, 0, 80}, {3, 0, 0}, {0, 40, 0}, wall);  // in the corner, 84 m away
  if (!beyond) return s;
  addQuad(s, {75, 0, -100}, {0, 0, 250}, {0, 80, 0}, wall);
  addQuad(s, {-55, 0, -100}, {0, 0, 250}, {0, 60, 0}, wall);
  addQuad(s, {-100, 0, 84.5}, {250, 0, 0}, {0, 50, 0}, wall);
  addQuad(s, {-100, 0, -45}, {250, 0, 0}, {0, 70, 0}, wall);
  return s;
}

}  // namespace

TEST_CASE("ProbeReach, AProbeIsTheSameFromBothSidesOfABorder") {
  const geometry::Surfaces level = ridge();
  const geometry::Surfaces west = readBy({0, 0}, level);
  const geometry::Surfaces east = readBy({1, 0}, level);
  REQUIRE(west.triangle.size() > east.triangle.size());  // the ridge
  const geometry::Tracer of_west(west);
  const geometry::Tracer of_east(east);
  for (const double x : {42.0, 62.5, 66.0, 81.0}) {
    const Number3 at(x, 1.0, 30.0);
    const auto traced = [&](const geometry::Tracer& tracer, double reach_m) {
      return transfer::TransferTracer(tracer, settingsWithin(reach_m)).trace(at, {0, 0}, 3);
    };
    CHECK(sameBits(traced(of_west, kReach_m), traced(of_east, kReach_m)));
    CHECK_FALSE(sameBits(traced(of_west, 1e3), traced(of_east, 1e3)));
  }
}

TEST_CASE("ProbeReach, WhatLiesBeyondChangesNothing") {
  const geometry::Surfaces near = walls(false);
  const geometry::Surfaces all = walls(true);
  const geometry::Tracer of_near(near);
  const geometry::Tracer of_all(all);
  const auto traced = [&](const geometry::Tracer& tracer, double reach_m) {
    return transfer::TransferTracer(tracer, settingsWithin(reach_m)).trace({10, 1, 20}, {0, 0}, 0);
  };
  CHECK(sameBits(traced(of_near, kReach_m), traced(of_all, kReach_m)));
  CHECK_FALSE(sameBits(traced(of_near, 65.5), traced(of_all, 65.5)));       // the walls at 64.5 and 65 m
  CHECK_FALSE(sameBits(traced(of_near, 59.0), traced(of_near, kReach_m)));  // the pillar in the corner
}

TEST_CASE("ProbeReach, OfAWallItSeesWhatLiesInItsSquare") {
  constexpr double kElevation = 0.9;
  const geometry::Surfaces level = wallTo(kElevation, Number3(0.0), Number3(0.0));  // 10 m north of the origin
  const geometry::Tracer tracer(level);
  // Expected value by a separate quadrature, in double.
  const auto expected = [&](std::size_t b, double reach_m) {
    constexpr int kSteps = 400;
    double open = 0.0;
    double all = 0.0;
    for (int i = 0; i < kSteps; ++i)
      for (int j = 0; j < 4 * kSteps; ++j) {
        const double y = (i + 0.5) / kSteps;
        const double azimuth = det::kTwoPi * (j + 0.5) / (4.0 * kSteps);
        const double across = std::sqrt(1.0 - y * y);
        const Number3 w(across * std::sin(azimuth), y, across * std::cos(azimuth));
        const double weight = std::max(dot(w, transfer::transferBasis()[b]), 0.0);
        const bool meets =
            w.z < 0.0 && y / -w.z < std::tan(kElevation) && reach_m >= 10.0 && 10.0 * std::abs(w.x / w.z) <= reach_m;
        all += weight;
        if (!meets) open += weight;
      }
    return all > 0.0 ? open / all : 0.0;
  };
  constexpr double kSampling = 0.01;  // error of 16384 well spread paths
  for (const double reach_m : {9.9, 10.1, 25.0, 1000.0}) {
    transfer::TransferSettings settings = settingsWithin(reach_m);
    settings.rays = 16384;
    const auto visibility =
        transfer::TransferTracer(tracer, settings).trace({0, 1e-3, 0}, {0, 0}, 0).transfer.visibility;
    for (std::size_t b = 0; b < transfer::kDirections; ++b) {
      CAPTURE(reach_m, b);
      CHECK(visibility[b] == Approx(expected(b, reach_m)).margin(kSampling));
    }
  }
}

TEST_CASE("ProbeReach, ShadowsEndAtTheProbesReachNotAtTheirSurfaces") {
  // The sun in the east, 10 degrees high. A screen at x = 35 puts all ground to x = -100 in its shadow.
  geometry::Surfaces level = groundOf(Number3(1.0), 1000.0);
  addQuad(level, {35, 0, -500}, {0, 0, 1000}, {0, 30, 0}, addMaterial(level, Number3(0.0), true));
  const geometry::Tracer tracer(level);
  const auto bounced = [&](double x, double reach_m) {
    transfer::TransferSettings settings = settingsWithin(reach_m);
    settings.bounces = 1;
    settings.ground_albedo = Number3(0.0);
    settings.light_directions = {towards(0.5 * det::kPi, 0.17)};
    return transfer::TransferTracer(tracer, settings)
        .trace({x, 1, 0}, {0, 0}, 0)
        .transfer.sun[transfer::kDirections - 1][0]
        .y;
  };
  CHECK(bounced(0, 40) < 0.1 * bounced(0, 30));
  // Ground at -38 is 73 m from the screen and in its shadow; the probe itself is 37 from it.
  CHECK(bounced(-2, 38) < 0.1 * bounced(-2, 36));
}

TEST_CASE("ProbeReach, WhatLeavesDownwardMeetsThePlane") {
  const geometry::Surfaces level = groundOf(Number3(0.6), 1000.0);
  const geometry::Tracer tracer(level);
  for (const double reach_m : {0.0, 1.5, 100.0}) {
    transfer::TransferSettings settings = settingsWithin(reach_m);
    settings.rays = 4096;
    settings.bounces = 1;
    settings.ground_albedo = Number3(0.6);
    const auto t = transfer::TransferTracer(tracer, settings).trace({5, 2, 3}, {0, 0}, 0).transfer;
    for (std::size_t b = 0; b < transfer::kDirections; ++b) {
      CAPTURE(reach_m, b);
      CHECK(t.visibility[b] == Approx(transfer::transferBasis()[b].y > -1.0 ? 1.0 : 0.0));
      const double below = det::kPi * (1.0 - transfer::transferBasis()[b].y) / 2.0;
      // For the share that hits, the next ray always escapes. Only the weights of the two halves add noise.
      CHECK(t.sky[b][0].y / det::kShConstant == Approx(0.6 * below).epsilon(1e-9));
    }
  }
}

TEST_CASE("ProbeReach, LocalLightsAreThoseWithinIt") {
  const geometry::Surfaces level = ridge();
  const geometry::Surfaces west = readBy({0, 0}, level);
  const geometry::Surfaces east = readBy({1, 0}, level);
  const geometry::Tracer of_west(west);
  const geometry::Tracer of_east(east);
  transfer::LocalSettings settings;
  settings.rays = 256;
  settings.reach_m = kReach_m;
  settings.lights = 3;
  const std::vector<Number3> lights{{-39, 20, 30}, {50, 1, 20}, {60, 3, 10}, {69, 2, 25}, {90, 1, 40}, {62, 1, 95.5}};
  const transfer::LocalTransferTracer in_west(of_west, settings, lights);
  const transfer::LocalTransferTracer in_east(of_east, settings, lights);
  const Number3 at(66, 1, 30);
  const transfer::LocalProbe probe = in_west.trace(at, {0, 0}, 1);
  CHECK(sameBits(probe, in_east.trace(at, {0, 0}, 1)));
  CHECK(probe.transfer.size() == 3);
  for (const transfer::LocalTransfer& t : probe.transfer) {
    CHECK(t.light > 0);  // 105 m away
    CHECK(t.light < 5);  // 65.5 m
  }
  const auto count = [&](const Number3& light) {
    return transfer::LocalTransferTracer(of_west, settings, {light}).trace(at, {0, 0}, 1).transfer.size();
  };
  CHECK(count({62, 1, 93.5}) == 1);
  CHECK(count({62, 1, 94.5}) == 0);
  CHECK(count({1.5, 1, 30}) == 0);
  settings.reach_m = 1e3;
  settings.lights = 6;
  CHECK_FALSE(sameBits(transfer::LocalTransferTracer(of_west, settings, lights).trace(at, {0, 0}, 1),
                       transfer::LocalTransferTracer(of_east, settings, lights).trace(at, {0, 0}, 1)));
}

}  // namespace welkin::tests
