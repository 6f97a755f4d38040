// SPDX-License-Identifier: Apache-2.0
// The transfer of a probe against closed forms.
#include <catch2/catch.hpp>
#include <functional>

#include "probes/transfer/trace_transfer.h"
#include "tests/probes/closed_forms/closed_forms.h"
#include "transfer_helpers.h"

namespace welkin::tests {

using f64::Number3;
namespace {

const double kUpper = 1.0 / std::sqrt(3.0);

/// Irradiance by a uniform sky of radiance 1 in the directions that `seen` accepts, by the midpoint rule.
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
  const geometry::Surfaces ground = groundOf(Number3(rho));
  const geometry::Tracer tracer(ground);
  transfer::TransferSettings settings = settingsOf(2);
  settings.ground_albedo = Number3(rho);
  for (const double elevation : {0.0, 0.05, 0.5, 1.2, det::kPi / 2})
    settings.light_directions.push_back(towards(2.0, elevation));
  settings.light_rays = 2;
  const transfer::TransferTracer transfer(tracer, settings);
  const auto basis = transfer::transferBasis();
  for (std::size_t b = 0; b < transfer::kDirections; ++b) {
    CAPTURE(b);
    const double below = (1.0 - basis[b].y) / 2.0;
    checkMeasured(measured(transfer, {1, 1, 2}, kProbes,
                           [&](const transfer::TracedProbe& p) { return uniformSky(p.transfer, b); }),
                  det::kPi * ((1.0 + basis[b].y) / 2.0 + rho * below));
    // Every coefficient, though those of x and z are 0.
    for (std::size_t k = 0; k < 4; ++k)
      checkMeasured(measured(transfer, {1, 1, 2}, kProbes,
                             [&](const transfer::TracedProbe& p) { return p.transfer.sky[b][k].x; }),
                    below * rho *
                        (k == 0   ? det::kPi * det::kShConstant
                         : k == 1 ? det::kTwoPi / 3 * det::kShLinear
                                  : 0.0));
    for (std::size_t i = 0; i < settings.light_directions.size(); ++i)
      checkMeasured(measured(transfer, {1, 1, 2}, kProbes,
                             [&](const transfer::TracedProbe& p) { return p.transfer.sun[b][i].z; }),
                    rho * settings.light_directions[i].y * below);
  }
  const transfer::TracedProbe probe = transfer.trace({1, 1, 2}, {0, 0}, 0);
  for (std::size_t b = 0; b < 3; ++b) CHECK(probe.transfer.visibility[b] == 1.0);
  CHECK(probe.transfer.visibility[3] == 0.0);
  // The light is linear in the normal, so four directions are exact for every normal.
  std::array<double, transfer::kDirections> irradiance{};
  for (std::size_t b = 0; b < transfer::kDirections; ++b) irradiance[b] = uniformSky(probe.transfer, b);
  constexpr double kNoise = 2e-2;  // noise of one probe of 256 paths; measured 6e-3 at most
  for (const Number3& n : {Number3(0, 1, 0), Number3(1, 0, 0), Number3(0, -1, 0), geometry::unit(Number3(-1, -0.5, 2))})
    CHECK(reconstructed(n, irradiance) == Approx(det::kPi * ((1.0 + rho) / 2 + (1.0 - rho) / 2 * n.y)).epsilon(kNoise));
}

TEST_CASE("Transfer, ThePlaneBeyondTheLevelIsThePlane") {
  // The level is one square metre of the plane, so nearly all light comes from beyond.
  const double rho = 0.4;
  const geometry::Surfaces ground = groundOf(Number3(rho), 0.5);
  const geometry::Tracer tracer(ground);
  transfer::TransferSettings settings = settingsOf(1);
  settings.ground_albedo = Number3(rho);
  settings.light_directions = {towards(0.3, 0.7), towards(0.3, -0.7)};
  const transfer::TransferTracer transfer(tracer, settings);
  for (std::size_t b = 0; b < transfer::kDirections; ++b) {
    const double below = (1.0 - transfer::transferBasis()[b].y) / 2.0;
    checkMeasured(measured(transfer, {0, 1, 0}, kProbes,
                           [&](const transfer::TracedProbe& p) { return uniformSky(p.transfer, b); }),
                  det::kPi * (1.0 - below + rho * below));
    checkMeasured(
        measured(transfer, {0, 1, 0}, kProbes, [&](const transfer::TracedProbe& p) { return p.transfer.sun[b][0].x; }),
        rho * std::sin(0.7) * below);
    CHECK(transfer.trace({0, 1, 0}, {0, 0}, 0).transfer.sun[b][1] == Number3(0.0));
  }
  // Light without a reflection is the sky's alone.
  transfer::TransferSettings none = settings;
  none.bounces = 0;
  const transfer::ProbeTransfer direct = transfer::traceTransfer(tracer, {0, 1, 0}, none, {0, 0}, 0);
  for (std::size_t b = 0; b < transfer::kDirections; ++b) {
    CHECK(direct.sky[b][0] == Number3(0.0));
    CHECK(direct.sun[b][0] == Number3(0.0));
    CHECK(direct.visibility[b] == (b == 3 ? 0.0 : 1.0));
  }
}

TEST_CASE("Transfer, SkyVisibilityBetweenBlackWalls") {
  const Number3 black(0.0);
  const Number3 at(0, 0.001, 0);  // on the ground; the light hidden there is below 1e-3
  constexpr double kHeight = 1e-3;
  struct Case {
    geometry::Surfaces surfaces;
    std::function<bool(const Number3&)> seen;
  };
  const double wall = 0.9;
  std::vector<Case> levels;
  levels.push_back({wallTo(wall, black, black), [&](const Number3& w) { return w.y > -w.z * std::tan(wall); }});
  levels.push_back({canyonOf(8, 6, black, black), [](const Number3& w) { return w.y * 4 > std::abs(w.x) * 6; }});
  for (const Case& level : levels) {
    const geometry::Tracer tracer(level.surfaces);
    const transfer::TransferTracer transfer(tracer, settingsOf(1));
    for (std::size_t b = 0; b < 3; ++b) {
      const Number3 normal = transfer::transferBasis()[b];
      checkMeasured(
          measured(transfer, at, kProbes, [&](const transfer::TracedProbe& p) { return p.transfer.visibility[b]; }),
          skyIrradiance(normal, level.seen) / (det::kPi * (1 + kUpper) / 2), kHeight);
    }
  }
  // The well is so deep that its mouth is in front of every direction up: E is n . V, V vertical.
  const geometry::Surfaces well = wellOf(2, 4, 6, black, black);
  const geometry::Tracer tracer(well);
  const transfer::TransferTracer transfer(tracer, settingsOf(1, 1024));
  for (std::size_t b = 0; b < 3; ++b)
    checkMeasured(
        measured(transfer, at, kProbes, [&](const transfer::TracedProbe& p) { return p.transfer.visibility[b]; }),
        skyViewOfWell(2, 4, 6) * kUpper / ((1 + kUpper) / 2), kHeight);
}

TEST_CASE("Transfer, FurnaceIsExact") {
  // Every direction sees the same after any number of bounces, and directions are normalised by their sums.
  geometry::Surfaces s;
  addBoxInside(s, {-3, -2, -1}, {4, 5, 6}, addMaterial(s, Number3(0.6), false, {1, 2, 3}));
  const geometry::Tracer tracer(s);
  for (const int bounces : {0, 1, 5}) {
    const transfer::ProbeTransfer t = transfer::traceTransfer(tracer, {0.5, 1, 2}, settingsOf(bounces), {0, 0}, 0);
    const double sum = (1.0 - std::pow(0.6, bounces + 1)) / (1.0 - 0.6);
    for (std::size_t b = 0; b < transfer::kDirections; ++b) {
      CHECK(t.emitted[b].x == Approx(det::kPi * sum).epsilon(1e-12));
      CHECK(t.emitted[b].z == Approx(3 * det::kPi * sum).epsilon(1e-12));
      CHECK(t.visibility[b] == 0.0);
    }
  }
}

TEST_CASE("Transfer, SunThroughANarrowSlit") {
  // A roof 3 m above black and white ground has a slit of 2 cm along z: a bright strip. E(down) is rho Es sin(e) / 2
  // times the difference of the sines, seen from the probe in section. The ground lights nothing else that reflects.
  const double rho = 0.8;
  constexpr double kEnd = 200.0;  // metres; floats of corners further away blur the slit's edges
  const double half = 0.01;
  const double height = 1.0;
  geometry::Surfaces s = groundOf(Number3(rho), kEnd);
  const auto black = addMaterial(s, Number3(0.0), true);
  for (const double x : {-kEnd, half}) addQuad(s, {x, 3, -kEnd}, {kEnd - half, 0, 0}, {0, 0, 2 * kEnd}, black);
  const geometry::Tracer tracer(s);
  transfer::TransferSettings settings = settingsOf(1, 8192);
  settings.light_directions = {Number3(0, 1, 0), geometry::unit(Number3(0.2, 1, 0)),
                               geometry::unit(Number3(0.2, 1, 0.7))};
  const transfer::TransferTracer transfer(tracer, settings);
  for (std::size_t i = 0; i < settings.light_directions.size(); ++i) {
    const Number3& light = settings.light_directions[i];
    const double middle = -3.0 * light.x / light.y;
    const auto sine = [&](double x) { return x / std::sqrt(x * x + height * height); };
    const double expected = rho * light.y * (sine(middle + half) - sine(middle - half)) / 2.0;
    const auto m = measured(transfer, {0, height, 0}, kProbes,
                            [&](const transfer::TracedProbe& p) { return p.transfer.sun[3][i].y; });
    checkMeasured(m, expected, 0.0);
    CHECK(m.standard_error < 0.1 * expected);
  }
}

}  // namespace welkin::tests
