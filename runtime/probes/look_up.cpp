// SPDX-License-Identifier: Apache-2.0
#include "probes/look_up.h"

#include <cmath>

#include "format/domain_check.h"

namespace welkin::probes {
namespace {

using f64::Number3;
using format::spanOf;

/// A box of a room in the world, metres.
struct Box {
  double low[3], high[3];
};

Box boxOf(const WelkinSector& sector, const format::Room& room) {
  const double x = kSector_m * sector.x, z = kSector_m * sector.z;
  return {{double{room.low_x()} + x, double{room.low_y()}, double{room.low_z()} + z},
          {double{room.high_x()} + x, double{room.high_y()}, double{room.high_z()} + z}};
}

/// Whether two boxes are one that two sectors have stored, each as floats from its own corner.
bool isSame(const Box& a, const Box& b) {
  constexpr double kFloats = 0x1p-22;  // twice the rounding of a float
  for (int axis = 0; axis < 3; ++axis) {
    const double from_corner =
        axis == 1 ? std::max(std::abs(a.low[1]), std::abs(a.high[1])) : kSector_m + a.high[axis] - a.low[axis];
    if (std::abs(a.low[axis] - b.low[axis]) > kFloats * from_corner) return false;
    if (std::abs(a.high[axis] - b.high[axis]) > kFloats * from_corner) return false;
  }
  return true;
}

/// 1 + the first of the sector's rooms that contains a point, or 0.
std::uint32_t roomAt(const WelkinSector& sector, const Number3& p) {
  if (sector.file->room() == nullptr) return 0;
  std::uint32_t number = 0;
  for (const format::Room* room : *sector.file->room()) {
    ++number;
    const Box box = boxOf(sector, *room);
    if (p.x >= box.low[0] && p.x <= box.high[0] && p.y >= box.low[1] && p.y <= box.high[1] && p.z >= box.low[2] &&
        p.z <= box.high[2])
      return number;
  }
  return 0;
}

/// Whether a probe is in room `number` of the sector `home`, or outside all rooms if that is 0.
bool isIn(const WelkinSector& sector, std::uint8_t probe, const WelkinSector& home, std::uint32_t number) {
  const auto in_room = spanOf(sector.file->in_room());
  const std::uint32_t own = in_room.empty() ? 0 : in_room[probe];
  if (own == 0 || number == 0 || &sector == &home) return own == number;
  return isSame(boxOf(sector, *sector.file->room()->Get(own - 1)), boxOf(home, *home.file->room()->Get(number - 1)));
}

std::int32_t floorToInt(double v) {
  return static_cast<std::int32_t>(std::floor(v));
}

/// Two neighbouring cells on an axis and the share of the second.
struct Pair {
  double first;
  double share;
  explicit Pair(double v) : first(std::floor(v)), share(v - first) {}
  double weight(int second) const { return second == 1 ? share : 1.0 - share; }
};

/// The sector of a column of cells, which counts from the level's origin: mostly the home sector.
const WelkinSector* sectorOf(const WelkinLevel& level, const WelkinSector& home, std::int32_t x, std::int32_t z) {
  const std::int32_t sx = x >= 0 ? x / kCells : -((kCells - 1 - x) / kCells);
  const std::int32_t sz = z >= 0 ? z / kCells : -((kCells - 1 - z) / kCells);
  return sx == home.x && sz == home.z ? &home : residentAt(level, sx, sz);
}

}  // namespace

PointProbes probesFor(const WelkinLevel& level, const Number3& p) {
  constexpr double kFarthest_m = 0x1p30;  // every int below holds a cell of it
  PointProbes out;
  if (!(std::abs(p.x) < kFarthest_m && std::abs(p.y) < kFarthest_m && std::abs(p.z) < kFarthest_m)) return out;
  const WelkinSector* home = residentAt(level, floorToInt(p.x / kSector_m), floorToInt(p.z / kSector_m));
  if (home == nullptr) return out;
  const double height = home->file->cell_height_m(), low_y = home->file->low_y();
  const Pair x(p.x / kCell_m - 0.5), y((p.y - low_y) / height - 0.5), z(p.z / kCell_m - 0.5);
  const std::uint32_t room = roomAt(*home, p);
  double total = 0.0;
  for (int dz = 0; dz < 2; ++dz)
    for (int dx = 0; dx < 2; ++dx) {
      const std::int32_t cx = static_cast<std::int32_t>(x.first) + dx, cz = static_cast<std::int32_t>(z.first) + dz;
      const WelkinSector* sector = sectorOf(level, *home, cx, cz);
      if (sector == nullptr) continue;
      const std::uint8_t* column =
          sector->file->grid()->data() + (cx - kCells * sector->x) + kCells * kCells * (cz - kCells * sector->z);
      for (int dy = 0; dy < 2; ++dy) {
        const double weight = x.weight(dx) * y.weight(dy) * z.weight(dz);
        const double middle = low_y + (y.first + dy + 0.5) * height;
        const double row = std::floor((middle - sector->file->low_y()) / sector->file->cell_height_m());
        if (!(weight > 0.0) || !(row >= 0.0 && row < kCells)) continue;
        const std::uint8_t probe = column[kCells * static_cast<int>(row)];
        if (probe == format::kNoProbe || !isIn(*sector, probe, *home, room)) continue;
        total += weight;
        out.share[out.count++] = {sector->light.get() + kColours * probe, static_cast<float>(weight)};
      }
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
  for (std::size_t i = 0; i < kColours; ++i) out[i] = 0.0F;
  for (std::size_t s = 0; s < probes.count; ++s)
    for (std::size_t i = 0; i < kColours; ++i) out[i] += probes.share[s].weight * probes.share[s].light[i];
}

}  // namespace welkin::probes
