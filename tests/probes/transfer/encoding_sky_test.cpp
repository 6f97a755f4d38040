// SPDX-License-Identifier: Apache-2.0
// Encoding of the sky's transfer by hand, and the measured and bounded effect of its rounding on irradiance.
#include <catch2/catch.hpp>
#include <cmath>

#include "probes/geometry/directions.h"
#include "probes/geometry/random.h"
#include "probes/transfer/encoding_error.h"
#include "probes/transfer/relight.h"
#include "sh/deterministic.h"

namespace welkin::tests {

using f64::Number3;
namespace {

using Coefficients = std::array<double, 4>;

/// Probes with these transfers at one place.
transfer::SectorProbes probesOf(const std::vector<transfer::ProbeTransfer>& transfer) {
  transfer::SectorProbes probes;
  probes.transfer = transfer;
  probes.position.resize(transfer.size());
  probes.sun.resize(transfer.size());
  return probes;
}

transfer::SectorProbes reread(const transfer::SectorProbes& probes) {
  return transfer::decodedProbes(transfer::encodeProbes(probes), probes.id);
}

/// All light comes from `from`, which is above the horizon.
transfer::ProbeTransfer pinhole(const Number3& from, double irradiance) {
  const det::ShBasis basis = det::shBasis(from);
  transfer::ProbeTransfer t;
  for (auto& direction : t.sky)
    for (std::size_t k = 0; k < 4; ++k) direction[k] = Number3(irradiance * basis.v[k]);
  return t;
}

/// Coefficients of skies of radiance 1 in one part and 0 elsewhere: above an elevation, and in half of the azimuths.
std::vector<Coefficients> partsOfTheSky() {
  std::vector<Coefficients> skies;
  for (int i = 0; i < 8; ++i) {
    const double sine = i / 8.0;
    skies.push_back({det::kShConstant * det::kTwoPi * (1 - sine), det::kShLinear * det::kPi * (1 - sine * sine), 0, 0});
  }
  for (int i = 0; i < 16; ++i) {
    const double azimuth = i * det::kPi / 8.0;
    const double side = det::kShLinear * det::kPi / 2.0;
    skies.push_back({det::kShConstant * det::kPi, side, side * std::sin(azimuth), side * std::cos(azimuth)});
  }
  return skies;
}

/// The worst difference of the bounced irradiance under a sky, over pi.
double worstUnder(const Coefficients& sky, const transfer::SectorProbes& a, const transfer::SectorProbes& b) {
  double worst = 0.0;
  for (std::size_t i = 0; i < a.transfer.size(); ++i)
    for (std::size_t d = 0; d < transfer::kDirections; ++d)
      for (int c = 0; c < 3; ++c) {
        double difference = 0.0;
        for (std::size_t k = 0; k < 4; ++k)
          difference += sky[k] * (a.transfer[i].sky[d][k][c] - b.transfer[i].sky[d][k][c]);
        worst = std::max(worst, std::abs(difference) / det::kPi);
      }
  return worst;
}

}  // namespace

TEST_CASE("EncodingOfSky, EveryNumberHasItsByte") {
  for (std::size_t b = 0; b < transfer::kDirections; ++b)
    for (std::size_t k = 0; k < 4; ++k)
      for (std::size_t c = 0; c < 3; ++c) {
        transfer::ProbeTransfer t;
        t.sky[b][k][static_cast<int>(c)] = k == 3 ? -0.75 : 0.75;
        const transfer::EncodedProbes encoded = transfer::encodeProbes(probesOf({transfer::ProbeTransfer{}, t}));
        CHECK(encoded.sky_scale == std::vector<std::uint16_t>{0, 0x3f40});
        std::vector<std::uint8_t> sky(48);
        std::vector<std::int8_t> side(48);
        const std::size_t at = 24 + (b * 2 + k % 2) * 3 + c;
        if (k < 2) sky[at] = 255;
        if (k == 2) side[at] = 127;
        if (k == 3) side[at] = -127;
        CHECK(encoded.sky == sky);
        CHECK(encoded.sky_side == side);
        CHECK(reread(probesOf({t})).transfer[0].sky == t.sky);
      }
}

TEST_CASE("EncodingOfSky, RoundsToTheNearestStep") {
  transfer::ProbeTransfer t;
  t.sky[0][0] = {1.0, 0.5, 0.25};  // 127.5 and 63.75 steps of 1 / 255
  t.sky[0][1] = {0.4999 / 255, 0.5001 / 255, 0.0};
  t.sky[2][2] = {-1.0, 0.25, -0.25};  // 31.75 steps of 1 / 127
  t.sky[2][3] = {0.4999 / 127, -0.4999 / 127, -0.5001 / 127};
  const transfer::EncodedProbes e = transfer::encodeProbes(probesOf({t}));
  const auto sky = std::vector<int>(e.sky.begin(), e.sky.begin() + 6);
  CHECK(sky == std::vector<int>{255, 128, 64, 0, 1, 0});
  const auto side = std::vector<int>(e.sky_side.begin() + 12, e.sky_side.begin() + 18);
  CHECK(side == std::vector<int>{-127, 32, -32, 0, 0, -1});
}

TEST_CASE("EncodingOfSky, EmittedLightLikewise") {
  transfer::ProbeTransfer t;
  t.emitted[3] = {2.0, 1.0, 0.5};
  const transfer::EncodedProbes e = transfer::encodeProbes(probesOf({t, transfer::ProbeTransfer{}}));
  CHECK(e.emitted_scale == std::vector<std::uint16_t>{0x4000, 0});
  const auto emitted = std::vector<int>(e.emitted.begin() + 9, e.emitted.begin() + 13);
  CHECK(emitted == std::vector<int>{255, 128, 64, 0});
}

TEST_CASE("EncodingOfSky, EveryProbeHasItsOwnRange") {
  // The sector spans twelve decades: each probe's error is relative to its own size, and a dark probe stays dark.
  std::vector<transfer::ProbeTransfer> transfer(1);
  for (const double irradiance : {1e-6, 1.0, 1e6})
    transfer.push_back(pinhole(geometry::unit(Number3(0.6, 0.7, -0.2)), irradiance));
  const transfer::SectorProbes probes = probesOf(transfer);
  const transfer::SectorProbes decoded = reread(probes);
  CHECK(decoded.transfer[0].sky == transfer::ProbeTransfer{}.sky);
  for (std::size_t i = 1; i < transfer.size(); ++i) {
    const double largest = transfer[i].sky[0][1].x;
    const double half = 0.5 * (1.0 + 1.0 / 128) * largest;  // the scale is up to 1/128 above the largest
    for (std::size_t k = 0; k < 4; ++k)
      CHECK(std::abs(decoded.transfer[i].sky[1][k].y - transfer[i].sky[1][k].y) <= half / (k < 2 ? 255 : 127));
  }
  // Numbers below half a step of their probe's largest are lost.
  transfer::ProbeTransfer uneven;
  uneven.sky[3][0] = {1.0, 1e-3, 3e-3};
  const auto steps = transfer::encodeProbes(probesOf({uneven})).sky;
  CHECK(std::vector<int>(steps.begin() + 18, steps.begin() + 21) == std::vector<int>{255, 0, 1});
}

TEST_CASE("EncodingOfSky, APinholeKeepsItsPlace") {
  // The light let in is largest there; no hemisphere is left out.
  for (const Number3& from :
       {Number3(0, 1, 0), Number3(1, 0, 0), Number3(-1, 0, 0), Number3(0, 0, 1), Number3(0, 0, -1),
        geometry::unit(Number3(-0.3, 0.1, 0.9)), geometry::unit(Number3(0.5, 0.5, -0.5))}) {
    const transfer::SectorProbes probes = probesOf({pinhole(from, 0.3)});
    const transfer::SectorProbes decoded = reread(probes);
    // A disc of 1 sr and radiance 1 is the sky of the most irradiance through the pinhole.
    const det::ShBasis basis = det::shBasis(from);
    double got = 0.0;
    for (std::size_t k = 0; k < 4; ++k) got += decoded.transfer[0].sky[2][k].y * basis.v[k];
    // The squares of two bands sum to 4 / (4 pi). Half steps of three numbers of length 1 and of the constant sum to
    // one.
    constexpr double kSteps = 0.3 * det::kShLinear * det::kShLinear / 127;
    CHECK(std::abs(got - 0.3 / det::kPi) <= kSteps);
    for (std::size_t k = 2; k < 4; ++k)
      if (basis.v[k] == 0.0) CHECK(decoded.transfer[0].sky[0][k].x == 0.0);
  }
}

TEST_CASE("EncodingOfSky, ItsErrorIsThatOfTheNumbers") {
  const transfer::SectorProbes probes = probesOf({pinhole(geometry::unit(Number3(0.6, 0.7, -0.2)), 1.0)});
  const auto errorOf = [&](auto&& change) {
    transfer::SectorProbes other = probes;
    change(other);
    return transfer::encodingError(probes, other);
  };
  CHECK(errorOf([](transfer::SectorProbes&) {}).sky == 0.0);
  // A uniform sky has sqrt(pi) and sqrt(3 pi) / 2; half of it sqrt(3 pi) / 4 to its side.
  CHECK(errorOf([](transfer::SectorProbes& s) { s.transfer[0].sky[0][0].x += 0.125; }).sky ==
        Approx(0.125 / std::sqrt(det::kPi)));
  CHECK(errorOf([](transfer::SectorProbes& s) { s.transfer[0].sky[1][1].y -= 0.125; }).sky ==
        Approx(0.125 * std::sqrt(0.75 / det::kPi)));
  CHECK(errorOf([](transfer::SectorProbes& s) { s.transfer[0].sky[2][2].z += 0.125; }).sky ==
        Approx(0.0625 * std::sqrt(0.75 / det::kPi)));
  const transfer::EncodingError error = errorOf([](transfer::SectorProbes& s) {
    s.position[0].y += 0.5;
    s.transfer[0].visibility[1] += 0.125;
    s.transfer[0].sky[2][3].z += 0.125;
    s.transfer[0].sky[3][3].z -= 0.125;  // belongs to another direction, so it is not added
  });
  CHECK(error.position_m == 0.5);
  CHECK(error.visibility == 0.125);
  CHECK(error.sky == Approx(0.0625 * std::sqrt(0.75 / det::kPi)));
  transfer::SectorProbes lit = probes;
  lit.transfer[0].emitted[2] = {0.5, 2.0, 1.0};
  transfer::SectorProbes other = lit;
  other.transfer[0].emitted[3].x = 0.25;
  CHECK(transfer::encodingError(lit, other).emitted == 0.125);
}

TEST_CASE("EncodingOfSky, ItsErrorBoundsIrradianceUnderAnySky") {
  std::vector<transfer::ProbeTransfer> transfer;
  geometry::Random random(6, 2026);
  for (int i = 0; i < 50; ++i) {
    transfer.push_back(
        pinhole(geometry::unit(Number3(2 * random.unit() - 1, random.unit(), 2 * random.unit() - 1)), 0.5));
    for (std::size_t d = 0; d < transfer::kDirections; ++d)
      for (Number3& k : transfer.back().sky[d]) k = k * Number3(1.0, random.unit(), 1e-2 * random.unit());
  }
  const transfer::SectorProbes probes = probesOf(transfer);
  const transfer::SectorProbes decoded = reread(probes);
  const double bound = transfer::encodingError(probes, decoded).sky;
  double worst = 0.0;
  for (const Coefficients& sky : partsOfTheSky()) worst = std::max(worst, worstUnder(sky, probes, decoded));
  CHECK(worst <= bound);
  CHECK(worst > 0.5 * bound);  // the bound is not loose
  // Half a step of each number, with a largest coefficient of 0.5 kShLinear.
  const double half = 0.5 * 0.5 * det::kShLinear * (1.0 + 1.0 / 128);
  CHECK(bound <= half * (std::sqrt(1 / det::kPi) / 255 + std::sqrt(0.75 / det::kPi) * (1.0 / 255 + 1.0 / 127)));
}

TEST_CASE("EncodingOfSky, TheSunsErrorIsOfClampedIrradiance") {
  transfer::SectorProbes probes = probesOf({transfer::ProbeTransfer{}});
  probes.modes.sun_time_h = {6.0, 12.0};
  probes.modes.value = {Number3(1.0), Number3(-1.0)};
  for (auto& direction : probes.sun[0]) direction = {0.25};
  transfer::SectorProbes other = probes;
  other.sun[0][2][0] = 0.5;  // at noon both are below 0
  CHECK(transfer::encodingError(probes, other).sun == 0.25);
  other.modes.value[0] = {1.0, 1.0, -1.0};
  CHECK(transfer::encodingError(probes, other).sun == 0.25);
  other.modes.value[1] = Number3(1.0);
  CHECK(transfer::encodingError(probes, other).sun == 0.5);
}

}  // namespace welkin::tests
