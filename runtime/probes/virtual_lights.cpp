// SPDX-License-Identifier: Apache-2.0
#include "probes/virtual_lights.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "format/domain_check.h"
#include "probes/level.h"

namespace welkin::probes {
namespace {

constexpr double kColumn_m = 8.0;  // of a bucket's lights, in x and z

std::int64_t columnOf(double v) {
  return static_cast<std::int64_t>(std::floor(v / kColumn_m));
}

std::uint32_t bucketOfColumn(const LightTable& table, std::int64_t x, std::int64_t z) {
  std::uint64_t hash =
      static_cast<std::uint64_t>(x) * 0x9e3779b97f4a7c15U + static_cast<std::uint64_t>(z) * 0xc2b2ae3d27d4eb4fU;
  hash ^= hash >> 32;
  hash *= 0xd6e8feb86659fd93U;
  return static_cast<std::uint32_t>(hash >> 32) & table.mask;
}

std::uint32_t bucketOfPlace(const LightTable& table, const Place& p) {
  return bucketOfColumn(table, columnOf(p[0]), columnOf(p[2]));
}

std::uint32_t numberOf(LightHandle handle) {
  return handle >> 16;
}

/// Whether the list of light `a` stands before that of `b`.
bool isOfEarlierList(const LightTable& table, LightHandle a, LightHandle b) {
  const WelkinSector& x = *table.sector.get()[numberOf(a)];
  const WelkinSector& y = *table.sector.get()[numberOf(b)];
  return std::tie(x.x, x.z) < std::tie(y.x, y.z);
}

void pushToBucket(LightTable& table, LightHandle handle) {
  LightHandle& head = table.bucket.get()[bucketOfPlace(table, placeOf(table, handle))];
  lightAt(table, handle).next = head;
  head = handle;
}

void takeFromBucket(LightTable& table, LightHandle handle) {
  LightHandle* link = &table.bucket.get()[bucketOfPlace(table, placeOf(table, handle))];
  while (*link != handle) link = &lightAt(table, *link).next;
  *link = lightAt(table, handle).next;
}

bool isSamePlace(const Place& a, const Place& b) {
  return std::abs(a[0] - b[0]) <= kSameLight_m && std::abs(a[1] - b[1]) <= kSameLight_m &&
         std::abs(a[2] - b[2]) <= kSameLight_m;
}

/// Whether the light that begins with `first` is in the list of a sector's number.
bool isInList(const LightTable& table, LightHandle first, std::uint32_t number) {
  for (LightHandle l = first; l != kNoLight; l = lightAt(table, l).same)
    if (numberOf(l) == number) return true;
  return false;
}

/// The first one of the lists' light at a place, or kNoLight. Lists that have a light of sector `number` there are
/// passed over: two lights of one list are never the same.
LightHandle firstAt(const LightTable& table, const Place& p, std::uint32_t number) {
  for (std::int64_t z = columnOf(p[2] - kSameLight_m); z <= columnOf(p[2] + kSameLight_m); ++z)
    for (std::int64_t x = columnOf(p[0] - kSameLight_m); x <= columnOf(p[0] + kSameLight_m); ++x)
      for (LightHandle l = table.bucket.get()[bucketOfColumn(table, x, z)]; l != kNoLight; l = lightAt(table, l).next)
        if (isSamePlace(placeOf(table, l), p) && !isInList(table, l, number)) return l;
  return kNoLight;
}

/// Links one light of a new list.
void linkLight(LightTable& table, LightHandle handle) {
  VirtualLight& light = lightAt(table, handle);
  const LightHandle first = firstAt(table, placeOf(table, handle), numberOf(handle));
  light = {handle, kNoLight, kNoLight, 0, {0, 0, 0}};
  if (first == kNoLight) {
    pushToBucket(table, handle);
    return;
  }
  std::copy_n(lightAt(table, first).colour, 3, light.colour);
  if (isOfEarlierList(table, handle, first)) {
    light.same = first;
    for (LightHandle l = first; l != kNoLight; l = lightAt(table, l).same) lightAt(table, l).first = handle;
    takeFromBucket(table, first);
    pushToBucket(table, handle);
    return;
  }
  light.first = first;
  LightHandle before = first;
  while (lightAt(table, before).same != kNoLight && isOfEarlierList(table, lightAt(table, before).same, handle))
    before = lightAt(table, before).same;
  light.same = lightAt(table, before).same;
  lightAt(table, before).same = handle;
}

void unlinkLight(LightTable& table, LightHandle handle) {
  VirtualLight& light = lightAt(table, handle);
  if (light.first != handle) {
    LightHandle before = light.first;
    while (lightAt(table, before).same != handle) before = lightAt(table, before).same;
    lightAt(table, before).same = light.same;
    return;
  }
  takeFromBucket(table, handle);
  light.first = light.same;
  if (light.same == kNoLight) return;
  for (LightHandle l = light.same; l != kNoLight; l = lightAt(table, l).same) lightAt(table, l).first = light.same;
  pushToBucket(table, light.same);
}

bool isNearer(const NearLight& a, const NearLight& b) {
  return std::tie(a.distance_m, a.place, a.light) < std::tie(b.distance_m, b.place, b.light);
}

}  // namespace

VirtualLight& lightAt(const LightTable& table, LightHandle handle) {
  return table.sector.get()[numberOf(handle)]->lights.light.get()[handle & 0xffff];
}

Place placeOf(const LightTable& table, LightHandle handle) {
  const WelkinSector& sector = *table.sector.get()[numberOf(handle)];
  const float* p = sector.file->local()->position()->data() + std::size_t{3} * (handle & 0xffff);
  return {kSector_m * sector.x + double{p[0]}, double{p[1]}, kSector_m * sector.z + double{p[2]}};
}

bool openTable(const core::HostMemory& memory, std::uint32_t sectors, LightTable& table) {
  std::uint32_t buckets = 64;
  while (buckets < 16 * sectors) buckets *= 2;
  if (!table.sector.allocate(memory, sectors) || !table.bucket.allocate(memory, buckets)) return false;
  std::fill_n(table.sector.get(), sectors, nullptr);
  std::fill_n(table.bucket.get(), buckets, kNoLight);
  table.capacity = sectors;
  table.mask = buckets - 1;
  return true;
}

bool openLights(WelkinSector& sector) {
  if (sector.file->local() == nullptr) return true;
  const auto position = format::spanOf(sector.file->local()->position());
  SectorLights& lights = sector.lights;
  lights.count = static_cast<std::uint32_t>(position.size() / 3);
  if (lights.count == 0) return true;
  const Place corner = {kSector_m * sector.x, 0.0, kSector_m * sector.z};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    lights.low[axis] = lights.high[axis] = corner[axis] + double{position[axis]};
    for (std::size_t i = axis; i < position.size(); i += 3) {
      lights.low[axis] = std::min(lights.low[axis], corner[axis] + double{position[i]});
      lights.high[axis] = std::max(lights.high[axis], corner[axis] + double{position[i]});
    }
  }
  if (!lights.light.allocate(sector.memory, lights.count)) return false;
  std::fill_n(lights.light.get(), lights.count, VirtualLight{kNoLight, kNoLight, kNoLight, 0, {0, 0, 0}});
  return true;
}

void linkLights(LightTable& table, WelkinSector& sector) {
  if (sector.lights.count == 0) return;
  while (table.sector.get()[table.lowest_free] != nullptr) ++table.lowest_free;
  sector.lights.number = table.lowest_free++;
  table.sector.get()[sector.lights.number] = &sector;
  for (std::uint32_t i = 0; i < sector.lights.count; ++i) linkLight(table, sector.lights.number << 16 | i);
}

void unlinkLights(LightTable& table, WelkinSector& sector) {
  for (std::uint32_t i = 0; i < sector.lights.count; ++i) unlinkLight(table, sector.lights.number << 16 | i);
}

void releaseNumber(LightTable& table, WelkinSector& sector) {
  if (sector.lights.count == 0) return;
  table.sector.get()[sector.lights.number] = nullptr;
  table.lowest_free = std::min(table.lowest_free, sector.lights.number);
}

std::size_t nearestLights(const LightTable& table, const Place& place, const NearLight* after,
                          std::span<NearLight> out) {
  std::size_t count = 0;  // a heap, the farthest on top
  const std::int64_t middle_x = columnOf(place[0]), middle_z = columnOf(place[2]);
  const auto visit = [&](std::int64_t x, std::int64_t z) {
    for (LightHandle l = table.bucket.get()[bucketOfColumn(table, x, z)]; l != kNoLight; l = lightAt(table, l).next) {
      const Place p = placeOf(table, l);
      if (columnOf(p[0]) != x || columnOf(p[2]) != z) continue;
      const double dx = p[0] - place[0], dy = p[1] - place[1], dz = p[2] - place[2];
      const NearLight found{std::sqrt(dx * dx + dy * dy + dz * dz), p, l};
      if (!(found.distance_m <= kFarthestLight_m) || (after != nullptr && !isNearer(*after, found))) continue;
      if (count == out.size()) {
        if (!isNearer(found, out[0])) continue;
        std::pop_heap(out.begin(), out.end(), isNearer);
        --count;
      }
      out[count++] = found;
      std::push_heap(out.begin(), out.begin() + static_cast<std::ptrdiff_t>(count), isNearer);
    }
  };
  // Squares of columns about the middle one, as far as one may hold a light that is near enough.
  for (std::int64_t ring = 0;; ++ring) {
    double nearest = 0.0;
    if (ring > 0) {
      const auto inside = [&](double v, std::int64_t middle) {
        return std::min(v - kColumn_m * static_cast<double>(middle - ring + 1),
                        kColumn_m * static_cast<double>(middle + ring) - v);
      };
      nearest = std::min(inside(place[0], middle_x), inside(place[2], middle_z));
    }
    if (nearest > kFarthestLight_m || (count == out.size() && nearest > out[0].distance_m)) break;
    for (std::int64_t z = -ring; z <= ring; ++z)
      for (std::int64_t x = -ring; x <= ring; x += z == -ring || z == ring ? 1 : 2 * ring)
        visit(middle_x + x, middle_z + z);
  }
  std::sort_heap(out.begin(), out.begin() + static_cast<std::ptrdiff_t>(count), isNearer);
  return count;
}

}  // namespace welkin::probes
