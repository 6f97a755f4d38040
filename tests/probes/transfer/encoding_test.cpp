// SPDX-License-Identifier: Apache-2.0
#include "probes/transfer/encoding.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "probes/geometry/random.h"
#include "probes/transfer/fixed_point.h"
#include "sky/base/error.h"

namespace welkin::tests {

using f64::Number3;
namespace {

double scaleOfProbe(std::size_t probe) {
  return probe % 2 == 0 ? 1.0 : 1000.0;
}

Number3 magnitudes(const Number3& v) {
  return {std::abs(v.x), std::abs(v.y), std::abs(v.z)};
}

/// Different numbers everywhere; probe 1 is a thousand times as bright as probe 0. Half of the numbers that may be
/// negative are.
transfer::SectorProbes someProbes(std::size_t count, std::size_t modes, bool emissive) {
  transfer::SectorProbes s;
  s.id = {-2, 3};
  geometry::Random random(count, modes);
  const auto colour = [&](double scale) {
    return Number3(2 * random.unit() - 1, 2 * random.unit() - 1, 2 * random.unit() - 1) * scale;
  };
  for (std::size_t i = 0; i < 30; ++i) s.modes.sun_time_h.push_back(5.0 + 0.5 * static_cast<double>(i) * 0.9);
  s.modes.moon_time_h = {0.25, 1.0 / 3.0};
  for (std::size_t i = 0; i < modes * s.modes.knots(); ++i) s.modes.value.push_back(colour(0.25));
  for (std::size_t p = 0; p < count; ++p) {
    s.position.emplace_back(-128 + 64 * random.unit(), -30 + 90 * random.unit(), 192 + 64 * random.unit());
    transfer::ProbeTransfer& t = s.transfer.emplace_back();
    transfer::SunCoefficients& sun = s.sun.emplace_back();
    const double scale = scaleOfProbe(p);
    for (std::size_t b = 0; b < transfer::kDirections; ++b) {
      if (b < 3) t.visibility[b] = random.unit();
      for (Number3& k : t.sky[b]) k = colour(scale);
      for (std::size_t k = 0; k < 2; ++k) t.sky[b][k] = magnitudes(t.sky[b][k]);
      for (std::size_t m = 0; m < modes; ++m) sun[b].push_back(colour(scale / std::pow(10.0, m)).x);
      if (emissive) t.emitted[b] = magnitudes(colour(scale));
    }
  }
  return s;
}

double largestOf(const transfer::ProbeTransfer& t) {
  double largest = 0.0;
  for (const auto& direction : t.sky)
    for (const Number3& k : direction) largest = std::max({largest, std::abs(k.x), std::abs(k.y), std::abs(k.z)});
  return largest;
}

}  // namespace

TEST_CASE("Encoding, FixedPointIsWithinHalfAStep") {
  for (const double largest : {1.0, 1.00390625, 1.0039063, 3.9e-5, 2.5e20, 1e-37}) {
    const double scale = transfer::scaleOf(transfer::scaleFor(largest));
    CHECK(scale >= largest);
    CHECK(scale <= largest * (1.0 + 0x1p-7));
    for (const double share : {-1.0, -0.37, 0.0, 0.61, 1.0}) {
      CHECK(std::abs(transfer::fromFixed(transfer::toFixed<std::int16_t>(share * largest, scale), scale) -
                     share * largest) <= scale / 65533.0);
      CHECK(std::abs(transfer::fromFixed(transfer::toFixed<std::int8_t>(share * largest, scale), scale) -
                     share * largest) <= scale / 253.0);
      if (share >= 0.0)
        CHECK(std::abs(transfer::fromFixed(transfer::toFixed<std::uint8_t>(share * largest, scale), scale) -
                       share * largest) <= scale / 509.0);
    }
  }
  CHECK(transfer::scaleFor(0.0) == 0);
  CHECK(transfer::toFixed<std::int16_t>(0.0, 0.0) == 0);
  CHECK(transfer::fromFixed(transfer::toFixed<std::uint16_t>(1.0, 1.0), 1.0) == 1.0);
}

TEST_CASE("Encoding, EveryNumberComesBack") {
  for (const bool emissive : {false, true}) {
    const transfer::SectorProbes probes = someProbes(5, 3, emissive);
    const transfer::SectorProbes decoded = transfer::decodedProbes(transfer::encodeProbes(probes), probes.id);
    REQUIRE(decoded.position.size() == 5);
    REQUIRE(decoded.modes.count() == 3);
    // Half a step; the scale is up to 1/128 above the largest.
    constexpr double kHalf = 0.5 * (1.0 + 1.0 / 128);
    for (std::size_t p = 0; p < 5; ++p) {
      const transfer::ProbeTransfer& a = probes.transfer[p];
      const transfer::ProbeTransfer& b = decoded.transfer[p];
      CHECK(std::abs(decoded.position[p].x - probes.position[p].x) <= 0.5 * 64 / 65535 + 1e-12);
      CHECK(std::abs(decoded.position[p].y - probes.position[p].y) <= 0.5 * 90 / 65535);
      CHECK(std::abs(decoded.position[p].z - probes.position[p].z) <= 0.5 * 64 / 65535 + 1e-12);
      CHECK(b.visibility[3] == 0.0);
      for (std::size_t d = 0; d < transfer::kDirections; ++d) {
        CHECK(std::abs(a.visibility[d] - b.visibility[d]) <= 0.5 / 65535 + 1e-15);
        // The tolerance is a step of the sector's largest number for modes, and of the probe's own for coefficients.
        for (std::size_t m = 0; m < 3; ++m) {
          const double scale = scaleOfProbe(p) / std::pow(10.0, m);
          CHECK(std::abs(probes.sun[p][d][m] - decoded.sun[p][d][m]) <= 1.3 * kHalf / 127 * scale);
        }
        for (int c = 0; c < 3; ++c) {
          for (std::size_t k = 0; k < 4; ++k)
            CHECK(std::abs(a.sky[d][k][c] - b.sky[d][k][c]) <= kHalf / (k < 2 ? 255 : 127) * largestOf(a));
          CHECK(std::abs(a.emitted[d][c] - b.emitted[d][c]) <= kHalf / 255 * scaleOfProbe(p));
        }
      }
    }
    for (std::size_t i = 0; i < probes.modes.value.size(); ++i)
      for (int c = 0; c < 3; ++c)
        CHECK(std::abs(decoded.modes.value[i][c] - probes.modes.value[i][c]) <= 0.25 * kHalf / 127);
    CHECK(decoded.modes.sun_time_h[7] == Approx(probes.modes.sun_time_h[7]).epsilon(1e-7));
    CHECK(decoded.modes.moon_time_h[1] == Approx(1.0 / 3).epsilon(1e-7));
    // Decoded probes encode to the same bytes.
    CHECK(transfer::encodeProbes(decoded).sky == transfer::encodeProbes(probes).sky);
    CHECK(transfer::encodeProbes(decoded).sky_side == transfer::encodeProbes(probes).sky_side);
  }
}

TEST_CASE("Encoding, BytesAreWithinTheBudget") {
  // The talk has 152 bytes a probe, and 15 KB for a sector of 70 with its grid.
  constexpr std::size_t kGrid = 4096;
  CHECK(transfer::encodeProbes(someProbes(70, 0, false)).bytesAProbe() == 62);
  CHECK(transfer::encodeProbes(someProbes(70, 0, true)).bytesAProbe() == 76);
  CHECK(transfer::encodeProbes(someProbes(70, transfer::kMostSunModes, true)).bytesAProbe() == 142);
  const transfer::EncodedProbes ten = transfer::encodeProbes(someProbes(70, 10, true));
  const transfer::ProbeBytes bytes = ten.bytes();
  CHECK(bytes.position == 70 * 6);
  CHECK(bytes.visibility == 70 * 6);
  CHECK(bytes.sky == 70 * 48);
  CHECK(bytes.sun == 70 * 40);
  CHECK(bytes.emitted == 70 * 12);
  CHECK(bytes.scales == 70 * 6);
  CHECK(bytes.heights == 8);
  CHECK(bytes.modes == 32 * 4 + 10 * (2 * 4 + 3 * 32));
  CHECK(ten.bytesAProbe() == 118);
  CHECK(bytes.total() == 70 * 118 + 8 + bytes.modes);
  CHECK(bytes.total() + kGrid <= 15 * 1024);
}

TEST_CASE("Encoding, EdgesOfTheSectorAndNoProbes") {
  transfer::SectorProbes probes = someProbes(2, 0, false);
  probes.position = {{-128, 7, 256}, {-64, 7, 192}};  // its corners, all at one height
  const transfer::SectorProbes decoded = transfer::decodedProbes(transfer::encodeProbes(probes), probes.id);
  for (std::size_t i = 0; i < 2; ++i) CHECK(decoded.position[i] == probes.position[i]);
  transfer::SectorProbes none;
  none.id = {1, 1};
  const transfer::EncodedProbes encoded = transfer::encodeProbes(none);
  CHECK(encoded.bytesAProbe() == 0);
  CHECK(transfer::decodedProbes(encoded, none.id).position.empty());
  // A dark probe is exactly dark.
  probes.transfer[0] = transfer::ProbeTransfer{};
  CHECK(transfer::decodedProbes(transfer::encodeProbes(probes), probes.id).transfer[0].sky[2][1] == Number3(0.0));
}

TEST_CASE("Encoding, WhatItCannotHoldIsRefused") {
  const auto refused = [](auto&& change) {
    transfer::SectorProbes probes = someProbes(2, 1, true);
    change(probes);
    CHECK_THROWS_AS(transfer::encodeProbes(probes), base::Error);
  };
  refused([](transfer::SectorProbes& s) { s.position[1].x = -63.9; });
  refused([](transfer::SectorProbes& s) { s.position[0].y = std::nan(""); });
  refused([](transfer::SectorProbes& s) { s.transfer[1].visibility[0] = 1.001; });
  refused([](transfer::SectorProbes& s) { s.transfer[1].visibility[3] = 0.001; });
  refused([](transfer::SectorProbes& s) { s.transfer[0].sky[1][2].y = std::nan(""); });
  refused([](transfer::SectorProbes& s) { s.transfer[0].sky[1][0].x = -1e-9; });
  refused([](transfer::SectorProbes& s) { s.transfer[1].sky[3][1].z = -1e-9; });
  refused([](transfer::SectorProbes& s) { s.sun[0][1][0] = INFINITY; });
  refused([](transfer::SectorProbes& s) { s.transfer[0].emitted[1].x = -0.1; });
  transfer::EncodedProbes cut = transfer::encodeProbes(someProbes(2, 1, true));
  cut.sky.pop_back();
  CHECK_THROWS_AS(transfer::decodedProbes(cut, {0, 0}), base::Error);
  cut = transfer::encodeProbes(someProbes(2, 1, true));
  cut.sky_side.pop_back();
  CHECK_THROWS_AS(transfer::decodedProbes(cut, {0, 0}), base::Error);
}

}  // namespace welkin::tests
