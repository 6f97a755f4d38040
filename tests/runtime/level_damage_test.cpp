// SPDX-License-Identifier: Apache-2.0
// Damaged sectors and indices under right checksums: the runtime refuses them, or gives finite light. The environment
// variable WELKIN_DAMAGE_TIMES multiplies the number of files: with 500 it is a million.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <random>

#include "format/container.h"
#include "tests/runtime/exercise_level.h"
#include "tests/runtime/random_level.h"

namespace welkin::tests {
namespace {

using transfer::SunTransfer;

/// Overwrites up to three places of a FlatBuffer.
void damage(std::vector<std::uint8_t>& payload, std::mt19937& random) {
  using Limits = std::numeric_limits<double>;
  const auto upTo = [&](std::size_t n) { return static_cast<std::size_t>(random()) % n; };
  const double doubles[] = {Limits::quiet_NaN(), Limits::infinity(), -0.0, 1e-320, 1e30, -1e30, 24.0};
  const float floats[] = {std::numeric_limits<float>::quiet_NaN(), 1e30F, -1e30F, 1e-40F, 23.0F, 64.0F};
  for (std::size_t n = 1 + upTo(3); n > 0; --n) {
    const std::size_t word = upTo(payload.size() / 8) * 8;
    const auto small = static_cast<std::uint32_t>(upTo(64));
    switch (upTo(5)) {
      case 0:
        payload[upTo(payload.size())] = static_cast<std::uint8_t>(random());
        break;
      case 1:
        payload[upTo(payload.size())] ^= static_cast<std::uint8_t>(1U << upTo(8));
        break;
      case 2:
        std::memcpy(payload.data() + word + 4 * upTo(2), &small, sizeof small);
        break;
      case 3:
        std::memcpy(payload.data() + word + 4 * upTo(2), &floats[upTo(std::size(floats))], sizeof(float));
        break;
      default:
        std::memcpy(payload.data() + word, &doubles[upTo(std::size(doubles))], sizeof(double));
    }
  }
}

/// Parts two cells by a wall each: one between two probes, one without.
void cutCells(sectors::SectorFile& sector) {
  sector.cuts.cell = {17, 4095};
  sector.cuts.tree = {0, 2};
  sector.cuts.node = {0, 0, 0x8000, 0x81ff, 0x8101};
  sector.cuts.plane = {{32767, 0, 2.5F}};
  sector.cuts.mask = {format::kAllOpen, format::kOwnOpen};
}

/// Damages a file 400 times, or a multiple of that.
void damageOften(std::span<const std::byte> file, format::Kind kind) {
  const char* times = std::getenv("WELKIN_DAMAGE_TIMES");
  const int count = 400 * (times == nullptr ? 1 : std::atoi(times));
  const auto* first = reinterpret_cast<const std::uint8_t*>(file.data()) + sizeof(format::Header);
  const std::vector<std::uint8_t> payload(first, first + file.size() - sizeof(format::Header));
  REQUIRE(exerciseFile(file).fault.empty());
  REQUIRE(exerciseFile(file).opened);
  std::mt19937 random(20121);
  int opened = 0;
  for (int i = 0; i < count; ++i) {
    auto forged = payload;
    damage(forged, random);
    const LevelExercise result = exerciseFile(format::seal(forged, kind));
    INFO("file " << i);
    REQUIRE(result.fault == "");
    opened += result.opened ? 1 : 0;
  }
  CHECK(opened > count / 20);  // fewer would prove nothing about relighting
  CHECK(opened < count);
}

}  // namespace

TEST_CASE("LevelDamage, ASectorUnderARightChecksumNeverCrashes") {
  for (const auto sun : {SunTransfer::none, SunTransfer::sh, SunTransfer::directional}) {
    // Of 200 probes, so that most bytes name one in the grid.
    RandomLevel baked(2, 200, sun == SunTransfer::directional ? 4 : 0, sun, sun == SunTransfer::sh);
    if (sun != SunTransfer::directional) baked.addLocal(9, 12);
    if (sun != SunTransfer::none) cutCells(baked.sector[0]);
    damageOften(baked.sectorBytes(0), format::Kind::sector);
  }
}

TEST_CASE("LevelDamage, AnIndexUnderARightChecksumNeverCrashes") {
  for (const auto sun : {SunTransfer::none, SunTransfer::directional}) {
    const RandomLevel baked(2, 5, sun == SunTransfer::directional ? 4 : 0, sun, false);
    damageOften(sectors::encodeLevel(baked.index), format::Kind::level);
  }
}

TEST_CASE("LevelDamage, TheLargestNumbersOfAFileGiveFiniteLight") {
  RandomLevel baked(2, 40, 16, SunTransfer::directional, true);
  constexpr std::uint16_t kLargest = 0x7149;  // upper half of 9.95e29
  transfer::EncodedProbes& p = baked.sector[0].probes;
  for (auto* scales : {&p.sky_scale, &p.sun_scale, &p.emitted_scale})
    std::fill(scales->begin(), scales->end(), kLargest);
  std::fill(p.sun.begin(), p.sun.end(), std::int8_t{127});  // no part makes up for another
  std::fill(p.mode.begin(), p.mode.end(), std::int8_t{127});
  std::fill(p.coefficient_scale.begin(), p.coefficient_scale.end(), 9e29F);
  std::fill(p.mode_scale.begin(), p.mode_scale.end(), 9e29F);
  baked.addLocal(100, 128);
  transfer::EncodedLocal& local = baked.sector[0].local->encoded;
  std::fill(local.scale.begin(), local.scale.end(), kLargest);
  std::fill(local.radiance.begin(), local.radiance.end(), std::int8_t{127});
  const LevelExercise of_sector = exerciseFile(baked.sectorBytes(0));
  CHECK(of_sector.opened);
  CHECK(of_sector.fault == "");
  baked.index.scale = {1e30, 1e30};
  const LevelExercise of_index = exerciseFile(sectors::encodeLevel(baked.index));
  CHECK(of_index.opened);
  CHECK(of_index.fault == "");
}

TEST_CASE("LevelDamage, FilesThatAreCutAreRefused") {
  const RandomLevel baked(1, 5, 0, SunTransfer::none, false);
  const auto bytes = baked.sectorBytes(0);
  for (std::size_t size = 0; size < bytes.size(); size += 97) {
    const LevelExercise result = exerciseFile(std::span(bytes).first(size));
    REQUIRE(result.fault == "");
    REQUIRE(!result.opened);
  }
}

}  // namespace welkin::tests
