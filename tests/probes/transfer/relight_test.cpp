// SPDX-License-Identifier: Apache-2.0
#include "probes/transfer/relight.h"

#include <catch2/catch.hpp>

#include "tests/probes/closed_forms/closed_forms.h"
#include "transfer_helpers.h"

namespace welkin::tests {

using f64::Number3;
namespace {

const double kUniformConstant = std::sqrt(det::kPi);
const double kUniformLinear = std::sqrt(3.0 * det::kPi) / 2.0;

/// The transfer of a probe over an infinite plane, in closed form.
transfer::ProbeTransfer planeTransfer(const Number3& albedo) {
  transfer::ProbeTransfer t;
  const auto basis = transfer::transferBasis();
  for (std::size_t b = 0; b < transfer::kDirections; ++b) {
    const double below = (1.0 - basis[b].y) / 2.0;
    t.visibility[b] = b < 3 ? 1.0 : 0.0;
    t.sky[b][0] = albedo * (below * det::kPi * det::kShConstant);
    t.sky[b][1] = albedo * (below * det::kTwoPi / 3.0 * det::kShLinear);
  }
  return t;
}

/// Coefficients of a grey plane; the modes below are grey, too.
transfer::SunCoefficients planeSun(double albedo, const std::vector<Number3>& lights) {
  transfer::SunCoefficients sun;
  const auto basis = transfer::transferBasis();
  for (std::size_t b = 0; b < transfer::kDirections; ++b)
    for (const Number3& light : lights) sun[b].push_back(albedo * (1.0 - basis[b].y) / 2.0 * light.y);
  return sun;
}

/// Grey modes that are the knots themselves: coefficients are transfers.
transfer::SunModes knotsAsModes(const std::vector<double>& sun_time_h, const std::vector<double>& moon_time_h = {}) {
  transfer::SunModes modes;
  modes.sun_time_h = sun_time_h;
  modes.moon_time_h = moon_time_h;
  const std::size_t n = modes.knots();
  for (std::size_t i = 0; i < n * n; ++i) modes.value.emplace_back(i / n == i % n ? 1.0 : 0.0);
  return modes;
}

}  // namespace

TEST_CASE("Relight, PlaneUnderAUniformSky") {
  const Number3 rho(0.2, 0.5, 0.0);
  const std::array<Number3, 4> sky{Number3(1, 2, 3) * kUniformConstant, Number3(1, 2, 3) * kUniformLinear};
  const transfer::ProbeIrradiance e =
      transfer::relit(planeTransfer(rho), {},
                      transfer::relightAt(12, sky, {}, {}, transfer::SunTransfer::directional, transfer::SunModes{}));
  const auto total = e.total();
  for (std::size_t b = 0; b < 3; ++b) CHECK(total[b].x / det::kPi == Approx(0.83094).margin(5e-6));
  CHECK(total[3].x / det::kPi == Approx(0.2));
  std::array<double, transfer::kDirections> green{};
  for (std::size_t b = 0; b < transfer::kDirections; ++b) green[b] = total[b].y;
  for (const Number3& n : {Number3(0, 1, 0), Number3(0, 0, -1), geometry::unit(Number3(1, -2, 0.3))})
    CHECK(reconstructed(n, green) == Approx(2 * det::kPi * (0.75 + 0.25 * n.y)));
  CHECK(e.sun_bounce[0] == Number3(0.0));
  CHECK(e.local[0] == Number3(0.0));
}

TEST_CASE("Relight, PlaneUnderASunBothWays") {
  // With 2 bands a ground patch gets 1/4 + sin(e)/2 of the sun; with its own transfer, sin(e).
  const double rho = 0.3;
  const Number3 irradiance(3, 2, 1);
  for (const double elevation : {1e-6, 0.3, 1.0, det::kPi / 2}) {
    const Number3 direction = towards(1.1, elevation);
    const transfer::ProbeTransfer t = planeTransfer(Number3(rho));
    const transfer::SunCoefficients c = planeSun(rho, {direction});
    const transfer::SunModes modes = knotsAsModes({9.0});
    const transfer::LightAt sun{direction, irradiance};
    const auto sh =
        transfer::relit(t, c, transfer::relightAt(9, {}, sun, {}, transfer::SunTransfer::sh, modes)).sun_bounce;
    const auto directional =
        transfer::relit(t, c, transfer::relightAt(9, {}, sun, {}, transfer::SunTransfer::directional, modes))
            .sun_bounce;
    const auto none =
        transfer::relit(t, c, transfer::relightAt(9, {}, sun, {}, transfer::SunTransfer::none, modes)).sun_bounce;
    for (std::size_t b = 0; b < transfer::kDirections; ++b)
      for (int i = 0; i < 3; ++i) {
        const double full = rho * irradiance[i] * (1.0 - transfer::transferBasis()[b].y) / 2.0;
        CHECK(sh[b][i] == Approx(full * (0.25 + std::sin(elevation) / 2.0)));
        CHECK(directional[b][i] == Approx(full * std::sin(elevation)).margin(1e-15));
        CHECK(none[b][i] == 0.0);
      }
  }
}

TEST_CASE("Relight, EveryTermCountsOnce") {
  // All numbers differ, so that a wrong direction, coefficient, channel or light shows.
  transfer::ProbeTransfer t;
  transfer::SunCoefficients c_sun;
  geometry::Random random(11);
  const auto colour = [&] { return Number3(random.unit(), random.unit(), random.unit()); };
  for (std::size_t b = 0; b < transfer::kDirections; ++b) {
    t.visibility[b] = random.unit();
    for (Number3& k : t.sky[b]) k = colour();
    c_sun[b] = {random.unit(), random.unit(), random.unit()};
    t.emitted[b] = colour();
  }
  const std::array<Number3, 4> sky{colour(), colour(), colour(), colour()};
  const transfer::LightAt sun{geometry::unit(Number3(0.3, 0.8, -0.4)), colour()};
  const transfer::LightAt moon{geometry::unit(Number3(-0.7, 0.2, 0.1)), colour()};
  transfer::SunModes modes = knotsAsModes({6.0, 8.0}, {6.5});
  for (Number3& value : modes.value) value = value * colour();
  const transfer::RelightScale scale{0.5, 3.0};
  const auto e = transfer::relit(
      t, c_sun, transfer::relightAt(6.5, sky, sun, moon, transfer::SunTransfer::directional, modes, scale));
  const auto sh =
      transfer::relit(t, c_sun, transfer::relightAt(6.5, sky, sun, moon, transfer::SunTransfer::sh, modes, scale));
  for (std::size_t b = 0; b < transfer::kDirections; ++b)
    for (int c = 0; c < 3; ++c) {
      const Number3 n = transfer::transferBasis()[b];
      const auto y = [](const Number3& d) {
        const auto all = f64::shBasis(d);
        return std::array{all.v[0], all.v[1], all.v[2], all.v[3]};
      };
      double direct = 0.0;
      double bounced = 0.0;
      double lights = 0.0;
      for (std::size_t k = 0; k < 4; ++k) {
        direct += (k == 0 ? det::kPi : det::kTwoPi / 3) * sky[k][c] * y(n)[k];
        bounced += t.sky[b][k][c] * sky[k][c];
        lights +=
            t.sky[b][k][c] * (sun.irradiance[c] * y(sun.direction)[k] + moon.irradiance[c] * y(moon.direction)[k]);
      }
      CHECK(e.sky[b][c] == Approx(0.5 * (t.visibility[b] * direct + bounced)));
      CHECK(sh.sky[b][c] == e.sky[b][c]);
      CHECK(sh.sun_bounce[b][c] == Approx(3.0 * lights));
      const double sun_transfer =
          0.75 * c_sun[b][0] * modes.value[0][c] + 0.25 * c_sun[b][1] * modes.value[4][c];  // a quarter of the way
      const double moon_transfer = c_sun[b][2] * modes.value[8][c];
      CHECK(e.sun_bounce[b][c] ==
            Approx(3.0 * (sun_transfer * sun.irradiance[c] + moon_transfer * moon.irradiance[c])));
      CHECK(e.local[b][c] == t.emitted[b][c]);
      CHECK(e.total()[b][c] == Approx(e.sky[b][c] + e.sun_bounce[b][c] + e.local[b][c]));
    }
}

TEST_CASE("Relight, ALightBelowTheHorizonGivesNothing") {
  const transfer::ProbeTransfer t = planeTransfer(Number3(0.5));
  const transfer::SunCoefficients c = planeSun(0.5, {Number3(0, 1, 0)});
  const transfer::LightAt sun{geometry::unit(Number3(1, -1e-9, 0)), Number3(7.0)};
  for (const transfer::SunTransfer way : {transfer::SunTransfer::sh, transfer::SunTransfer::directional})
    CHECK(transfer::relit(t, c, transfer::relightAt(3, {}, sun, {}, way, knotsAsModes({12.0}))).sun_bounce[3] ==
          Number3(0.0));
}

TEST_CASE("Relight, FittedSkyIsExactForLinearRadiance") {
  // Coefficients of a + g . w over the upper hemisphere, by the midpoint rule, and their fit.
  const double a = 1.5;
  const Number3 g(0.3, 0.8, -0.4);
  std::array<double, 4> sh{};
  constexpr int kRows = 400;
  constexpr int kColumns = 800;
  for (int i = 0; i < kRows; ++i)
    for (int j = 0; j < kColumns; ++j) {
      const Number3 w = towards(det::kTwoPi * (j + 0.5) / kColumns, std::asin((i + 0.5) / kRows));
      const auto y = f64::shBasis(w);
      for (std::size_t k = 0; k < 4; ++k) sh[k] += (a + dot(g, w)) * y.v[k] * det::kTwoPi / (double{kRows} * kColumns);
    }
  const auto fitted = transfer::fittedToHemisphere({Number3(sh[0]), Number3(sh[1]), Number3(sh[2]), Number3(sh[3])});
  CHECK(fitted[0].x == Approx(a / det::kShConstant).epsilon(1e-5));
  CHECK(fitted[1].y == Approx(g.y / det::kShLinear).epsilon(1e-5));
  CHECK(fitted[2].z == Approx(g.z / det::kShLinear).epsilon(1e-5));
  CHECK(fitted[3].x == Approx(g.x / det::kShLinear).epsilon(1e-5));
  // Over a plane the fit is exact for every sky: irradiance is the coefficient of y, the cosine of level ground.
  const std::array<Number3, 4> sky{Number3(1.0), Number3(0.6), Number3(0.2), Number3(-0.3)};
  const transfer::ProbeTransfer plane = planeTransfer(Number3(0.5));
  const auto projected =
      transfer::relit(plane, {}, transfer::relightAt(0, sky, {}, {}, transfer::SunTransfer::none, {}));
  const auto by_fit = transfer::relit(
      plane, {}, transfer::relightAt(0, sky, {}, {}, transfer::SunTransfer::none, {}, {}, transfer::SkyBounce::fitted));
  const double open = det::kPi * sky[0].x * det::kShConstant + det::kTwoPi / 3 * sky[1].x * det::kShLinear;
  CHECK(projected.sky[3].x == Approx(0.5 * open));
  CHECK(by_fit.sky[3].x == Approx(0.5 * sky[1].x / det::kShLinear));
}

}  // namespace welkin::tests
