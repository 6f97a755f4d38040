// SPDX-License-Identifier: Apache-2.0
// The light of a baked level between its cells.
#include "probes/sectors/level_light.h"

#include <catch2/catch.hpp>
#include <functional>

#include "probes/geometry/directions.h"
#include "skies.h"

namespace welkin::tests {

using f64::Number3;
namespace {

constexpr double kEncoding = 1e-4;  // error of 16 bits and of the sky's projection
const Number3 kUpwards(0, 1, 0);

/// Two probes under a sky of radiance 1, open to 0.25 and 0.75 of it, in the cells that `which` selects.
sectors::SectorFile sectorOf(const geometry::SectorId& id,
                             const std::function<std::uint8_t(int x, int y, int z)>& which) {
  transfer::SectorProbes probes;
  probes.id = id;
  for (const double open : {0.25, 0.75}) {
    probes.position.push_back({geometry::kSector_m * (id.x + 0.5), 10.0, geometry::kSector_m * (id.z + 0.5)});
    transfer::ProbeTransfer transfer;
    transfer.visibility = {open, open, open, 0.0};
    probes.transfer.push_back(transfer);
    probes.sun.emplace_back();
  }
  sectors::SectorFile file;
  file.id = id;
  file.low_y = -8.0;
  file.probes = transfer::encodeProbes(probes);
  for (int z = 0; z < geometry::kCells; ++z)
    for (int y = 0; y < geometry::kCells; ++y)
      for (int x = 0; x < geometry::kCells; ++x)
        file.grid[static_cast<std::size_t>(x + geometry::kCells * (y + geometry::kCells * z))] = which(x, y, z);
  return file;
}

/// The light on a level surface, relative to an open surface by the same formula.
double shareAt(const sectors::LevelLight& light, const Number3& position) {
  const auto found = light.at(position, kUpwards);
  REQUIRE(found);
  const auto weight = transfer::shadingWeights(kUpwards);
  double open = 0.0;
  for (std::size_t b = 0; b < 3; ++b) open += weight[b] * det::kPi * (1.0 + transfer::transferBasis()[b].y) / 2.0;
  return found->sky.y / open;
}

sectors::LevelLight lightOf(const std::vector<sectors::SectorFile>& sectors) {  // `sectors` must outlive the result
  static const model::Sky sky = uniformSky(1.0);
  return sectors::LevelLight(sectors, sky, 12.0);
}

}  // namespace

TEST_CASE("LevelLight, IsLinearBetweenTheMiddlesOfCells") {
  // Along each axis, probe 0 serves up to the eighth cell and probe 1 from the ninth: middles at 30 and 34 m.
  const int axes = 3;
  for (int axis = 0; axis < axes; ++axis) {
    const std::vector<sectors::SectorFile> sectors = {sectorOf({-2, 1}, [&](int x, int y, int z) {
      return static_cast<std::uint8_t>((axis == 0 ? x : axis == 1 ? y : z) < 8 ? 0 : 1);
    })};
    const sectors::LevelLight light = lightOf(sectors);
    for (const double along : {10.0, 30.0, 31.0, 32.0, 33.5, 34.0, 50.0}) {
      CAPTURE(axis, along);
      // The surface lies 1 m below the point that is looked up; the grid starts at y = -8.
      Number3 p(-128.0 + 21.0, -8.0 + 21.0 - 1.0, 64.0 + 21.0);
      (axis == 0 ? p.x : axis == 1 ? p.y : p.z) += along - 21.0;
      const double expected = 0.25 + 0.5 * std::clamp((along - 30.0) / 4.0, 0.0, 1.0);
      CHECK(shareAt(light, p) == Approx(expected).margin(kEncoding));
    }
  }
}

TEST_CASE("LevelLight, CellsWithoutAProbeLeaveTheirWeightToTheOthers") {
  const std::vector<sectors::SectorFile> sectors = {
      sectorOf({0, 0}, [](int x, int, int) { return x < 8 ? std::uint8_t{1} : geometry::kNoProbe; })};
  const sectors::LevelLight light = lightOf(sectors);
  CHECK(shareAt(light, {33.0, 10.0, 20.0}) == Approx(0.75).margin(kEncoding));
  CHECK_FALSE(light.at({34.5, 10.0, 20.0}, kUpwards));
  CHECK_FALSE(light.at({100.0, 10.0, 20.0}, kUpwards));
  CHECK_FALSE(light.at({20.0, 200.0, 20.0}, kUpwards));
}

TEST_CASE("LevelLight, SectorsMeetWithoutASeam") {
  const std::vector<sectors::SectorFile> sectors = {sectorOf({-1, 0}, [](int, int, int) { return std::uint8_t{0}; }),
                                                    sectorOf({0, 0}, [](int, int, int) { return std::uint8_t{1}; })};
  const sectors::LevelLight light = lightOf(sectors);
  CHECK(shareAt(light, {-1.0, 10.0, 20.0}) == Approx(0.375).margin(kEncoding));
  CHECK(shareAt(light, {-1e-9, 10.0, 20.0}) == Approx(0.5).margin(kEncoding));
  CHECK(shareAt(light, {1e-9, 10.0, 20.0}) == Approx(0.5).margin(kEncoding));
  CHECK(shareAt(light, {1.0, 10.0, 20.0}) == Approx(0.625).margin(kEncoding));
}

TEST_CASE("LevelLight, ARoomIsLitByItsOwnProbesAlone") {
  // Cells up to the eighth name probe 0, the others probe 1; the room ends within the eighth cell.
  sectors::SectorFile file = sectorOf({0, 0}, [](int x, int, int) { return static_cast<std::uint8_t>(x < 8 ? 0 : 1); });
  file.room = {{{{0, -10, 0}, {31, 60, 64}}, 0}, {{{56, -10, 0}, {58, 60, 64}}, 0}};
  file.in_room = {1, 0};
  std::vector<sectors::SectorFile> sectors = {file};
  const sectors::LevelLight light = lightOf(sectors);
  CHECK(shareAt(light, {30.9, 10.0, 20.0}) == Approx(0.25).margin(kEncoding));
  CHECK(shareAt(light, {31.1, 10.0, 20.0}) == Approx(0.75).margin(kEncoding));
  CHECK(shareAt(light, {40.0, 10.0, 20.0}) == Approx(0.75).margin(kEncoding));
  // The second room has no cell, so its own probe serves, or nothing.
  CHECK(shareAt(light, {57.0, 10.0, 20.0}) == Approx(0.25).margin(kEncoding));
  sectors[0].room[1].probe = geometry::kNoProbe;
  const sectors::LevelLight bare = lightOf(sectors);
  CHECK_FALSE(bare.at({57.0, 10.0, 20.0}, kUpwards));
}

TEST_CASE("LevelLight, ARoomReachesAcrossSectors") {
  // The same box has another index on either side of the border. Each file counts from its own sector's corner, as
  // floats.
  sectors::SectorFile west = sectorOf({-1, 0}, [](int, int, int) { return std::uint8_t{0}; });
  sectors::SectorFile east = sectorOf({0, 0}, [](int x, int, int) { return static_cast<std::uint8_t>(x < 1 ? 1 : 0); });
  const geometry::Box hall = {{-20, -10, 0}, {double{3.1F} - 0.1, 60, 64}};
  const geometry::Box hall_from_west = {{44, -10, 0}, {67, 60, 64}};
  west.room = {{{{4, -10, 0}, {14, 60, 64}}, geometry::kNoProbe}, {hall_from_west, 0}};
  west.in_room = {2, 0};
  east.room = {{hall, 1}};
  east.in_room = {0, 1};
  const std::vector<sectors::SectorFile> sectors = {west, east};
  const sectors::LevelLight light = lightOf(sectors);
  CHECK(shareAt(light, {-1.0, 10.0, 20.0}) == Approx(0.375).margin(kEncoding));
  CHECK(shareAt(light, {1.0, 10.0, 20.0}) == Approx(0.625).margin(kEncoding));
  CHECK(shareAt(light, {2.9, 10.0, 20.0}) == Approx(0.75).margin(kEncoding));
  CHECK(shareAt(light, {3.1, 10.0, 20.0}) == Approx(0.25).margin(kEncoding));
}

TEST_CASE("LevelLight, TheSurfaceIsLeftAlongItsNormal") {
  // At a wall at x = 32 the cell before it counts.
  const std::vector<sectors::SectorFile> sectors = {
      sectorOf({0, 0}, [](int x, int, int) { return static_cast<std::uint8_t>(x < 8 ? 0 : 1); })};
  const sectors::LevelLight light = lightOf(sectors);
  const auto west = light.at({32.0, 10.0, 20.0}, {-1, 0, 0}, 2.0);
  const auto east = light.at({32.0, 10.0, 20.0}, {1, 0, 0}, 2.0);
  REQUIRE((west && east));
  for (const auto& [side, probe] : {std::pair(*west, std::size_t{0}), {*east, std::size_t{1}}}) {
    const Number3 normal(probe == 0 ? -1.0 : 1.0, 0, 0);
    CHECK(side.sky.y == Approx(light.ofProbe({0, 0}, probe, normal).sky.y).epsilon(1e-12));
  }
  CHECK(east->sky.y > 2.0 * west->sky.y);
}

}  // namespace welkin::tests
