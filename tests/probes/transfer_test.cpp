// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>
#include <functional>

#include "closed_forms.h"
#include "probes/transfer/trace_transfer.h"
#include "sky/error.h"
#include "transfer_helpers.h"

namespace welkin::probes {
namespace {

using tests::checkMeasured;
using tests::measured;

constexpr std::size_t kProbes = 32;  ///< independent ones for a standard error
const double kUpper = 1.0 / std::sqrt(3.0);

TransferSettings settingsOf(int bounces, std::size_t rays = 256) {
  TransferSettings settings;
  settings.bounces = bounces;
  settings.rays = rays;
  return settings;
}

/// Irradiance of a uniform sky of radiance 1 where `seen` says so, by the midpoint rule.
template <typename Seen>
double skyIrradiance(const Number3& normal, const Seen& seen) {
  constexpr int kRows = 1000;
  constexpr int kColumns = 4000;
  double sum = 0.0;
  for (int i = 0; i < kRows; ++i) {
    const double y = (i + 0.5) / kRows;
    const double across = std::sqrt(1.0 - y * y);
    for (int j = 0; j < kColumns; ++j) {
      const double azimuth = det::kTwoPi * (j + 0.5) / kColumns;
      const Number3 w(across * std::sin(azimuth), y, -across * std::cos(azimuth));
      if (seen(w)) sum += std::max(dot(w, normal), 0.0);
    }
  }
  return sum * det::kTwoPi / (double{kRows} * kColumns);
}

}  // namespace

TEST_CASE("Transfer, PlaneUnderUniformSkyAndSun") {
  const double rho = 0.2;
  const Surfaces ground = tests::groundOf(Number3(rho));
  const Tracer tracer(ground);
  TransferSettings settings = settingsOf(2);
  settings.ground_albedo = Number3(rho);
  for (const double elevation : {0.0, 0.05, 0.5, 1.2, det::kPi / 2})
    settings.light_directions.push_back(tests::towards(2.0, elevation));
  settings.light_rays = 2;
  const TransferTracer transfer(tracer, settings);
  const auto basis = transferBasis();
  for (std::size_t b = 0; b < kDirections; ++b) {
    CAPTURE(b);
    const double below = (1.0 - basis[b].y) / 2.0;
    checkMeasured(
        measured(transfer, {1, 1, 2}, kProbes, [&](const TracedProbe& p) { return tests::uniformSky(p.transfer, b); }),
        det::kPi * ((1.0 + basis[b].y) / 2.0 + rho * below));
    // By coefficient, none of which is 0 by accident: those of x and z are.
    for (std::size_t k = 0; k < 4; ++k)
      checkMeasured(
          measured(transfer, {1, 1, 2}, kProbes, [&](const TracedProbe& p) { return p.transfer.sky[b][k].x; }),
          below * rho *
              (k == 0   ? det::kPi * det::kShConstant
               : k == 1 ? det::kTwoPi / 3 * det::kShLinear
                        : 0.0));
    for (std::size_t i = 0; i < settings.light_directions.size(); ++i)
      checkMeasured(
          measured(transfer, {1, 1, 2}, kProbes, [&](const TracedProbe& p) { return p.transfer.sun[b][i].z; }),
          rho * settings.light_directions[i].y * below);
  }
  const TracedProbe probe = transfer.trace({1, 1, 2}, {0, 0}, 0);
  for (std::size_t b = 0; b < 3; ++b) CHECK(probe.transfer.visibility[b] == 1.0);
  CHECK(probe.transfer.visibility[3] == 0.0);
  // Linear in the normal, so four directions hold it for every normal.
  std::array<double, kDirections> irradiance{};
  for (std::size_t b = 0; b < kDirections; ++b) irradiance[b] = tests::uniformSky(probe.transfer, b);
  constexpr double kNoise = 2e-2;  // of one probe of 256 paths: measured 6e-3 at most
  for (const Number3& n : {Number3(0, 1, 0), Number3(1, 0, 0), Number3(0, -1, 0), unit(Number3(-1, -0.5, 2))})
    CHECK(tests::reconstructed(n, irradiance) ==
          Approx(det::kPi * ((1.0 + rho) / 2 + (1.0 - rho) / 2 * n.y)).epsilon(kNoise));
}

TEST_CASE("Transfer, ThePlaneBeyondTheLevelIsThePlane") {
  // A level of one square metre of the plane: nearly all of its light comes from beyond.
  const double rho = 0.4;
  const Surfaces ground = tests::groundOf(Number3(rho), 0.5);
  const Tracer tracer(ground);
  TransferSettings settings = settingsOf(1);
  settings.ground_albedo = Number3(rho);
  settings.light_directions = {tests::towards(0.3, 0.7), tests::towards(0.3, -0.7)};
  const TransferTracer transfer(tracer, settings);
  for (std::size_t b = 0; b < kDirections; ++b) {
    const double below = (1.0 - transferBasis()[b].y) / 2.0;
    checkMeasured(
        measured(transfer, {0, 1, 0}, kProbes, [&](const TracedProbe& p) { return tests::uniformSky(p.transfer, b); }),
        det::kPi * (1.0 - below + rho * below));
    checkMeasured(measured(transfer, {0, 1, 0}, kProbes, [&](const TracedProbe& p) { return p.transfer.sun[b][0].x; }),
                  rho * std::sin(0.7) * below);
    CHECK(transfer.trace({0, 1, 0}, {0, 0}, 0).transfer.sun[b][1] == Number3(0.0));
  }
  // Light that was not reflected at all is the sky's alone.
  TransferSettings none = settings;
  none.bounces = 0;
  const ProbeTransfer direct = traceTransfer(tracer, {0, 1, 0}, none, {0, 0}, 0);
  for (std::size_t b = 0; b < kDirections; ++b) {
    CHECK(direct.sky[b][0] == Number3(0.0));
    CHECK(direct.sun[b][0] == Number3(0.0));
    CHECK(direct.visibility[b] == (b == 3 ? 0.0 : 1.0));
  }
}

TEST_CASE("Transfer, SkyVisibilityBetweenBlackWalls") {
  const Number3 black(0.0);
  const Number3 at(0, 0.001, 0);  // on the ground: what it hides there is below 1e-3
  constexpr double kHeight = 1e-3;
  struct Case {
    Surfaces surfaces;
    std::function<bool(const Number3&)> seen;
  };
  const double wall = 0.9;
  std::vector<Case> levels;
  levels.push_back({tests::wallTo(wall, black, black), [&](const Number3& w) { return w.y > -w.z * std::tan(wall); }});
  levels.push_back({tests::canyonOf(8, 6, black, black), [](const Number3& w) { return w.y * 4 > std::abs(w.x) * 6; }});
  for (const Case& level : levels) {
    const Tracer tracer(level.surfaces);
    const TransferTracer transfer(tracer, settingsOf(1));
    for (std::size_t b = 0; b < 3; ++b) {
      const Number3 normal = transferBasis()[b];
      checkMeasured(measured(transfer, at, kProbes, [&](const TracedProbe& p) { return p.transfer.visibility[b]; }),
                    skyIrradiance(normal, level.seen) / (det::kPi * (1 + kUpper) / 2), kHeight);
    }
  }
  // A well so deep that all of its mouth is in front of every direction up: E is n . V, V vertical.
  const Surfaces well = tests::wellOf(2, 4, 6, black, black);
  const Tracer tracer(well);
  const TransferTracer transfer(tracer, settingsOf(1, 1024));
  for (std::size_t b = 0; b < 3; ++b)
    checkMeasured(measured(transfer, at, kProbes, [&](const TracedProbe& p) { return p.transfer.visibility[b]; }),
                  tests::skyViewOfWell(2, 4, 6) * kUpper / ((1 + kUpper) / 2), kHeight);
}

TEST_CASE("Transfer, FurnaceIsExact") {
  // Every direction sees the same, after any number of bounces, and directions are normalised by what they sum to.
  Surfaces s;
  tests::addBoxInside(s, {-3, -2, -1}, {4, 5, 6}, tests::addMaterial(s, Number3(0.6), false, {1, 2, 3}));
  const Tracer tracer(s);
  for (const int bounces : {0, 1, 5}) {
    const ProbeTransfer t = traceTransfer(tracer, {0.5, 1, 2}, settingsOf(bounces), {0, 0}, 0);
    const double sum = (1.0 - std::pow(0.6, bounces + 1)) / (1.0 - 0.6);
    for (std::size_t b = 0; b < kDirections; ++b) {
      CHECK(t.emitted[b].x == Approx(det::kPi * sum).epsilon(1e-12));
      CHECK(t.emitted[b].z == Approx(3 * det::kPi * sum).epsilon(1e-12));
      CHECK(t.visibility[b] == 0.0);
    }
  }
}

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

TEST_CASE("Transfer, SunThroughANarrowSlit") {
  // A roof 3 m above black and white ground, open along z for 2 cm: a bright strip. E(down) = rho Es sin(e) times the
  // difference of the sines, seen from the probe in section, over 2; the ground lights nothing else that reflects.
  const double rho = 0.8;
  constexpr double kEnd = 200.0;  // metres; floats of corners further away blur the slit's edges
  const double half = 0.01;
  const double height = 1.0;
  Surfaces s = tests::groundOf(Number3(rho), kEnd);
  const auto black = tests::addMaterial(s, Number3(0.0), true);
  for (const double x : {-kEnd, half}) tests::addQuad(s, {x, 3, -kEnd}, {kEnd - half, 0, 0}, {0, 0, 2 * kEnd}, black);
  const Tracer tracer(s);
  TransferSettings settings = settingsOf(1, 8192);
  settings.light_directions = {Number3(0, 1, 0), unit(Number3(0.2, 1, 0)), unit(Number3(0.2, 1, 0.7))};
  const TransferTracer transfer(tracer, settings);
  for (std::size_t i = 0; i < settings.light_directions.size(); ++i) {
    const Number3& light = settings.light_directions[i];
    const double middle = -3.0 * light.x / light.y;
    const auto sine = [&](double x) { return x / std::sqrt(x * x + height * height); };
    const double expected = rho * light.y * (sine(middle + half) - sine(middle - half)) / 2.0;
    const auto m =
        measured(transfer, {0, height, 0}, kProbes, [&](const TracedProbe& p) { return p.transfer.sun[3][i].y; });
    checkMeasured(m, expected, 0.0);
    CHECK(m.standard_error < 0.1 * expected);
  }
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
