// SPDX-License-Identifier: Apache-2.0
// Placement on real levels. It runs if WELKIN_DATA names a folder with them.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>

#include "probes/geometry/directions.h"
#include "probes/geometry/random.h"
#include "probes/loader/read_scene.h"
#include "probes/loader/surfaces_of.h"
#include "probes/placement/column.h"
#include "probes/placement/grid_cells.h"
#include "probes/placement/placement.h"
#include "probes/placement/validity.h"

namespace welkin::tests {

using f64::Number3;
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

geometry::Surfaces readLevel(const std::string& path, double scale) {
  level::GeometryEntry entry;
  entry.path = path;
  entry.transform = {{scale, 0, 0}, {0, scale, 0}, {0, 0, scale}, {}};
  level::LevelFile level;
  level.geometry = {entry};
  return loader::surfacesOf(loader::readScene(level), 1.0);
}

/// Whether the share of backs among random directions is high, beyond a margin for the fixed directions.
bool isInside(const geometry::Tracer& tracer, const Number3& p) {
  constexpr int kRays = 1024;
  geometry::Random random(std::llround(p.x * 1e4), std::llround(p.y * 1e4), std::llround(p.z * 1e4));
  int backs = 0;
  for (int i = 0; i < kRays; ++i) {
    const double s = random.unit();
    const auto hit = tracer.closest(p, geometry::sphereDirection(s, random.unit()), kFar);
    backs += hit && hit->back ? 1 : 0;
  }
  const double standard_errors =
      4.0 * std::sqrt(placement::kMostBacks * (1.0 - placement::kMostBacks) * (1.0 / kRays + 1.0 / 64.0));
  return backs > (placement::kMostBacks + standard_errors) * kRays;
}

/// Height of the first surface from above.
double heightAt(const geometry::Tracer& tracer, double x, double z) {
  const auto hit = tracer.closest({x, 500, z}, {0, -1, 0}, kFar);
  return hit ? hit->position.y : -1000.0;
}

/// Number of lines, of a lattice of 1/2 m, that meet another surface than the lines on both sides, which agree.
std::size_t slips(const geometry::Tracer& tracer, double half, double aside_x, double aside_z) {
  constexpr double kBeside_m = 2e-3;
  constexpr double kSame_m = 0.02;
  std::size_t result = 0;
  for (double x = -half; x < half; x += 0.5)
    for (double z = -half; z < half; z += 0.5) {
      const double low = heightAt(tracer, x + aside_x - kBeside_m, z + aside_z - 0.7 * kBeside_m);
      const double high = heightAt(tracer, x + aside_x + kBeside_m, z + aside_z + 0.7 * kBeside_m);
      const double middle = heightAt(tracer, x + aside_x, z + aside_z);
      result += std::abs(low - high) < kSame_m && std::abs(middle - low) > 0.1 ? 1 : 0;
    }
  return result;
}

struct Seen {
  std::size_t points = 0;
  std::size_t covered = 0;
};

/// Random points of a sector with headroom above, and how many of them see one of its probes within 8 m.
Seen seenAtRandom(const geometry::Tracer& tracer, const geometry::PlacedSector& sector) {
  Seen result;
  geometry::Random random(sector.id.x, sector.id.z, 77);
  for (int i = 0; i < 200; ++i) {
    const double x = geometry::kSector_m * (sector.id.x + random.unit());
    const double z = geometry::kSector_m * (sector.id.z + random.unit());
    for (const placement::Span& span : placement::spansAt(tracer, x, z, 500)) {
      if (span.floor_normal_y < 0.5 || span.inside || span.high_y - span.low_y < 1.2) continue;
      const Number3 foot{x, span.low_y + 0.1, z};
      if (placement::insideGeometry(tracer, foot + Number3(0, 0.5, 0))) continue;
      ++result.points;
      result.covered += std::any_of(sector.probe.begin(), sector.probe.end(), [&](const geometry::Probe& p) {
        return placement::distanceOf(foot, p.position) < 8.0 && placement::sees(tracer, foot, p.position);
      });
    }
  }
  return result;
}

}  // namespace

TEST_CASE("Placement, RealLevels") {
  const char* folder = std::getenv("WELKIN_DATA");
  if (folder == nullptr) {
    WARN("WELKIN_DATA names no folder: skipped");
    return;
  }
  struct Level {
    const char* file;
    std::size_t sectors, least, most;
  };
  for (const Level& level :
       {Level{"/levels/redeclipse/fortitude.obj", 10, 500, 800}, Level{"/levels/test_ctf/test_ctf.obj", 4, 150, 350}}) {
    constexpr double kScale = 0.125;
    const geometry::Surfaces s = readLevel(std::string(folder) + level.file, kScale);
    const geometry::Tracer tracer(s);
    const auto sectors = placement::sectorsOf(s, {});
    CHECK(sectors.size() == level.sectors);
    std::size_t probes = 0;
    Seen seen;
    for (const geometry::SectorId& id : sectors) {
      placement::PlacementReport report;
      const geometry::PlacedSector sector = placement::placeSector(tracer, id, {}, report);
      probes += sector.probe.size();
      CHECK(report.uncovered.empty());
      for (const geometry::Probe& p : sector.probe) {
        CHECK_FALSE(isInside(tracer, p.position));
        CHECK(geometry::sectorAt(p.position) == id);
      }
      const Seen here = seenAtRandom(tracer, sector);
      seen.points += here.points;
      seen.covered += here.covered;
      std::size_t by_middle = 0;
      for (std::size_t i = 0; i < placement::kAllCells; ++i) {
        if (sector.grid[i] == geometry::kNoProbe) continue;
        REQUIRE(sector.grid[i] < sector.probe.size());
        const auto cell = static_cast<double>(i);
        const Number3 middle{
            geometry::kSector_m * id.x + (std::fmod(cell, 16) + 0.5) * geometry::kCell_m + placement::kAside_x_m,
            sector.low_y + (std::fmod(std::floor(cell / 16), 16) + 0.5) * sector.cell_height_m,
            geometry::kSector_m * id.z + (std::floor(cell / 256) + 0.5) * geometry::kCell_m + placement::kAside_z_m};
        by_middle += placement::sees(tracer, middle, sector.probe[sector.grid[i]].position) ? 1 : 0;
      }
      CHECK(by_middle >= report.cells_by_middle);
    }
    CHECK(probes >= level.least);
    CHECK(probes <= level.most);
    const std::size_t on = slips(tracer, 60, 0, 0);
    const std::size_t beside = slips(tracer, 60, placement::kAside_x_m, placement::kAside_z_m);
    CHECK(beside == 0);
    CHECK(static_cast<double>(seen.covered) >= 0.98 * static_cast<double>(seen.points));
    WARN(level.file << ": " << sectors.size() << " sectors, " << probes << " probes; of " << seen.points
                    << " random points " << seen.covered << " see one; slips on the lattice " << on << ", beside it "
                    << beside << " of 57600");
  }
}

}  // namespace welkin::tests
