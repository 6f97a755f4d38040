// SPDX-License-Identifier: Apache-2.0
// The size of a sector's file, compared with the format's promise.
#include <catch2/catch.hpp>

#include "probes/sectors/sector_file.h"

namespace welkin::tests {
namespace {

/// A sector with probes and modes for a summer's day and a winter moon's night.
sectors::SectorFile sectorOf(std::size_t probes, std::size_t modes) {
  constexpr int kSunKnots = 17;
  constexpr int kMoonKnots = 16;
  sectors::SectorFile s;
  s.grid.fill(geometry::kNoProbe);
  s.sun = modes > 0 ? transfer::SunTransfer::directional : transfer::SunTransfer::sh;
  s.settings.assign(1000, ' ');
  transfer::EncodedProbes& p = s.probes;
  p.position.resize(3 * probes);
  p.visibility.resize(3 * probes);
  p.sky_scale.resize(probes);
  p.sky.resize(24 * probes);
  p.sky_side.resize(24 * probes);
  if (modes == 0) return s;
  p.sun_scale.resize(probes);
  p.sun.resize(4 * modes * probes);
  for (int i = 0; i < kSunKnots; ++i) p.sun_time_h.push_back(4.0F + static_cast<float>(i));
  for (int i = 0; i < kMoonKnots; ++i) p.moon_time_h.push_back(static_cast<float>(i));
  p.coefficient_scale.resize(modes);
  p.mode_scale.resize(modes);
  p.mode.resize(3 * modes * (kSunKnots + kMoonKnots));
  return s;
}

std::size_t sizeOf(const sectors::SectorFile& sector) {
  const auto bytes = sectors::encodeSector(sector);
  REQUIRE(sectors::decodeSector(bytes, "the sector").probes.probes() == sector.probes.probes());
  return bytes.size();
}

}  // namespace

TEST_CASE("SectorBytes, SeventyProbesAreWithin15KB") {
  // The whole file counts, with the ten modes of a bake without a budget.
  const sectors::SectorFile sector = sectorOf(70, 10);
  CHECK(sector.probes.bytesAProbe() == 104);
  CHECK(sizeOf(sector) <= 15 * 1024);
}

TEST_CASE("SectorBytes, AProbeTakesItsOwnBytes") {
  // Ten more probes; sixteen bytes allow for alignment.
  const std::size_t without = sizeOf(sectorOf(80, 0)) - sizeOf(sectorOf(70, 0));
  CHECK(without >= 10 * 62 - 16);
  CHECK(without <= 10 * 62 + 16);
  const std::size_t with = sizeOf(sectorOf(80, 10)) - sizeOf(sectorOf(70, 10));
  CHECK(with >= 10 * 104 - 16);
  CHECK(with <= 10 * 104 + 16);
}

}  // namespace welkin::tests
