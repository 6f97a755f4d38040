// SPDX-License-Identifier: Apache-2.0
// Laws of a probe's transfer in any level: walls keep light out, it is linear and reciprocal, it turns with the level,
// and backs are black.
#include <catch2/catch.hpp>

#include "probes/transfer/trace_transfer.h"
#include "tests/probes/closed_forms/closed_forms.h"
#include "transfer_helpers.h"

namespace welkin::tests {

using f64::Number3;
namespace {}  // namespace

TEST_CASE("Transfer, NothingEntersSealedRooms") {
  transfer::TransferSettings settings = settingsOf(4, 1024);
  settings.ground_albedo = Number3(1.0);
  settings.light_directions = {towards(1.5, 0.4), towards(4.7, 0.3), towards(0, det::kPi / 2)};
  const auto isDark = [&](const geometry::Surfaces& s, const Number3& position) {
    const geometry::Tracer tracer(s);
    const transfer::ProbeTransfer t = transfer::traceTransfer(tracer, position, settings, {0, 0}, 0);
    bool dark = true;
    for (std::size_t b = 0; b < transfer::kDirections; ++b) {
      dark = dark && t.visibility[b] == 0.0;
      for (const Number3& c : t.sky[b]) dark = dark && c == Number3(0.0);
      for (const Number3& c : t.sun[b]) dark = dark && c == Number3(0.0);
    }
    return dark;
  };
  const geometry::Surfaces rooms = twoRooms(Number3(0.9), true);
  for (const Number3& p : {Number3(2, 1, 0), Number3(0.01, 1, 0), Number3(3.99, 2.99, 1.99)}) CHECK(isDark(rooms, p));
  CHECK_FALSE(isDark(rooms, {-0.01, 1, 0}));
  CHECK(isDark(twoRooms(Number3(0.9), false), {-2, 1, 0}));
  // Far from the origin, where floats are coarse.
  CHECK(isDark(turned(rooms, 0.4, {3000, 40, -2000}), turned(Number3(0.1, 1, 0), 0.4) + Number3(3000, 40, -2000)));
}

TEST_CASE("Transfer, IsLinearInTheLight") {
  const auto emittedBy = [](double a, double b) {
    geometry::Surfaces s = groundOf({0.3, 0.5, 0.7}, 20);
    addQuad(s, {-3, 0, -3}, {6, 0, 0}, {0, 2, 0}, addMaterial(s, Number3(0.5), false, Number3(a)));
    addQuad(s, {4, 0, -3}, {0, 0, 6}, {0, 2, 0}, addMaterial(s, Number3(0.2), true, Number3(b)));
    const geometry::Tracer tracer(s);
    return transfer::traceTransfer(tracer, {0, 1, 0}, settingsOf(3), {0, 0}, 0);
  };
  const auto first = emittedBy(1, 0);
  const auto second = emittedBy(0, 1);
  const auto both = emittedBy(2, 3);
  for (std::size_t b = 0; b < transfer::kDirections; ++b) {
    CHECK(first.emitted[b].x > 0.0);
    CHECK(both.emitted[b].x == Approx(2 * first.emitted[b].x + 3 * second.emitted[b].x).epsilon(1e-12));
    CHECK(both.emitted[b].z == Approx(2 * first.emitted[b].z + 3 * second.emitted[b].z).epsilon(1e-12));
  }
}

TEST_CASE("Transfer, ASkyOfSunsIsTheSky") {
  // The sun's transfer is tested directly, the sky's is found by paths. They agree in the sum over many suns with
  // radiance Y_k.
  geometry::Surfaces level = wallTo(0.8, {0.2, 0.5, 0.8}, {0.9, 0.5, 0.1});
  addBoxOutside(level, {1, 0, -7}, {3, 2.5, -4}, addMaterial(level, {0.7, 0.3, 0.6}));
  const geometry::Tracer tracer(level);
  transfer::TransferSettings settings = settingsOf(2);
  settings.ground_albedo = {0.4, 0.3, 0.2};
  constexpr std::size_t kSuns = 1024;
  std::vector<det::ShBasis> basis;
  for (std::size_t i = 0; i < kSuns; ++i) {
    const double turns = static_cast<double>(i) * 0.6180339887498949;
    settings.light_directions.push_back(
        geometry::sphereDirection((static_cast<double>(i) + 0.5) / (2.0 * kSuns), turns - std::floor(turns)));
    REQUIRE(settings.light_directions.back().y > 0.0);
    basis.push_back(det::shBasis(settings.light_directions.back()));
  }
  const transfer::TransferTracer transfer(tracer, settings);
  constexpr double kQuadrature = 2e-3;  // error of 1024 directions, for a light of 1 from everywhere
  std::vector<transfer::ProbeTransfer> probe;
  for (std::size_t i = 0; i < kProbes; ++i) probe.push_back(transfer.trace({0, 1, -7}, {0, 0}, i).transfer);
  for (std::size_t b = 0; b < transfer::kDirections; ++b)
    for (std::size_t k = 0; k < 4; ++k)
      for (int c = 0; c < 3; ++c) {
        CAPTURE(b, k, c);
        double sum = 0.0;
        double squares = 0.0;
        for (const transfer::ProbeTransfer& p : probe) {
          double suns = 0.0;
          for (std::size_t i = 0; i < kSuns; ++i) suns += p.sun[b][i][c] * basis[i].v[k] * det::kTwoPi / double{kSuns};
          const double off = suns - p.sky[b][k][c];
          sum += off;
          squares += off * off;
        }
        const double mean = sum / double{kProbes};
        checkMeasured({mean, std::sqrt((squares / double{kProbes} - mean * mean) / (kProbes - 1.0))}, 0.0, kQuadrature);
        CHECK((k > 1 || probe[0].sky[b][k][c] > 0.02));
      }
}

TEST_CASE("Transfer, PatchesMayChangePlaces") {
  // Two squares of 1 m that reflect nothing stand in a yard with a wall between them. One faces down, one along B1. On
  // average, each gets as much of the other's light as the other gets of its own.
  const std::array<Number3, transfer::kDirections> basis = transfer::transferBasis();
  struct Patch {
    Number3 middle, a, b;
    std::size_t direction;
  };
  const Number3 along = geometry::unit(cross(basis[0], {0, 0, 1}));
  const Patch patch[] = {{{2, 2.5, 0.5}, {1, 0, 0}, {0, 0, 1}, 3}, {{-3, 1, -0.5}, {0, 0, 1}, along, 0}};
  const auto irradiance = [&](int of, int by) {
    geometry::Surfaces s = wellOf(4.0, 5.0, 4, {0.6, 0.5, 0.3}, {0.4, 0.6, 0.8});
    addQuad(s, {-0.5, 0, -3}, {0, 0, 4}, {0, 1.6, 0}, addMaterial(s, {0.9, 0.3, 0.2}, true));
    for (const int i : {of, by}) {
      const Patch& p = patch[i];
      REQUIRE(dot(cross(p.a, p.b), basis[p.direction]) == Approx(1.0));
      addQuad(s, p.middle - p.a * 0.5 - p.b * 0.5, p.a, p.b,
              addMaterial(s, Number3(0.0), false, Number3(i == by ? 1.0 : 0.0)));
    }
    const geometry::Tracer tracer(s);
    const transfer::TransferTracer transfer(tracer, settingsOf(3, 1024));
    constexpr int kSide = 16;
    double sum = 0.0;
    double squares = 0.0;
    for (int i = 0; i < kSide * kSide; ++i) {
      constexpr double kOff_m = 1e-4;
      const Patch& p = patch[of];
      const double u = (i % kSide + 0.5) / kSide - 0.5;
      const double v = (static_cast<double>(i / kSide) + 0.5) / kSide - 0.5;
      const Number3 at = p.middle + p.a * u + p.b * v + basis[p.direction] * kOff_m;
      const double e = transfer.trace(at, {0, 0}, static_cast<std::size_t>(i)).transfer.emitted[p.direction].y;
      sum += e;
      squares += e * e;
    }
    // The spread over the patch counts as noise, which overstates the noise.
    constexpr double kCount = kSide * kSide;
    const double mean = sum / kCount;
    return Measured{mean, std::sqrt((squares / kCount - mean * mean) / (kCount - 1.0))};
  };
  const auto first = irradiance(0, 1);
  const auto second = irradiance(1, 0);
  CHECK(first.mean > 20.0 * first.standard_error);
  checkMeasured({first.mean, std::hypot(first.standard_error, second.standard_error)}, second.mean, 0.0);
}

TEST_CASE("Transfer, TurnsWithTheLevel") {
  // A third of a turn takes each upward direction to the next one. So turning the level and its lights turns directions
  // too.
  const auto level = [](double azimuth) {
    geometry::Surfaces s = wallTo(0.8, {0.2, 0.5, 0.8}, {0.9, 0.5, 0.1});
    return turned(std::move(s), azimuth);
  };
  const double third = det::kTwoPi / 3;
  const geometry::Surfaces plain_level = level(0);
  const geometry::Surfaces turned_level = level(third);
  const geometry::Tracer plain(plain_level);
  const geometry::Tracer turned_tracer(turned_level);
  transfer::TransferSettings settings = settingsOf(2);
  settings.light_directions = {towards(2.6, 0.5)};
  transfer::TransferSettings turned_settings = settings;
  turned_settings.light_directions = {turned(settings.light_directions[0], third)};
  const transfer::TransferTracer a(plain, settings);
  const transfer::TransferTracer b(turned_tracer, turned_settings);
  const Number3 at(0, 1, -7);
  for (std::size_t i = 0; i < transfer::kDirections; ++i) {
    CAPTURE(i);
    const std::size_t next = i == 3 ? 3 : (i + 1) % 3;
    const auto compare = [&](auto&& quantity) {
      const auto x = measured(a, at, kProbes, [&](const transfer::TracedProbe& p) { return quantity(p.transfer, i); });
      const auto y = measured(b, turned(at, third), kProbes,
                              [&](const transfer::TracedProbe& p) { return quantity(p.transfer, next); });
      checkMeasured({x.mean, std::hypot(x.standard_error, y.standard_error)}, y.mean, 1e-12);
    };
    compare([](const transfer::ProbeTransfer& t, std::size_t d) { return t.sky[d][0].x; });
    compare([](const transfer::ProbeTransfer& t, std::size_t d) { return t.visibility[d]; });
    compare([](const transfer::ProbeTransfer& t, std::size_t d) { return t.sun[d][0].z; });
  }
  // The coefficients of x and z turn as a vector.
  const auto z = measured(a, at, kProbes, [&](const transfer::TracedProbe& p) { return p.transfer.sky[0][2].x; });
  const auto turned_x = measured(b, turned(at, third), kProbes, [&](const transfer::TracedProbe& p) {
    return turned(Number3(p.transfer.sky[1][3].x, 0, p.transfer.sky[1][2].x), -third).z;
  });
  CHECK(std::abs(z.mean) > 10 * z.standard_error);
  checkMeasured({z.mean, std::hypot(z.standard_error, turned_x.standard_error)}, turned_x.mean, 1e-12);
}

TEST_CASE("Transfer, BacksAreBlack") {
  // A floor seen from below, one-sided and two-sided.
  for (const bool double_sided : {false, true}) {
    geometry::Surfaces s = groundOf(Number3(0.5), 100);
    const auto roof = addMaterial(s, Number3(0.7), double_sided);
    addQuad(s, {-10, 2, -10}, {0, 0, 20}, {20, 0, 0}, roof);  // looks up
    const geometry::Tracer tracer(s);
    transfer::TransferSettings settings = settingsOf(2);
    settings.light_directions = {towards(1, 0.1)};
    const transfer::ProbeTransfer t = transfer::traceTransfer(tracer, {0, 1, 0}, settings, {0, 0}, 0);
    for (std::size_t b = 0; b < 3; ++b) CHECK(t.visibility[b] < 0.25);
    // Sky light that the ground reflects to the roof returns from a front only: two bounces.
    transfer::TransferSettings once = settings;
    once.bounces = 1;
    const transfer::ProbeTransfer t1 = transfer::traceTransfer(tracer, {0, 1, 0}, once, {0, 0}, 0);
    CHECK((t.sky[0][0].x > 1.1 * t1.sky[0][0].x) == double_sided);
  }
}

TEST_CASE("Transfer, EmissionLeavesTheRestAlone") {
  // With panels in the air, paths leave downward after any bounce. The paths are the same whether something shines or
  // not.
  const auto level = [](double emission) {
    geometry::Surfaces s;
    const auto panel = addMaterial(s, {0.8, 0.6, 0.4}, true, Number3(emission));
    addQuad(s, {-4, -3, 2}, {8, 0, 0}, {0, 9, 1}, panel);
    addQuad(s, {-4, -3, -3}, {8, 0, 0}, {0, 8, -1}, panel);
    return s;
  };
  transfer::TransferSettings settings = settingsOf(2);
  settings.ground_albedo = Number3(0.5);
  settings.light_directions = {towards(0.4, 0.3), towards(0.4, -0.3)};
  const geometry::Surfaces dark = level(0);
  const geometry::Surfaces bright = level(1);
  const geometry::Tracer dark_tracer(dark);
  const geometry::Tracer bright_tracer(bright);
  const transfer::ProbeTransfer a = transfer::traceTransfer(dark_tracer, {0, 1, 0}, settings, {0, 0}, 0);
  const transfer::ProbeTransfer b = transfer::traceTransfer(bright_tracer, {0, 1, 0}, settings, {0, 0}, 0);
  CHECK(a.emitted[0] == Number3(0.0));
  CHECK(b.emitted[0].x > 1.0);
  for (std::size_t d = 0; d < transfer::kDirections; ++d) {
    CHECK(a.visibility[d] == b.visibility[d]);
    for (std::size_t k = 0; k < 4; ++k) CHECK(a.sky[d][k] == b.sky[d][k]);
    CHECK(a.sun[d][0].x > 0.0);
    CHECK(a.sun[d][0] == b.sun[d][0]);
    // A light from below the horizon would shine on the panels.
    CHECK(a.sun[d][1] == Number3(0.0));
  }
}

}  // namespace welkin::tests
