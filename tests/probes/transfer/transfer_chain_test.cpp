// SPDX-License-Identifier: Apache-2.0
// The whole path of a sector's light: traced, fitted, encoded, decoded, relit, shaded; and the loss of reconstruction
// from four directions.
#include <catch2/catch.hpp>

#include "probes/transfer/encoding.h"
#include "probes/transfer/relight.h"
#include "tests/probes/closed_forms/closed_forms.h"
#include "transfer_helpers.h"

namespace welkin::tests {

using f64::Number3;
namespace {

/// A sun that rises in the east at 6 and stands in the zenith at noon.
Number3 chainSunAt(double time_h) {
  const double hour = det::kTwoPi * (time_h - 6.0) / 24.0;
  return {std::cos(hour), std::sin(hour), 0.0};
}

/// Irradiance by the sky of radiance 1 from four directions, direct and bounced.
double shadedSky(const transfer::TransferTracer& transfer, const Number3& at, const Number3& normal) {
  std::array<double, transfer::kDirections> mean{};
  constexpr std::size_t kProbes = 16;
  for (std::size_t i = 0; i < kProbes; ++i) {
    const transfer::ProbeTransfer t = transfer.trace(at, {0, 0}, i).transfer;
    for (std::size_t b = 0; b < transfer::kDirections; ++b) mean[b] += uniformSky(t, b) / kProbes;
  }
  return reconstructed(normal, mean);
}

}  // namespace

TEST_CASE("TransferChain, PlaneFromRaysToShading") {
  const Number3 rho(0.2, 0.35, 0.5);
  const geometry::Surfaces ground = groundOf(rho);
  const geometry::Tracer tracer(ground);
  const transfer::LightTrack track = transfer::trackOf(chainSunAt, 48);
  transfer::TransferSettings settings;
  settings.ground_albedo = rho;
  settings.light_directions = track.direction;
  const transfer::TransferTracer transfer(tracer, settings);
  transfer::SectorProbes probes;
  geometry::PlacedSector sector;
  std::vector<transfer::TracedProbe> traced;
  for (int i = 0; i < 16; ++i) sector.probe.push_back({{4.0 * i + 1, 1.0, 63.0 - 4.0 * i}});
  traced = transfer.trace(sector);
  std::vector<const transfer::ProbeTransfer*> all;
  for (std::size_t i = 0; i < traced.size(); ++i) {
    probes.position.push_back(sector.probe[i].position);
    probes.transfer.push_back(traced[i].transfer);
    all.push_back(&traced[i].transfer);
  }
  // Over a plane every probe's sun is one coloured function of time.
  const transfer::SunModesFit fit =
      transfer::firstModes(transfer::fitSunModes(all, track, {}, transfer::kMostSunModes), 1);
  probes.modes = fit.modes;
  probes.sun = fit.coefficient;
  const transfer::SectorProbes decoded = transfer::decodedProbes(transfer::encodeProbes(probes), probes.id);

  const std::array<Number3, 4> sky{Number3(std::sqrt(det::kPi)), Number3(std::sqrt(3.0 * det::kPi) / 2.0)};
  for (const double time : {6.001, 7.3, 9.0, 11.9, 16.25})
    for (const transfer::SunTransfer way : {transfer::SunTransfer::sh, transfer::SunTransfer::directional}) {
      const double sine = chainSunAt(time).y;
      const transfer::Relight light =
          transfer::relightAt(time, sky, {chainSunAt(time), Number3(2.0)}, {}, way, decoded.modes);
      for (const Number3& n : {Number3(0, 1, 0), Number3(0, -1, 0), geometry::unit(Number3(1, 0.2, -0.5))})
        for (int c = 0; c < 3; ++c) {
          double mean = 0.0;
          double squares = 0.0;
          const auto count = static_cast<double>(decoded.transfer.size());
          for (std::size_t i = 0; i < decoded.transfer.size(); ++i) {
            const auto total = transfer::relit(decoded.transfer[i], decoded.sun[i], light).total();
            const double e = reconstructed(n, {total[0][c], total[1][c], total[2][c], total[3][c]});
            mean += e / count;
            squares += e * e / count;
          }
          const double of_sun = way == transfer::SunTransfer::sh ? 0.25 + sine / 2.0 : sine;
          const double expected =
              det::kPi * ((1 + rho[c]) / 2 + (1 - rho[c]) / 2 * n.y) + rho[c] * 2.0 * of_sun * (1.0 - n.y) / 2.0;
          // error of 8 bits of mode and coefficient, for a sun of 2, and of the arc between knots half an hour apart
          constexpr double kEncoding = 2.0 * 1.5 / 127;
          constexpr double kArc = 2.0 * 0.0022;
          const double bound = way == transfer::SunTransfer::sh ? 1e-4 : kEncoding + kArc;
          checkMeasured({mean, std::sqrt(std::max(squares - mean * mean, 0.0) / (count - 1.0))}, expected,
                        rho[c] * bound + 1e-4);
        }
    }
}

TEST_CASE("TransferChain, WhatFourDirectionsLoseOfTheSky") {
  // Four directions lose light that is not linear in the normal. These are their errors for the ground.
  const Number3 black(0.0);
  const Number3 up(0, 1, 0);
  const Number3 at(0, 0.001, 0);
  transfer::TransferSettings settings;
  settings.bounces = 1;
  const auto excess = [&](const geometry::Surfaces& level, double view) {
    const geometry::Tracer tracer(level);
    return shadedSky(transfer::TransferTracer(tracer, settings), at, up) / det::kPi - view;
  };
  constexpr double kNoise = 0.01;  // noise of 16 probes, in shaded irradiance over pi
  CHECK(excess(wallTo(0.8, black, black), skyViewOfWall(0.8)) == Approx(-0.063).margin(kNoise));
  CHECK(excess(canyonOf(8, 4, black, black), skyViewOfCanyon(8, 4)) == Approx(-0.137).margin(kNoise));
  CHECK(excess(canyonOf(8, 8, black, black), skyViewOfCanyon(8, 8)) == Approx(-0.095).margin(kNoise));
  // A deep well's light is a vector: only up-facing directions see it, so 0 for down is too much for a linear field.
  const double view = skyViewOfWell(2, 4, 6);
  CHECK(excess(wellOf(2, 4, 6, black, black), view) ==
        Approx((2.0 / (1.0 + std::sqrt(3.0)) - 1.0) * view).margin(kNoise));
  // The white furnace is exact for every normal.
  geometry::Surfaces furnace;
  addBoxInside(furnace, {-2, -1, -3}, {3, 4, 2}, addMaterial(furnace, Number3(0.0), false, Number3(1.0)));
  const geometry::Tracer tracer(furnace);
  const transfer::ProbeTransfer t = transfer::traceTransfer(tracer, {0, 1, 0}, settings, {0, 0}, 0);
  for (const Number3& n : {up, -up, geometry::unit(Number3(3, -1, 1))})
    CHECK(reconstructed(n, {t.emitted[0].x, t.emitted[1].x, t.emitted[2].x, t.emitted[3].x}) ==
          Approx(det::kPi).epsilon(1e-12));
}

}  // namespace welkin::tests
