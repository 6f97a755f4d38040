// SPDX-License-Identifier: Apache-2.0
// Placement on real levels: runs where WELKIN_DATA names a folder that holds them.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>

#include "probes/directions.h"
#include "probes/level/surfaces_of.h"
#include "probes/placement/column.h"
#include "probes/placement/grid_cells.h"
#include "probes/placement/placement.h"
#include "probes/placement/validity.h"
#include "probes/random.h"

namespace welkin::probes {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

Surfaces readLevel(const std::string& path, double scale) {
  GeometryEntry entry;
  entry.path = path;
  entry.transform = {{scale, 0, 0}, {0, scale, 0}, {0, 0, scale}, {}};
  LevelFile level;
  level.geometry = {entry};
  return readSurfaces(level);
}

/// Share of backs among random directions, beyond what the fixed ones may have missed.
bool isInside(const Tracer& tracer, const Number3& p) {
  constexpr int kRays = 1024;
  Random random(std::llround(p.x * 1e4), std::llround(p.y * 1e4), std::llround(p.z * 1e4));
  int backs = 0;
  for (int i = 0; i < kRays; ++i) {
    const double s = random.unit();
    const auto hit = tracer.closest(p, sphereDirection(s, random.unit()), kFar);
    backs += hit && hit->back ? 1 : 0;
  }
  const double standard_errors = 4.0 * std::sqrt(kMostBacks * (1.0 - kMostBacks) * (1.0 / kRays + 1.0 / 64.0));
  return backs > (kMostBacks + standard_errors) * kRays;
}

/// Height of the first surface from above.
double heightAt(const Tracer& tracer, double x, double z) {
  const auto hit = tracer.closest({x, 500, z}, {0, -1, 0}, kFar);
  return hit ? hit->position.y : -1000.0;
}

/// Lines of a lattice of 1/2 m that meet another surface than the lines to both sides, which agree.
std::size_t slips(const Tracer& tracer, double half, double aside_x, double aside_z) {
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

/// Random points of a sector with headroom above: how many see a probe of it within 8 m.
Seen seenAtRandom(const Tracer& tracer, const PlacedSector& sector) {
  Seen result;
  Random random(sector.id.x, sector.id.z, 77);
  for (int i = 0; i < 200; ++i) {
    const double x = kSector_m * (sector.id.x + random.unit());
    const double z = kSector_m * (sector.id.z + random.unit());
    for (const Span& span : spansAt(tracer, x, z, 500)) {
      if (span.floor_normal_y < 0.5 || span.inside || span.high_y - span.low_y < 1.2) continue;
      const Number3 foot{x, span.low_y + 0.1, z};
      if (insideGeometry(tracer, foot + Number3(0, 0.5, 0))) continue;
      ++result.points;
      result.covered += std::any_of(sector.probe.begin(), sector.probe.end(), [&](const Probe& p) {
        return distanceOf(foot, p.position) < 8.0 && sees(tracer, foot, p.position);
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
    const Surfaces s = readLevel(std::string(folder) + level.file, kScale);
    const Tracer tracer(s);
    const auto sectors = sectorsOf(s, {});
    CHECK(sectors.size() == level.sectors);
    std::size_t probes = 0;
    Seen seen;
    for (const SectorId& id : sectors) {
      PlacementReport report;
      const PlacedSector sector = placeSector(tracer, id, {}, report);
      probes += sector.probe.size();
      CHECK(report.uncovered.empty());
      for (const Probe& p : sector.probe) {
        CHECK_FALSE(isInside(tracer, p.position));
        CHECK(sectorAt(p.position) == id);
      }
      const Seen here = seenAtRandom(tracer, sector);
      seen.points += here.points;
      seen.covered += here.covered;
      std::size_t by_middle = 0;
      for (std::size_t i = 0; i < kAllCells; ++i) {
        if (sector.grid[i] == kNoProbe) continue;
        REQUIRE(sector.grid[i] < sector.probe.size());
        const auto cell = static_cast<double>(i);
        const Number3 middle{kSector_m * id.x + (std::fmod(cell, 16) + 0.5) * kCell_m + kAside_x_m,
                             sector.low_y + (std::fmod(std::floor(cell / 16), 16) + 0.5) * sector.cell_height_m,
                             kSector_m * id.z + (std::floor(cell / 256) + 0.5) * kCell_m + kAside_z_m};
        by_middle += sees(tracer, middle, sector.probe[sector.grid[i]].position) ? 1 : 0;
      }
      CHECK(by_middle >= report.cells_by_middle);
    }
    CHECK(probes >= level.least);
    CHECK(probes <= level.most);
    const std::size_t on = slips(tracer, 60, 0, 0);
    const std::size_t beside = slips(tracer, 60, kAside_x_m, kAside_z_m);
    CHECK(beside == 0);
    CHECK(static_cast<double>(seen.covered) >= 0.98 * static_cast<double>(seen.points));
    WARN(level.file << ": " << sectors.size() << " sectors, " << probes << " probes; of " << seen.points
                    << " random points " << seen.covered << " see one; slips on the lattice " << on << ", beside it "
                    << beside << " of 57600");
  }
}

}  // namespace welkin::probes
