// SPDX-License-Identifier: Apache-2.0
// What holds of a probe's transfer in any level: walls keep light out, it is linear and reciprocal, it turns with the
// level, backs are black.
#include <catch2/catch.hpp>

#include "closed_forms.h"
#include "probes/transfer/trace_transfer.h"
#include "transfer_helpers.h"

namespace welkin::probes {
namespace {

using tests::checkMeasured;
using tests::kProbes;
using tests::measured;
using tests::settingsOf;

}  // namespace

TEST_CASE("Transfer, NothingEntersSealedRooms") {
  TransferSettings settings = settingsOf(4, 1024);
  settings.ground_albedo = Number3(1.0);
  settings.light_directions = {tests::towards(1.5, 0.4), tests::towards(4.7, 0.3), tests::towards(0, det::kPi / 2)};
  const auto isDark = [&](const Surfaces& s, const Number3& position) {
    const Tracer tracer(s);
    const ProbeTransfer t = traceTransfer(tracer, position, settings, {0, 0}, 0);
    bool dark = true;
    for (std::size_t b = 0; b < kDirections; ++b) {
      dark = dark && t.visibility[b] == 0.0;
      for (const Number3& c : t.sky[b]) dark = dark && c == Number3(0.0);
      for (const Number3& c : t.sun[b]) dark = dark && c == Number3(0.0);
    }
    return dark;
  };
  const Surfaces rooms = tests::twoRooms(Number3(0.9), true);
  for (const Number3& p : {Number3(2, 1, 0), Number3(0.01, 1, 0), Number3(3.99, 2.99, 1.99)}) CHECK(isDark(rooms, p));
  CHECK_FALSE(isDark(rooms, {-0.01, 1, 0}));
  CHECK(isDark(tests::twoRooms(Number3(0.9), false), {-2, 1, 0}));
  // Far from the origin, where floats are coarse.
  CHECK(isDark(tests::turned(rooms, 0.4, {3000, 40, -2000}),
               tests::turned(Number3(0.1, 1, 0), 0.4) + Number3(3000, 40, -2000)));
}

TEST_CASE("Transfer, IsLinearInTheLight") {
  const auto emittedBy = [](double a, double b) {
    Surfaces s = tests::groundOf({0.3, 0.5, 0.7}, 20);
    tests::addQuad(s, {-3, 0, -3}, {6, 0, 0}, {0, 2, 0}, tests::addMaterial(s, Number3(0.5), false, Number3(a)));
    tests::addQuad(s, {4, 0, -3}, {0, 0, 6}, {0, 2, 0}, tests::addMaterial(s, Number3(0.2), true, Number3(b)));
    const Tracer tracer(s);
    return traceTransfer(tracer, {0, 1, 0}, settingsOf(3), {0, 0}, 0);
  };
  const auto first = emittedBy(1, 0);
  const auto second = emittedBy(0, 1);
  const auto both = emittedBy(2, 3);
  for (std::size_t b = 0; b < kDirections; ++b) {
    CHECK(first.emitted[b].x > 0.0);
    CHECK(both.emitted[b].x == Approx(2 * first.emitted[b].x + 3 * second.emitted[b].x).epsilon(1e-12));
    CHECK(both.emitted[b].z == Approx(2 * first.emitted[b].z + 3 * second.emitted[b].z).epsilon(1e-12));
  }
}

TEST_CASE("Transfer, ASkyOfSunsIsTheSky") {
  // The sun's transfer, asked directly, and the sky's, found by paths: the sum over many suns with radiance Y_k.
  Surfaces level = tests::wallTo(0.8, {0.2, 0.5, 0.8}, {0.9, 0.5, 0.1});
  tests::addBoxOutside(level, {1, 0, -7}, {3, 2.5, -4}, tests::addMaterial(level, {0.7, 0.3, 0.6}));
  const Tracer tracer(level);
  TransferSettings settings = settingsOf(2);
  settings.ground_albedo = {0.4, 0.3, 0.2};
  constexpr std::size_t kSuns = 1024;
  std::vector<det::ShBasis> basis;
  for (std::size_t i = 0; i < kSuns; ++i) {
    const double turns = static_cast<double>(i) * 0.6180339887498949;
    settings.light_directions.push_back(
        sphereDirection((static_cast<double>(i) + 0.5) / (2.0 * kSuns), turns - std::floor(turns)));
    REQUIRE(settings.light_directions.back().y > 0.0);
    basis.push_back(det::shBasis(settings.light_directions.back()));
  }
  const TransferTracer transfer(tracer, settings);
  constexpr double kQuadrature = 2e-3;  // of 1024 directions, of a light of 1 from everywhere
  std::vector<ProbeTransfer> probe;
  for (std::size_t i = 0; i < kProbes; ++i) probe.push_back(transfer.trace({0, 1, -7}, {0, 0}, i).transfer);
  for (std::size_t b = 0; b < kDirections; ++b)
    for (std::size_t k = 0; k < 4; ++k)
      for (int c = 0; c < 3; ++c) {
        CAPTURE(b, k, c);
        double sum = 0.0;
        double squares = 0.0;
        for (const ProbeTransfer& p : probe) {
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
  // Two squares of 1 m that send nothing back, one looking down, one along B1, in a yard with a wall between them: what
  // one gets of the other's light on average is what the other gets of its own.
  const std::array<Number3, kDirections> basis = transferBasis();
  struct Patch {
    Number3 middle, a, b;
    std::size_t direction;
  };
  const Number3 along = unit(cross(basis[0], {0, 0, 1}));
  const Patch patch[] = {{{2, 2.5, 0.5}, {1, 0, 0}, {0, 0, 1}, 3}, {{-3, 1, -0.5}, {0, 0, 1}, along, 0}};
  const auto irradiance = [&](int of, int by) {
    Surfaces s = tests::wellOf(4.0, 5.0, 4, {0.6, 0.5, 0.3}, {0.4, 0.6, 0.8});
    tests::addQuad(s, {-0.5, 0, -3}, {0, 0, 4}, {0, 1.6, 0}, tests::addMaterial(s, {0.9, 0.3, 0.2}, true));
    for (const int i : {of, by}) {
      const Patch& p = patch[i];
      REQUIRE(dot(cross(p.a, p.b), basis[p.direction]) == Approx(1.0));
      tests::addQuad(s, p.middle - p.a * 0.5 - p.b * 0.5, p.a, p.b,
                     tests::addMaterial(s, Number3(0.0), false, Number3(i == by ? 1.0 : 0.0)));
    }
    const Tracer tracer(s);
    const TransferTracer transfer(tracer, settingsOf(3, 1024));
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
    // The spread over the patch counts as noise: more than there is.
    constexpr double kCount = kSide * kSide;
    const double mean = sum / kCount;
    return tests::Measured{mean, std::sqrt((squares / kCount - mean * mean) / (kCount - 1.0))};
  };
  const auto first = irradiance(0, 1);
  const auto second = irradiance(1, 0);
  CHECK(first.mean > 20.0 * first.standard_error);
  checkMeasured({first.mean, std::hypot(first.standard_error, second.standard_error)}, second.mean, 0.0);
}

TEST_CASE("Transfer, TurnsWithTheLevel") {
  // A third of a turn takes each direction up to the next one: the level and its lights turned, directions turn too.
  const auto level = [](double azimuth) {
    Surfaces s = tests::wallTo(0.8, {0.2, 0.5, 0.8}, {0.9, 0.5, 0.1});
    return tests::turned(std::move(s), azimuth);
  };
  const double third = det::kTwoPi / 3;
  const Surfaces plain_level = level(0);
  const Surfaces turned_level = level(third);
  const Tracer plain(plain_level);
  const Tracer turned(turned_level);
  TransferSettings settings = settingsOf(2);
  settings.light_directions = {tests::towards(2.6, 0.5)};
  TransferSettings turned_settings = settings;
  turned_settings.light_directions = {tests::turned(settings.light_directions[0], third)};
  const TransferTracer a(plain, settings);
  const TransferTracer b(turned, turned_settings);
  const Number3 at(0, 1, -7);
  for (std::size_t i = 0; i < kDirections; ++i) {
    CAPTURE(i);
    const std::size_t next = i == 3 ? 3 : (i + 1) % 3;
    const auto compare = [&](auto&& quantity) {
      const auto x = measured(a, at, kProbes, [&](const TracedProbe& p) { return quantity(p.transfer, i); });
      const auto y = measured(b, tests::turned(at, third), kProbes,
                              [&](const TracedProbe& p) { return quantity(p.transfer, next); });
      checkMeasured({x.mean, std::hypot(x.standard_error, y.standard_error)}, y.mean, 1e-12);
    };
    compare([](const ProbeTransfer& t, std::size_t d) { return t.sky[d][0].x; });
    compare([](const ProbeTransfer& t, std::size_t d) { return t.visibility[d]; });
    compare([](const ProbeTransfer& t, std::size_t d) { return t.sun[d][0].z; });
  }
  // The coefficients of x and z turn as a vector.
  const auto z = measured(a, at, kProbes, [&](const TracedProbe& p) { return p.transfer.sky[0][2].x; });
  const auto turned_x = measured(b, tests::turned(at, third), kProbes, [&](const TracedProbe& p) {
    return tests::turned(Number3(p.transfer.sky[1][3].x, 0, p.transfer.sky[1][2].x), -third).z;
  });
  CHECK(std::abs(z.mean) > 10 * z.standard_error);
  checkMeasured({z.mean, std::hypot(z.standard_error, turned_x.standard_error)}, turned_x.mean, 1e-12);
}

TEST_CASE("Transfer, BacksAreBlack") {
  // A floor seen from below, and one that also turns its face down.
  for (const bool double_sided : {false, true}) {
    Surfaces s = tests::groundOf(Number3(0.5), 100);
    const auto roof = tests::addMaterial(s, Number3(0.7), double_sided);
    tests::addQuad(s, {-10, 2, -10}, {0, 0, 20}, {20, 0, 0}, roof);  // looks up
    const Tracer tracer(s);
    TransferSettings settings = settingsOf(2);
    settings.light_directions = {tests::towards(1, 0.1)};
    const ProbeTransfer t = traceTransfer(tracer, {0, 1, 0}, settings, {0, 0}, 0);
    for (std::size_t b = 0; b < 3; ++b) CHECK(t.visibility[b] < 0.25);
    // Sky light that the ground throws at the roof comes back from a face only: two bounces.
    TransferSettings once = settings;
    once.bounces = 1;
    const ProbeTransfer t1 = traceTransfer(tracer, {0, 1, 0}, once, {0, 0}, 0);
    CHECK((t.sky[0][0].x > 1.1 * t1.sky[0][0].x) == double_sided);
  }
}

TEST_CASE("Transfer, EmissionLeavesTheRestAlone") {
  // Panels in the air, so that paths leave downward after any bounce; the same paths whether something shines or not.
  const auto level = [](double emission) {
    Surfaces s;
    const auto panel = tests::addMaterial(s, {0.8, 0.6, 0.4}, true, Number3(emission));
    tests::addQuad(s, {-4, -3, 2}, {8, 0, 0}, {0, 9, 1}, panel);
    tests::addQuad(s, {-4, -3, -3}, {8, 0, 0}, {0, 8, -1}, panel);
    return s;
  };
  TransferSettings settings = settingsOf(2);
  settings.ground_albedo = Number3(0.5);
  settings.light_directions = {tests::towards(0.4, 0.3), tests::towards(0.4, -0.3)};
  const Surfaces dark = level(0);
  const Surfaces bright = level(1);
  const Tracer dark_tracer(dark);
  const Tracer bright_tracer(bright);
  const ProbeTransfer a = traceTransfer(dark_tracer, {0, 1, 0}, settings, {0, 0}, 0);
  const ProbeTransfer b = traceTransfer(bright_tracer, {0, 1, 0}, settings, {0, 0}, 0);
  CHECK(a.emitted[0] == Number3(0.0));
  CHECK(b.emitted[0].x > 1.0);
  for (std::size_t d = 0; d < kDirections; ++d) {
    CHECK(a.visibility[d] == b.visibility[d]);
    for (std::size_t k = 0; k < 4; ++k) CHECK(a.sky[d][k] == b.sky[d][k]);
    CHECK(a.sun[d][0].x > 0.0);
    CHECK(a.sun[d][0] == b.sun[d][0]);
    // From below the horizon it would shine on the panels.
    CHECK(a.sun[d][1] == Number3(0.0));
  }
}

}  // namespace welkin::probes
