// SPDX-License-Identifier: Apache-2.0
// Encoding of local transfer in few bytes.
#include "probes/transfer/local_encoding.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "probes/geometry/random.h"
#include "sky/base/error.h"

namespace welkin::tests {

using f64::Number3;
namespace {

struct Traced {
  std::vector<Number3> light;
  std::vector<transfer::LocalProbe> probe;
};

/// Probes with `each` of `lights` lights, of very different influence.
Traced someTraced(std::size_t probes, std::size_t lights, std::size_t each) {
  geometry::Random random(17);
  Traced t;
  const auto number = [&] { return 2.0 * random.unit() - 1.0; };
  for (std::size_t l = 0; l < lights; ++l) t.light.push_back({90.0 * number(), 20.0 * number(), 90.0 * number()});
  for (std::size_t i = 0; i < probes; ++i) {
    transfer::LocalProbe& probe = t.probe.emplace_back();
    for (std::size_t j = 0; j < each; ++j) {
      transfer::LocalTransfer& transfer = probe.transfer.emplace_back();
      transfer.light = static_cast<std::uint32_t>((j * lights) / each);
      const double scale = std::pow(10.0, -4.0 * random.unit());
      for (std::size_t k = 0; k < 4; ++k)
        for (int c = 0; c < 3; ++c) transfer.radiance[k][c] = scale * (k == 0 ? std::abs(number()) : number());
    }
  }
  return t;
}

transfer::SectorLocal thinned(const Traced& t, std::size_t bytes = transfer::kMostLocalBytes) {
  transfer::LocalThinning thinning;
  return transfer::thinnedLocal(t.light, t.probe, bytes, thinning);
}

}  // namespace

TEST_CASE("LocalEncoding, EveryNumberComesBack") {
  const Traced t = someTraced(6, 40, 20);
  const transfer::SectorLocal local = thinned(t);
  const transfer::EncodedLocal encoded = transfer::encodeLocal(local);
  const transfer::SectorLocal decoded = transfer::decodedLocal(encoded);
  REQUIRE(decoded.probe.size() == 6);
  REQUIRE(local.light.size() == 20);  // the lights that some probe keeps
  CHECK(encoded.bytes() == 6 + 20 * 12 + 6 * 20 * 16);
  const transfer::LocalEncodingError error = transfer::encodingError(local, decoded);
  CHECK(error.position_m <= 0.5 * 0x1p-17);  // half a step of a float32 below 128
  CHECK(error.position_m > 0.0);
  // Half a step; the scale is up to 1/128 above the largest.
  CHECK(error.radiance <= 0.5 * (1.0 + 1.0 / 128) / 127);
  CHECK(error.radiance > 0.1 / 127);
  for (std::size_t i = 0; i < 6; ++i) {
    REQUIRE(decoded.probe[i].size() == 20);
    for (std::size_t j = 0; j < 20; ++j) {
      const transfer::LocalTransfer& before = t.probe[i].transfer[j];
      const transfer::LocalTransfer& after = decoded.probe[i][j];
      const Number3 moved = decoded.light[after.light] - t.light[before.light];
      CHECK(dot(moved, moved) <= 3.0 * error.position_m * error.position_m);
      double largest = 0.0;
      for (const Number3& k : before.radiance)
        largest = std::max({largest, std::abs(k.x), std::abs(k.y), std::abs(k.z)});
      for (std::size_t k = 0; k < 4; ++k)
        for (int c = 0; c < 3; ++c) CHECK(std::abs(after.radiance[k][c] - before.radiance[k][c]) <= 0.00397 * largest);
    }
  }
}

TEST_CASE("LocalEncoding, ThinningKeepsTheMostInfluential") {
  const Traced t = someTraced(120, 300, 128);
  transfer::LocalThinning thinning;
  const transfer::SectorLocal local = transfer::thinnedLocal(t.light, t.probe, transfer::kMostLocalBytes, thinning);
  const std::size_t bytes = transfer::encodeLocal(local).bytes();
  CHECK(bytes <= transfer::kMostLocalBytes);
  CHECK(bytes > transfer::kMostLocalBytes - 16 - 12);
  CHECK(thinning.kept + thinning.dropped == 120 * 128);
  CHECK(thinning.dropped > 0);
  double least = 1e9;
  double all = 0.0;
  double kept = 0.0;
  for (std::size_t i = 0; i < 120; ++i) {
    for (const transfer::LocalTransfer& x : local.probe[i]) {
      least = std::min(least, x.influence());
      kept += x.influence();
    }
    for (std::size_t j = 1; j < local.probe[i].size(); ++j)
      CHECK(local.probe[i][j - 1].light < local.probe[i][j].light);
  }
  std::size_t above = 0;
  for (const transfer::LocalProbe& probe : t.probe)
    for (const transfer::LocalTransfer& x : probe.transfer) {
      all += x.influence();
      if (x.influence() >= least) ++above;
    }
  CHECK(above == thinning.kept);
  CHECK(thinning.lost == Approx(1.0 - kept / all));
  CHECK(thinning.worst_probe >= thinning.lost);
  const transfer::SectorLocal everything = transfer::thinnedLocal(t.light, t.probe, 1 << 30, thinning);
  CHECK(thinning.dropped == 0);
  CHECK(thinning.lost == 0.0);
  CHECK(everything.light.size() == 128);
  CHECK(thinned(t, 120 + 16 + 12).light.size() == 1);  // room for a single one
  CHECK(thinned(t, 120 + 16 + 11).light.empty());
}

TEST_CASE("LocalEncoding, NoShareIsAboveAll") {
  transfer::LocalThinning thinning;
  const Traced t = someTraced(200, 300, 100);  // each probe loses everything, summed in two orders
  CHECK(transfer::thinnedLocal(t.light, t.probe, 200, thinning).light.empty());
  CHECK(thinning.lost == Approx(1.0));
  CHECK(thinning.lost <= 1.0);
  CHECK(thinning.worst_probe == 1.0);
}

TEST_CASE("LocalEncoding, WhatDoesNotFitIsRefused") {
  const transfer::SectorLocal local = thinned(someTraced(2, 10, 5));
  const transfer::EncodedLocal good = transfer::encodeLocal(local);
  const auto refused = [](auto change, auto whole, const auto& make) {
    change(whole);
    CHECK_THROWS_AS(make(whole), base::Error);
  };
  const auto decode = [](const transfer::EncodedLocal& e) { return transfer::decodedLocal(e); };
  refused([](transfer::EncodedLocal& e) { e.position.pop_back(); }, good, decode);
  refused([](transfer::EncodedLocal& e) { e.count[0] = 6; }, good, decode);
  refused([](transfer::EncodedLocal& e) { e.light.back() = 5; }, good, decode);
  refused([](transfer::EncodedLocal& e) { e.scale.pop_back(); }, good, decode);
  refused([](transfer::EncodedLocal& e) { e.radiance.pop_back(); }, good, decode);
  const auto encode = [](const transfer::SectorLocal& s) { return transfer::encodeLocal(s); };
  refused([](transfer::SectorLocal& s) { s.probe[1][2].radiance[3].x = std::nan(""); }, local, encode);
  refused([](transfer::SectorLocal& s) { s.probe[1][2].radiance[0].x = -1.0; }, local, encode);
  refused([](transfer::SectorLocal& s) { s.probe[1][2].light = 5; }, local, encode);
  refused([](transfer::SectorLocal& s) { s.light[0].y = 1e8; }, local, encode);
  refused([](transfer::SectorLocal& s) { s.probe[0].resize(129, s.probe[0][0]); }, local, encode);
}

}  // namespace welkin::tests
