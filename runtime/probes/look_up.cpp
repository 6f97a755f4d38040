// SPDX-License-Identifier: Apache-2.0
#include "probes/look_up.h"

#include <cmath>
#include <cstring>

#include "probes/rooms.h"

namespace welkin::probes {
namespace {

/// The grid of a resident sector, for format::probesAbout.
auto gridsOf(const WelkinLevel& level) {
  return [&level](int x, int z) -> const format::GridView* {
    const WelkinSector* sector = residentAt(level, x, z);
    return sector == nullptr ? nullptr : &sector->grid;
  };
}

/// Whether every cell's place fits into an int.
bool isNear(const format::InWorld& p) {
  constexpr double kFarthest_m = 0x1p30;
  return std::abs(p[0]) < kFarthest_m && std::abs(p[1]) < kFarthest_m && std::abs(p[2]) < kFarthest_m;
}

/// std::floor of a value that an int holds; the library's is slow on older processors.
int floorOf(double v) {
  const int towards_0 = static_cast<int>(v);
  return towards_0 - (v < towards_0 ? 1 : 0);
}

const WelkinSector* sectorAt(const WelkinLevel& level, const format::InWorld& p) {
  return residentAt(level, floorOf(p[0] / kSector_m), floorOf(p[2] / kSector_m));
}

/// A place in cells from the sector's corner and the bottom of its grid.
format::InWorld inCells(const WelkinSector& sector, const format::InWorld& p) {
  constexpr double kCell_m = format::kCellWidth_m;
  return {(p[0] - kSector_m * sector.x) / kCell_m, (p[1] - sector.grid.low_y) / sector.grid.cell_height_m,
          (p[2] - kSector_m * sector.z) / kCell_m};
}

/// A box of at most 2 x 2 x 2 cells, all in the sector's grid, that no wall parts.
struct OpenBox {
  bool is_open = true;
  int first[3], count[3];

  /// The cells from `low` to `high`, in cells of the sector.
  OpenBox(const WelkinSector& sector, const format::InWorld& low, const format::InWorld& high) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (!(low[axis] >= 0.0 && high[axis] < format::kCellsAcross)) {
        is_open = false;
        return;
      }
      first[axis] = static_cast<int>(low[axis]);
      count[axis] = static_cast<int>(high[axis]) - first[axis] + 1;
    }
    if (sector.cut.get() == nullptr) return;
    for (int z = 0; z < count[2]; ++z)
      for (int y = 0; y < count[1]; ++y)
        for (int x = 0; x < count[0]; ++x) {
          const auto cell = static_cast<unsigned>(first[0] + x + 16 * (first[1] + y + 16 * (first[2] + z)));
          if ((sector.cut.get()[cell / 64] >> (cell % 64) & 1) != 0) is_open = false;
        }
  }
};

/// The probes of a place whose eight cells no wall parts, in a sector without rooms. False if it is no such place.
bool openProbes(const WelkinSector& sector, const format::InWorld& place, PointProbes& out) {
  if (sector.file->room() != nullptr) return false;
  const format::InWorld p = inCells(sector, place);
  int first[3];
  double share[3][2];  // axis; of the first cell and of the second
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double low = p[axis] - 0.5;
    if (!(low >= 0.0 && low < format::kCellsAcross - 1)) return false;
    first[axis] = static_cast<int>(low);
    share[axis][1] = low - first[axis];
    share[axis][0] = 1.0 - share[axis][1];
  }
  const int corner = first[0] + 16 * (first[1] + 16 * first[2]);
  double weight[8], total = 0.0;
  std::size_t count = 0;
  for (unsigned i = 0; i < 8; ++i) {
    const unsigned dx = i & 1, dy = i >> 1 & 1, dz = i >> 2;
    const auto cell = static_cast<unsigned>(corner) + dx + 16 * (dy + 16 * dz);
    if (sector.cut.get() != nullptr && (sector.cut.get()[cell / 64] >> (cell % 64) & 1) != 0) return false;
    const std::uint8_t probe = sector.grid.grid[cell];
    if (probe == format::kNoProbe) continue;
    total += weight[count] = share[0][dx] * share[1][dy] * share[2][dz];
    out.share[count++].light = sector.light.get() + kColours * probe;
  }
  if (!(total > 0.0)) return true;
  const double inverse = 1.0 / total;
  out.count = count;
  for (std::size_t i = 0; i < out.count; ++i) out.share[i].weight = static_cast<float>(weight[i] * inverse);
  return true;
}

}  // namespace

format::InWorld pushedOff(const WelkinLevel& level, const format::InWorld& position, const format::InWorld& normal) {
  if (!isNear(position)) return position;
  const WelkinSector* home = sectorAt(level, position);
  if (home != nullptr) {
    format::InWorld low, high;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double end = position[axis] + 2.0 * kPush_m * normal[axis];
      low[axis] = std::min(position[axis], end);
      high[axis] = std::max(position[axis], end);
    }
    if (OpenBox(*home, inCells(*home, low), inCells(*home, high)).is_open)
      return {position[0] + normal[0] * kPush_m, position[1] + normal[1] * kPush_m, position[2] + normal[2] * kPush_m};
  }
  return format::pushedPlace(position, normal, kPush_m, gridsOf(level));
}

PointProbes probesFor(const WelkinLevel& level, const format::InWorld& p) {
  PointProbes out;
  if (!isNear(p)) return out;
  const WelkinSector* home = sectorAt(level, p);
  if (home == nullptr || openProbes(*home, p, out)) return out;
  const std::uint32_t room = roomAt(*home, p);
  const format::EightProbes about = format::probesAbout(p, gridsOf(level));
  double total = 0.0;
  for (std::size_t i = 0; i < about.count; ++i) {
    const format::WeightedProbe& found = about.probe[i];
    const bool is_home = found.sector_x == home->x && found.sector_z == home->z;
    const WelkinSector& sector = is_home ? *home : *residentAt(level, found.sector_x, found.sector_z);
    if (!isInRoom(sector, found.probe, *home, room)) continue;
    total += found.weight;
    out.share[out.count++] = {sector.light.get() + kColours * found.probe, static_cast<float>(found.weight)};
  }
  if (out.count == 0) {
    const std::uint8_t probe = room == 0 ? format::kNoProbe : home->file->room()->Get(room - 1)->probe();
    if (probe != format::kNoProbe) out.share[out.count++] = {home->light.get() + kColours * probe, 1.0F};
    return out;
  }
  for (std::size_t i = 0; i < out.count; ++i)
    out.share[i].weight = static_cast<float>(double{out.share[i].weight} / total);
  return out;
}

void addLight(const PointProbes& probes, float* out) {
  using Directions [[gnu::vector_size(kDirections * sizeof(float))]] = float;
  Directions sum[kChannels] = {};
  for (std::size_t s = 0; s < probes.count; ++s) {
    Directions light[kChannels];
    std::memcpy(light, probes.share[s].light, sizeof light);
    for (std::size_t c = 0; c < kChannels; ++c) sum[c] += probes.share[s].weight * light[c];
  }
  std::memcpy(out, sum, sizeof sum);
}

}  // namespace welkin::probes
