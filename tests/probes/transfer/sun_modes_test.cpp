// SPDX-License-Identifier: Apache-2.0
#include "probes/transfer/sun_modes.h"

#include <catch2/catch.hpp>

#include "probes/transfer/relight.h"
#include "tests/probes/closed_forms/closed_forms.h"
#include "transfer_helpers.h"

namespace welkin::tests {

using f64::Number3;
namespace {

/// A sun that rises in the east at 6 and stands 70 degrees high in the south at noon.
Number3 sunAt(double time_h) {
  const double hour = det::kTwoPi * (time_h - 6.0) / 24.0;
  const double tilt = 70.0 * det::kPi / 180.0;
  return {std::cos(hour), std::sin(hour) * std::sin(tilt), std::sin(hour) * std::cos(tilt)};
}

std::vector<const transfer::ProbeTransfer*> pointersTo(const std::vector<transfer::ProbeTransfer>& probes) {
  std::vector<const transfer::ProbeTransfer*> result;
  for (const transfer::ProbeTransfer& p : probes) result.push_back(&p);
  return result;
}

/// Probes across a street with buildings of two heights. They are few and have many paths, for accurate transfers.
std::vector<transfer::ProbeTransfer> streetProbes(const transfer::LightTrack& sun) {
  geometry::Surfaces s = canyonOf(10, 6, {0.3, 0.3, 0.25}, {0.6, 0.5, 0.4});
  addQuad(s, {-5, 6, -4000}, {0, 5, 0}, {0, 0, 4000}, 0);
  const geometry::Tracer tracer(s);
  transfer::TransferSettings settings;
  settings.rays = 4096;
  settings.ground_albedo = Number3(0.3);
  settings.light_directions = sun.direction;
  const transfer::TransferTracer transfer(tracer, settings);
  std::vector<transfer::ProbeTransfer> probes;
  for (std::size_t i = 0; i < 10; ++i)
    probes.push_back(transfer
                         .trace({-4.5 + static_cast<double>(i), 1.0 + 0.5 * static_cast<double>(i % 3),
                                 -6.0 + 1.5 * static_cast<double>(i)},
                                {0, 0}, i)
                         .transfer);
  return probes;
}

}  // namespace

TEST_CASE("LightTrack, KnotsAreWhereTheLightIsUp") {
  const transfer::LightTrack track = transfer::trackOf(sunAt, 48);
  REQUIRE(track.time_h.size() == 25);
  CHECK(track.time_h.front() == Approx(6.0).margin(1e-6));
  CHECK(track.time_h.back() == Approx(18.0).margin(1e-6));
  CHECK(track.time_h[6] == Approx(9.0).margin(1e-12));
  for (const Number3& direction : track.direction) CHECK(direction.y > 0.0);
  CHECK(std::is_sorted(track.time_h.begin(), track.time_h.end()));
  // Crossings between knots; a stretch across midnight; always up, never up.
  const transfer::LightTrack odd = transfer::trackOf([](double t) { return sunAt(t - 0.3); }, 24);
  CHECK(odd.time_h.front() == Approx(6.3));
  CHECK(odd.time_h.back() == Approx(18.3));
  CHECK(odd.direction.front().y < 1e-9);
  const transfer::LightTrack night = transfer::trackOf([](double t) { return sunAt(t + 12.0); }, 24);
  CHECK(night.time_h.front() == 0.0);
  CHECK(night.time_h.back() == 23.0);
  CHECK(transfer::trackOf([](double) { return Number3(0, 1, 0); }, 24).time_h.size() == 24);
  CHECK(transfer::trackOf([](double) { return Number3(0, -1, 0); }, 24).time_h.empty());
}

TEST_CASE("LightTrack, PlacesAreLinearAndPeriodic") {
  const std::vector<double> times{1.0, 2.0, 23.0};
  const auto at = [&](double t) { return transfer::placeOnTrack(times, t); };
  CHECK(at(1.25).before == 0);
  CHECK(at(1.25).after == 1);
  CHECK(at(1.25).share == Approx(0.25));
  CHECK(at(25.25).share == Approx(0.25));
  CHECK(at(-22.75).share == Approx(0.25));
  for (const double t : {23.5, 0.25, -0.5}) {
    CHECK(at(t).before == 2);
    CHECK(at(t).after == 0);
  }
  CHECK(at(23.5).share == Approx(0.25));
  CHECK(at(0.25).share == Approx(0.625));
  CHECK(at(-1e-300).share == Approx(0.5));
  CHECK(transfer::placeOnTrack({7.0}, 3.0).before == 0);
}

TEST_CASE("SunModes, FewModesOfWhatHasFew") {
  // Transfers are sums of two coloured functions of time, so two modes suffice and one does not.
  const transfer::LightTrack sun = transfer::trackOf(sunAt, 48);
  transfer::LightTrack moon;
  moon.time_h = {1.0, 2.0};
  moon.direction = {Number3(0, 1, 0), Number3(0, 1, 0)};
  std::vector<transfer::ProbeTransfer> probes(7);
  geometry::Random random(2);
  for (transfer::ProbeTransfer& p : probes)
    for (auto& direction : p.sun) {
      const Number3 a = Number3(0.9, 0.5, 0.2) * random.unit();
      const Number3 b = Number3(0.1, 0.6, 0.7) * random.unit();
      for (const Number3& light : sun.direction) direction.push_back(a * light.y + b * (light.x * light.x));
      direction.push_back(a * 0.3);
      direction.push_back(b * 0.7);
    }
  const transfer::SunModesFit fit = transfer::fitSunModes(pointersTo(probes), sun, moon, transfer::kMostSunModes);
  CHECK(fit.modes.count() == 2);
  REQUIRE(fit.error.size() == 3);
  CHECK(fit.error[0].worst > 0.5);
  CHECK(fit.error[1].worst_row > 1e-3);
  CHECK(fit.error[2].worst < 1e-12);
  CHECK(transfer::modesFor(fit, 1e-6) == 2);
  CHECK(transfer::modesFor(fit, 10.0) == 0);
  CHECK(transfer::modesFor(fit, 0.0) == 2);
  // At a knot, between knots, and for the moon.
  const auto noon = transfer::modesAt(fit.modes, transfer::LightOf::sun, 12.0);
  const auto between = transfer::modesAt(fit.modes, transfer::LightOf::sun, 12.25);
  const auto night = transfer::modesAt(fit.modes, transfer::LightOf::moon, 1.75);
  for (std::size_t p = 0; p < probes.size(); ++p)
    for (std::size_t b = 0; b < transfer::kDirections; ++b) {
      const auto& truth = probes[p].sun[b];
      const auto& c = fit.coefficient[p][b];
      CHECK(transfer::sunTransfer(c, noon).y == Approx(truth[12].y));
      CHECK(transfer::sunTransfer(c, between).z == Approx((truth[12].z + truth[13].z) / 2));
      CHECK(transfer::sunTransfer(c, night).x == Approx(truth[25].x * 0.25 + truth[26].x * 0.75));
    }
  const transfer::SunModesFit one = transfer::firstModes(fit, 1);
  CHECK(one.modes.count() == 1);
  CHECK(one.coefficient[3][1].size() == 1);
  CHECK(one.error.size() == 2);
}

TEST_CASE("SunModes, NothingToHold") {
  const transfer::LightTrack sun = transfer::trackOf(sunAt, 24);
  std::vector<transfer::ProbeTransfer> dark(3);
  for (transfer::ProbeTransfer& p : dark)
    for (auto& direction : p.sun) direction.resize(sun.time_h.size());
  const transfer::SunModesFit fit = transfer::fitSunModes(pointersTo(dark), sun, {}, 4);
  CHECK(fit.modes.count() == 0);
  CHECK(fit.error[0].worst == 0.0);
  CHECK(transfer::fitSunModes({}, sun, {}, 4).modes.count() == 0);
  const std::vector<transfer::ProbeTransfer> plain(2);
  CHECK(transfer::fitSunModes(pointersTo(plain), {}, {}, 4).modes.count() == 0);
  CHECK(transfer::modesAt(fit.modes, transfer::LightOf::moon, 3.0).empty());
}

TEST_CASE("SunModes, RebuiltTransferIsNotNegative") {
  CHECK(transfer::sunTransfer(std::vector{0.5}, std::vector{Number3(1, -1, 0.5)}) == Number3(0.5, 0, 0.25));
}

TEST_CASE("SunModes, EachMakesAStreetBetter") {
  const transfer::LightTrack sun = transfer::trackOf(sunAt, 48);
  const auto probes = streetProbes(sun);
  const transfer::SunModesFit fit = transfer::fitSunModes(pointersTo(probes), sun, {}, transfer::kMostSunModes);
  REQUIRE(fit.modes.count() == transfer::kMostSunModes);
  for (std::size_t m = 1; m <= transfer::kMostSunModes; ++m) CHECK(fit.error[m].rms < fit.error[m - 1].rms);
  // For comparison, the sun in 2 bands, through the sky's transfer.
  double square = 0.0;
  std::size_t count = 0;
  for (const transfer::ProbeTransfer& p : probes)
    for (std::size_t i = 0; i < sun.time_h.size(); ++i) {
      const auto sh = transfer::relit(
          p, {},
          transfer::relightAt(sun.time_h[i], {}, {sun.direction[i], Number3(1.0)}, {}, transfer::SunTransfer::sh, {}));
      for (std::size_t b = 0; b < transfer::kDirections; ++b)
        for (int c = 0; c < 3; ++c, ++count) {
          const double difference = sh.sun_bounce[b][c] - p.sun[b][i][c];
          square += difference * difference;
        }
    }
  const double sh_rms = std::sqrt(square / static_cast<double>(count));
  CAPTURE(sh_rms, fit.error[0].rms, fit.error[1].rms, fit.error[2].rms, fit.error[3].rms, fit.error[4].rms,
          fit.error[6].rms, fit.error[8].rms, fit.error[10].rms);
  CHECK(fit.error[4].rms < 0.5 * sh_rms);
  CHECK(fit.error[8].rms < 0.25 * sh_rms);
}

}  // namespace welkin::tests
