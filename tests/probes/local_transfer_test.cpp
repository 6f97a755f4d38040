// SPDX-License-Identifier: Apache-2.0
// Local transfer against closed forms and the reference.
#include "probes/transfer/local_transfer.h"

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <catch2/catch.hpp>
#include <cstring>
#include <numeric>

#include "closed_forms.h"
#include "probes/directions.h"
#include "probes/transfer/local_relight.h"
#include "probes/transfer/trace_transfer.h"
#include "skies.h"
#include "sky/error.h"
#include "transfer_helpers.h"

namespace welkin::probes {
namespace {

using tests::bounces;
using tests::checkMeasured;
using tests::Measured;

const Number3 kAlbedo(0.2, 0.5, 0.9);

/// Of a quantity of `count` probes with their own random numbers at one place.
template <typename Quantity>
Measured measuredLocal(const LocalTransferTracer& tracer, const Number3& position, std::size_t count,
                       const Quantity& quantity) {
  double sum = 0.0;
  double squares = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const double value = quantity(tracer.trace(position, {3, -2}, i));
    sum += value;
    squares += value * value;
  }
  const double n = static_cast<double>(count);
  const double mean = sum / n;
  return {mean, std::sqrt(std::max(squares / n - mean * mean, 0.0) / (n - 1.0))};
}

/// Radiance that is the same from everywhere as its coefficient 0.
double coefficientOf(double radiance) {
  return radiance * 4.0 * det::kPi * det::kShConstant;
}

/// The transfer of a light, or none.
LocalTransfer of(const LocalProbe& probe, std::uint32_t light) {
  for (const LocalTransfer& t : probe.transfer)
    if (t.light == light) return t;
  return {light, {}};
}

/// A room with a pillar, open to one side, walls of three colours.
Surfaces furnishedRoom() {
  Surfaces s;
  tests::addBoxInside(s, {-5, 0, -4}, {5, 4, 4}, tests::addMaterial(s, {0.7, 0.5, 0.3}));
  tests::addBoxOutside(s, {0.5, 0, -1.5}, {1.2, 4, 1}, tests::addMaterial(s, {0.2, 0.6, 0.8}));
  tests::addQuad(s, {-5, 1, -4}, {0, 0, 8}, {2, 0, 0}, tests::addMaterial(s, {0.9, 0.1, 0.4}, true));
  return s;
}

bool sameBits(const LocalProbe& a, const LocalProbe& b) {
  const auto same = [](const auto& x, const auto& y) {
    return x.size() == y.size() && std::memcmp(x.data(), y.data(), x.size() * sizeof x[0]) == 0;
  };
  bool result = a.transfer.size() == b.transfer.size() && same(a.error, b.error) && a.rays == b.rays;
  for (std::size_t i = 0; result && i < a.transfer.size(); ++i)
    result = a.transfer[i].light == b.transfer[i].light &&
             std::memcmp(&a.transfer[i].radiance, &b.transfer[i].radiance, sizeof a.transfer[i].radiance) == 0;
  return result;
}

}  // namespace

TEST_CASE("LocalTransfer, ALightInASphereHasItsClosedForm") {
  constexpr double kRadius_m = 3.0;
  const Surfaces sphere = tests::sphereInside(kRadius_m, 5, kAlbedo);
  const double roughness = tests::roughnessOf(sphere, kRadius_m);
  CHECK(roughness < 4e-4);
  const Tracer tracer(sphere);
  const Number3 probe(0.7, 1.2, -0.9);
  const double wall = 1.0 / (kRadius_m * kRadius_m);  // mean irradiance
  for (const int n : {1, 2, 5}) {
    const LocalTransferTracer local(tracer, {512, n, 4}, {{0, 0, 0}});
    for (int c = 0; c < 3; ++c) {
      const double expected = coefficientOf(wall / det::kPi * bounces(kAlbedo, 1, n)[c]);
      const double bound = 3.0 * roughness * expected;
      checkMeasured(measuredLocal(local, probe, 20, [&](const LocalProbe& p) { return of(p, 0).radiance[0][c]; }),
                    expected, bound);
      for (std::size_t k = 1; k < 4; ++k)
        checkMeasured(measuredLocal(local, probe, 20, [&](const LocalProbe& p) { return of(p, 0).radiance[k][c]; }),
                      0.0, bound);
    }
  }
  // Wherever the light is, what comes after the first bounce is the same from everywhere.
  const std::vector<Number3> aside = {{1.1, -0.4, 0.6}, {-2.0, 0.5, 0.1}};
  const LocalTransferTracer one(tracer, {1024, 1, 4}, aside);
  const LocalTransferTracer five(tracer, {1024, 5, 4}, aside);
  for (const std::uint32_t light : {0U, 1U})
    for (int c = 0; c < 3; ++c) {
      const double expected = coefficientOf(wall / det::kPi * bounces(kAlbedo, 2, 5)[c]);
      for (std::size_t k = 0; k < 4; ++k) {
        const auto part = [&](const LocalProbe& p) { return of(p, light).radiance[k][c]; };
        const Measured all = measuredLocal(five, probe, 10, part);
        const Measured first = measuredLocal(one, probe, 10, part);
        checkMeasured({all.mean - first.mean, std::hypot(all.standard_error, first.standard_error)},
                      k == 0 ? expected : 0.0, 3.0 * roughness * expected);
      }
    }
}

TEST_CASE("LocalTransfer, ALightOverAPlaneSeesItsOwnReflection") {
  // Radiance rho cos^3 / (pi h^2) at an angle from straight down: integrals pi / 2, and 2 pi / 5 with the cosine.
  const Surfaces ground = tests::groundOf(kAlbedo, 100.0);
  const Tracer tracer(ground);
  for (const double height : {0.5, 2.0}) {
    const Number3 at(1, height, -2);
    const LocalTransferTracer local(tracer, {1024, 2, 8}, {at});
    const double by = kAlbedo.z / (height * height);
    checkMeasured(measuredLocal(local, at, 20, [](const LocalProbe& p) { return of(p, 0).radiance[0].z; }),
                  det::kShConstant * by / 2.0, 1e-5 * by);
    checkMeasured(measuredLocal(local, at, 20, [](const LocalProbe& p) { return of(p, 0).radiance[1].z; }),
                  -det::kShLinear * by * 0.4, 1e-5 * by);
    for (const std::size_t k : {2U, 3U})
      checkMeasured(measuredLocal(local, at, 20, [&](const LocalProbe& p) { return of(p, 0).radiance[k].z; }), 0.0,
                    1e-5 * by);
  }
}

TEST_CASE("LocalTransfer, TwoBandsAreTheReferences") {
  // Irradiance of a direction less that of its opposite has band 1 alone, its mean over an icosahedron's twelve
  // directions band 0 and, at most a hundredth, bands 6 and up.
  const Surfaces room = furnishedRoom();
  const Tracer tracer(room);
  const std::vector<Number3> lights = {{-3, 3, 1}, {3, 1, -2}, {0, 1, 3}, {-1, 1, -3.2}};
  const Number3 probe(-1.5, 1.5, 0.5);
  const LocalTransferTracer local(tracer, {1024, 2, 2}, lights);
  const double golden = 0.5 * (1.0 + std::sqrt(5.0));
  for (std::uint32_t l = 0; l < lights.size(); ++l) {
    const LocalLight light[] = {{lights[l], Number3(1.0)}};
    const auto reference = [&](const Number3& normal, std::uint64_t seed) {
      return traceReference(tracer, tests::darkness(), light, probe, normal, {8192, 2, seed}).local;
    };
    Number3 sum(0.0);
    Number3 squares(0.0);
    std::uint64_t seed = 1;
    for (const double a : {-1.0, 1.0})
      for (const double b : {-golden, golden})
        for (const Number3& v : {Number3(0, a, b), Number3(a, b, 0), Number3(b, 0, a)}) {
          const Estimate e = reference(unit(v), seed++);
          sum += e.value;
          squares += e.standard_error * e.standard_error;
        }
    for (const int c : {0, 2}) {
      CAPTURE(l, c);
      const Measured mean = measuredLocal(
          local, probe, 20, [&](const LocalProbe& p) { return det::kPi * det::kShConstant * of(p, l).radiance[0][c]; });
      checkMeasured({mean.mean - sum[c] / 12.0, std::hypot(mean.standard_error, std::sqrt(squares[c]) / 12.0)}, 0.0,
                    0.01 * mean.mean);
    }
    for (const auto& [normal, k] : {std::pair{Number3(0, 1, 0), 1}, {Number3(0, 0, 1), 2}, {Number3(1, 0, 0), 3}}) {
      const Estimate a = reference(normal, seed++);
      const Estimate b = reference(-normal, seed++);
      const double lobe = 2.0 * det::cosineLobe(1) * det::kShLinear;
      const Measured m = measuredLocal(local, probe, 20, [&, k = static_cast<std::size_t>(k)](const LocalProbe& p) {
        return lobe * of(p, l).radiance[k].x;
      });
      CAPTURE(l, k);
      checkMeasured({m.mean - (a.value.x - b.value.x),
                     std::hypot(m.standard_error, std::hypot(a.standard_error.x, b.standard_error.x))},
                    0.0);
    }
  }
}

TEST_CASE("LocalTransfer, FewTestsOfManyLightsAreUnbiased") {
  const Surfaces room = furnishedRoom();
  const Tracer tracer(room);
  std::vector<Number3> lights;
  for (int i = 0; i < 40; ++i) lights.push_back({-4.5 + 1.3 * (i % 4), 0.3 + 0.06 * i, -3.5 + 0.17 * i});
  const Number3 probe(-1.5, 1.5, 0.5);
  const LocalTransferTracer few(tracer, {512, 2, 3}, lights);
  const LocalTransferTracer every(tracer, {512, 2, 40}, lights);
  for (std::uint32_t l = 0; l < lights.size(); l += 3) {
    const auto part = [&](const LocalProbe& p) { return of(p, l).radiance[0].y; };
    const Measured a = measuredLocal(few, probe, 30, part);
    const Measured b = measuredLocal(every, probe, 30, part);
    CAPTURE(l);
    checkMeasured({a.mean - b.mean, std::hypot(a.standard_error, b.standard_error)}, 0.0);
  }
  // A bounded number of rays: 512 paths of two vertices with three tests each.
  CHECK(few.trace(probe, {0, 0}, 0).rays <= 512 * 2 * 4);
}

TEST_CASE("LocalTransfer, NothingComesFromAnotherRoom") {
  const Surfaces rooms = tests::twoRooms(kAlbedo, false);
  const Tracer tracer(rooms);
  std::vector<Number3> lights;
  for (int i = 0; i < 150; ++i)
    for (const double side : {-1.0, 1.0}) {
      const double x = 0.02 + 3.9 * (i / 10) / 15.0;
      lights.push_back({side * x, 0.3 + 0.25 * (i % 10), -1.7 + 0.022 * i});
    }
  const std::vector<Number3> some(lights.begin(), lights.begin() + 40);
  const Number3 probe(-0.1, 1.4, 0.3);
  for (const auto& list : {some, lights}) {
    const LocalTransferTracer local(tracer, {1024, 3, 8}, list);
    const LocalProbe traced = local.trace(probe, {0, 0}, 7);
    CHECK(traced.transfer.size() == std::min(list.size() / 2, kMostLocalLights));
    for (const LocalTransfer& t : traced.transfer) CHECK(list[t.light].x < 0.0);
  }
}

TEST_CASE("LocalTransfer, TheMostInfluentialLightsAreKept") {
  const Surfaces room = furnishedRoom();
  const Tracer tracer(room);
  std::vector<Number3> lights;
  for (int i = 0; i < 120; ++i)  // not in the pillar
    lights.push_back({-4.8 + 0.4 * (i % 12), 0.2 + 0.35 * (i / 12), 3.7 - 0.057 * i});
  const Number3 probe(-1.5, 1.5, 0.5);
  const LocalTransferTracer all(tracer, {16384, 2, 16}, lights);
  std::vector<double> influence;
  for (const LocalTransfer& t : all.trace(probe, {0, 0}, 0).transfer) influence.push_back(t.influence());
  std::vector<double> sorted = influence;
  std::sort(sorted.rbegin(), sorted.rend());
  const double best = std::accumulate(sorted.begin(), sorted.begin() + 30, 0.0);
  LocalSettings settings{1024, 2, 8};
  settings.lights = 30;
  const LocalTransferTracer some(tracer, settings, lights);
  double kept = 0.0;
  const LocalProbe traced = some.trace(probe, {0, 0}, 1);
  CHECK(traced.transfer.size() == 30);
  for (const LocalTransfer& t : traced.transfer) kept += influence[t.light];
  CAPTURE(kept, best);
  CHECK(kept > 0.97 * best);
  CHECK(traced.rays <= 1024 * 2 * 9 * 9 / 8 + 120);
}

TEST_CASE("LocalTransfer, IsLinear") {
  const Number3 probe(-1.5, 1.5, 0.5);
  const std::vector<Number3> lights = {{-3, 3, 1}, {3, 1, -2}, {0, 1, 3}};
  // One bounce is in proportion to the albedo.
  Surfaces box;
  tests::addBoxInside(box, {-5, 0, -4}, {5, 4, 4}, tests::addMaterial(box, {0.25, 0.5, 1.0}));
  const Tracer tracer(box);
  const LocalProbe p = LocalTransferTracer(tracer, {256, 1, 2}, lights).trace(probe, {0, 0}, 0);
  REQUIRE(p.transfer.size() == 3);
  for (const LocalTransfer& t : p.transfer)
    for (const Number3& k : t.radiance) {
      CHECK(k.y == Approx(2.0 * k.x));
      CHECK(k.z == Approx(4.0 * k.x));
    }
  // Irradiance is in the lights' colours.
  const std::vector<Number3> a = {{1, 2, 3}, {0, 0, 0}, {0.5, 0, 4}};
  const std::vector<Number3> b = {{0, 1, 0}, {2, 7, 1}, {0, 0, 0}};
  std::vector<Number3> both;
  for (std::size_t l = 0; l < 3; ++l) both.push_back(a[l] * 2.0 + b[l]);
  const auto of_a = relitLocal(p.transfer, a);
  const auto of_b = relitLocal(p.transfer, b);
  const auto of_both = relitLocal(p.transfer, both);
  for (std::size_t d = 0; d < kDirections; ++d)
    for (int c = 0; c < 3; ++c) CHECK(of_both[d][c] == Approx(2.0 * of_a[d][c] + of_b[d][c]));
}

TEST_CASE("LocalTransfer, IsTheSameForAnyThreadsAndOrder") {
  const Surfaces room = furnishedRoom();
  const Tracer tracer(room);
  PlacedSector sector;
  sector.id = {-1, 0};
  std::vector<Number3> lights;
  for (int i = 0; i < 12; ++i) {
    sector.probe.push_back({{-4.5 + 0.4 * i, 0.8, 3.0 - 0.5 * i}});
    lights.push_back(sector.probe.back().position + Number3(0, 0.5, 0));
  }
  LocalSettings settings{128, 2, 3};
  settings.lights = 8;
  const LocalTransferTracer local(tracer, settings, lights);
  tbb::global_control control(tbb::global_control::max_allowed_parallelism, 4);
  std::vector<LocalProbe> four;
  tbb::task_arena(4).execute([&] { four = local.trace(sector); });
  for (std::size_t i = sector.probe.size(); i-- > 0;)
    CHECK(sameBits(four[i], local.trace(sector.probe[i].position, sector.id, i)));
  CHECK_FALSE(sameBits(four[0], local.trace(sector.probe[0].position, sector.id, 1)));
  CHECK_FALSE(sameBits(four[0], local.trace(sector.probe[0].position, {0, -1}, 0)));
}

TEST_CASE("LocalTransfer, StandardErrorsAreTheSpread") {
  const Surfaces room = furnishedRoom();
  const Tracer tracer(room);
  const std::vector<Number3> lights = {{-3, 3, 1}, {-1, 1, -3}, {-4, 3, 3}, {-2, 2, 2}};
  const LocalTransferTracer local(tracer, {256, 2, 2}, lights);
  constexpr std::size_t kCount = 100;
  // Of 100 probes the variance is known to 14 %, each probe's own, from 8 replicates, to 53 %, their mean to 5 %.
  constexpr double kRelative = 0.45;
  for (std::uint32_t l = 0; l < lights.size(); ++l) {
    double stated = 0.0;
    const Measured m = measuredLocal(local, {-1.5, 1.5, 0.5}, kCount, [&](const LocalProbe& p) {
      stated += p.error[l].y * p.error[l].y / double{kCount};
      return p.transfer[l].radiance[0].y;
    });
    const double spread = m.standard_error * m.standard_error * double{kCount};
    CHECK(stated == Approx(spread).epsilon(kRelative));
  }
}

TEST_CASE("LocalTransfer, SettingsOutsideTheirRangeAreRefused") {
  const Surfaces nothing;
  const Tracer tracer(nothing);
  const auto refused = [&](const LocalSettings& s, std::vector<Number3> lights = {}) {
    CHECK_THROWS_AS(LocalTransferTracer(tracer, s, std::move(lights)), Error);
  };
  refused({100, 2, 8});
  refused({0, 2, 8});
  refused({1024, 0, 8});
  refused({1024, kMostBounces + 1, 8});
  refused({1024, 2, 0});
  refused({1024, 2, 8, 0});
  refused({1024, 2, 8, kMostLocalLights + 1});
  refused({1024, 2, 8}, {{0, std::nan(""), 0}});
  CHECK(LocalTransferTracer(tracer, {}, {{0, 1, 0}}).trace({0, 0, 0}, {0, 0}, 0).transfer.empty());
  CHECK(LocalTransferTracer(tracer, {}, {}).trace({0, 0, 0}, {0, 0}, 0).rays == 0);
}

}  // namespace welkin::probes
