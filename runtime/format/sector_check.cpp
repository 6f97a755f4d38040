// SPDX-License-Identifier: Apache-2.0
#include "format/sector_check.h"

#include <bit>
#include <cmath>
#include <numeric>

#include "format/domain_check.h"

namespace welkin::format {
namespace {

/// Keeps the first complaint.
struct Check {
  Fault fault;

  bool that(bool holds, const char* what, const char* must) {
    if (!holds && fault.what == nullptr) fault = {what, must};
    return fault.what == nullptr;
  }
};

constexpr double kFarthest_m = 1e7;
constexpr std::uint32_t kDirections = 4;
constexpr std::uint32_t kMostKnots = 8192;

/// Whether each scale is the upper half of a float32 in [0, kAny].
bool areScales(std::span<const std::uint16_t> scales) {
  return std::all_of(scales.begin(), scales.end(), [](std::uint16_t bits) {
    const float scale = std::bit_cast<float>(std::uint32_t{bits} << 16);
    return !std::signbit(scale) && within(double{scale}, 0.0, kAny);
  });
}

bool areHours(std::span<const float> hours) {
  double before = -1.0;
  for (const float hour : hours) {
    if (!(double{hour} > before && hour >= 0.0F && hour < 24.0F)) return false;
    before = double{hour};
  }
  return true;
}

bool isPlace(std::int32_t x, std::int32_t z) {
  return x >= -kFarthestSector && x <= kFarthestSector && z >= -kFarthestSector && z <= kFarthestSector;
}

void checkModes(Check& check, const Probes& p, SunTransfer sun) {
  constexpr const char* kName = "the modes of the sun";
  const auto count = spanOf(p.mode_scale()).size();
  const auto sun_knots = spanOf(p.sun_time_h()).size();
  const auto moon_knots = spanOf(p.moon_time_h()).size();
  check.that(count <= kMostSunModes, kName, "must be at most 16");
  check.that(count == 0 || sun == SunTransfer::directional, kName, "must be none, for the sun is not directional");
  check.that(sun_knots <= kMostKnots && moon_knots <= kMostKnots, kName, "must have at most 8192 knots a light");
  check.that(spanOf(p.mode()).size() == 3 * count * (sun_knots + moon_knots), kName,
             "must have a number for every mode, knot and channel");
  check.that(spanOf(p.coefficient_scale()).size() == count, kName, "must have two scales each");
  check.that(areHours(spanOf(p.sun_time_h())) && areHours(spanOf(p.moon_time_h())), kName,
             "must have ascending knots in [0, 24)");
  check.that(within(spanOf(p.mode_scale()), 0.0, kAny) && within(spanOf(p.coefficient_scale()), 0.0, kAny), kName,
             "have a scale out of its domain");
}

void checkProbes(Check& check, const Probes& p, SunTransfer sun) {
  constexpr const char* kName = "the probes";
  const std::size_t n = spanOf(p.sky_scale()).size();
  const std::size_t modes = spanOf(p.mode_scale()).size();
  check.that(n <= kMostProbes, kName, "must be at most 255");
  check.that(within(double{p.low_y()}, -kFarthest_m, kFarthest_m) &&
                 within(double{p.high_y()}, double{p.low_y()}, kFarthest_m),
             kName, "have a height out of its domain");
  check.that(spanOf(p.position()).size() == 3 * n, kName, "must have a position each");
  check.that(spanOf(p.visibility()).size() == 3 * n, kName, "must have a visibility for every direction up");
  check.that(spanOf(p.sky()).size() == kDirections * 2 * 3 * n && spanOf(p.sky_side()).size() == spanOf(p.sky()).size(),
             kName, "must have every coefficient of the sky");
  checkModes(check, p, sun);
  check.that(spanOf(p.sun_scale()).size() == (modes > 0 ? n : 0) && spanOf(p.sun()).size() == kDirections * modes * n,
             kName, "must have a number of the sun for every direction and mode");
  const std::size_t emitting = spanOf(p.emitted_scale()).size();
  check.that((emitting == 0 || emitting == n) && spanOf(p.emitted()).size() == kDirections * 3 * emitting, kName,
             "must have emitted light for every direction and channel, or none at all");
  check.that(
      areScales(spanOf(p.sky_scale())) && areScales(spanOf(p.sun_scale())) && areScales(spanOf(p.emitted_scale())),
      kName, "have a scale out of its domain");
}

void checkError(Check& check, const SectorError& e, std::size_t probes) {
  const double numbers[] = {e.sampling(), e.position_m(), e.visibility(),      e.sky(),        e.sun(),
                            e.emitted(),  e.modes_rms(),  e.modes_worst_row(), e.modes_worst()};
  check.that(within(std::span<const double>(numbers), 0.0, kAny) &&
                 (probes == 0 ? e.sampling_probe() == 0 : e.sampling_probe() < probes),
             "the errors", "have a value out of their domain");
}

/// Whether every probe has as many lights as `counts` says, in ascending order and below `lights`.
bool areLightsOf(std::span<const std::uint8_t> counts, std::span<const std::uint16_t> light, std::size_t lights) {
  std::size_t next = 0;
  for (const std::uint8_t count : counts) {
    for (std::size_t i = next; i < next + count; ++i)
      if (light[i] >= lights || (i > next && light[i] <= light[i - 1])) return false;
    next += count;
  }
  return true;
}

void checkLocal(Check& check, const LocalTransfer& l, std::size_t probes) {
  constexpr const char* kName = "the local transfer";
  constexpr std::size_t kNumbers = 4 * 3;
  const auto position = spanOf(l.position());
  const auto counts = spanOf(l.count());
  const auto light = spanOf(l.light());
  const auto radiance = spanOf(l.radiance());
  const std::size_t lights = position.size() / 3;
  const std::size_t transfers = std::accumulate(counts.begin(), counts.end(), std::size_t{0});
  check.that(
      position.size() == 3 * lights && lights <= kMostVirtualLights && within(position, -kFarthest_m, kFarthest_m),
      kName, "must have a position for every light, within 10000 km");
  check.that(counts.size() == probes &&
                 std::all_of(counts.begin(), counts.end(), [](std::uint8_t n) { return n <= kMostLocalLights; }),
             kName, "must have a count for every probe, at most 128");
  if (!check.that(
          light.size() == transfers && spanOf(l.scale()).size() == transfers && radiance.size() == kNumbers * transfers,
          kName, "must have every number of its transfers"))
    return;
  check.that(areLightsOf(counts, light, lights), kName, "must have ascending lights that are there");
  check.that(areScales(spanOf(l.scale())), kName, "has a scale out of its domain");
  for (std::size_t i = 0; i < radiance.size(); ++i)
    check.that(i % kNumbers >= 3 || radiance[i] >= 0, kName, "must have no influence below 0");
  if (l.error() == nullptr) return;
  const LocalError& e = *l.error();
  const double errors[] = {e.sampling(), e.position_m(), e.radiance()};
  const double shares[] = {e.lost(), e.worst_probe()};
  check.that(within(std::span<const double>(errors), 0.0, kAny) && within(std::span<const double>(shares), 0.0, 1.0) &&
                 (probes == 0 ? e.sampling_probe() == 0 : e.sampling_probe() < probes),
             "the errors", "have a value out of their domain");
}

void checkRooms(Check& check, const Sector& sector, std::size_t probes) {
  constexpr const char* kName = "the rooms";
  const auto in_room = spanOf(sector.in_room());
  const auto* rooms = sector.room();
  if (rooms == nullptr || rooms->size() == 0) {
    check.that(in_room.empty(), kName, "must be there where a probe is in one");
    return;
  }
  if (!check.that(rooms->size() <= kMostRooms, kName, "must be at most 254") ||
      !check.that(in_room.size() == probes &&
                      std::all_of(in_room.begin(), in_room.end(), [=](std::uint8_t r) { return r <= rooms->size(); }),
                  kName, "must say for every probe whether it is in one of them") ||
      !check.that(reinterpret_cast<std::uintptr_t>(rooms->Data()) % alignof(Room) == 0, kName, "are misaligned"))
    return;
  std::uint8_t number = 0;
  for (const Room* r : *rooms) {
    ++number;
    for (const auto& [low, high] :
         {std::pair(r->low_x(), r->high_x()), std::pair(r->low_y(), r->high_y()), std::pair(r->low_z(), r->high_z())})
      check.that(within(double{low}, -kFarthest_m, kFarthest_m) && within(double{high}, double{low}, kFarthest_m),
                 kName, "must be boxes within 10000 km");
    check.that(r->probe() == kNoProbe || (r->probe() < probes && in_room[r->probe()] == number), kName,
               "must name a probe of their own");
  }
}

void checkPlacement(Check& check, const Placement& placement) {
  constexpr auto kName = "the named places";
  const auto* named = placement.named();
  if (named == nullptr || named->size() == 0) return;
  if (!check.that(named->size() <= kMostNamedPlaces, kName, "must be at most 32") ||
      !check.that(reinterpret_cast<std::uintptr_t>(named->Data()) % alignof(NamedPlace) == 0, kName, "are misaligned"))
    return;
  for (const NamedPlace* n : *named) {
    const std::array<double, 3> position{n->x(), n->y(), n->z()};
    check.that(within(std::span<const double>(position), -kFarthest_m, kFarthest_m), kName, "must be within 10000 km");
    check.that(n->kind() <= PlaceKind::MAX, kName, "must be of a kind");
    check.that(n->kind() == PlaceKind::moved ? within(n->moved_m(), 0.0, kFarthest_m) : n->moved_m() == 0.0, kName,
               "must have moved where they say so, and only there");
  }
}

}  // namespace

Fault sectorFaultOf(const File& file) {
  Check check;
  const auto* sector = file.sector();
  if (!check.that(sector != nullptr, "sector", "is missing") ||
      !check.that(sector->probes() != nullptr, "the probes", "are missing") ||
      !check.that(sector->baked_from() != nullptr, "the hash of what it was baked from", "is missing"))
    return check.fault;
  check.that(file.settings() != nullptr, "settings", "are missing");
  check.that(isPlace(sector->x(), sector->z()), "the sector", "must be -15625 to 15625 on each axis");
  check.that(sector->sun() <= SunTransfer::MAX, "sun", "must be none, sh or directional");
  check.that(within(sector->low_y(), -kFarthest_m, kFarthest_m) && within(sector->cell_height_m(), 1e-3, kFarthest_m),
             "the grid", "has a height out of its domain");
  checkProbes(check, *sector->probes(), sector->sun());
  if (check.fault.what != nullptr) return check.fault;
  const auto grid = spanOf(sector->grid());
  const std::uint32_t probes = probesOf(*sector);
  check.that(grid.size() == kGridCells, "the grid", "must have 4096 cells");
  check.that(std::all_of(grid.begin(), grid.end(), [=](std::uint8_t c) { return c == kNoProbe || c < probes; }),
             "the grid", "names a probe that is not there");
  const auto top = spanOf(sector->top());
  check.that(
      top.size() == kTopCells &&
          std::all_of(top.begin(), top.end(), [=](std::uint8_t c) { return probes == 0 ? c == kNoProbe : c < probes; }),
      "the view from above", "must name a probe for each of 256 cells");
  checkRooms(check, *sector, probes);
  if (sector->placement() != nullptr) checkPlacement(check, *sector->placement());
  check.that(sector->unlit() <= probes, "the unlit probes", "must be at most all");
  if (sector->error() != nullptr) checkError(check, *sector->error(), probes);
  if (sector->local() != nullptr) checkLocal(check, *sector->local(), probes);
  return check.fault;
}

Fault levelFaultOf(const File& file) {
  Check check;
  const auto* level = file.level();
  if (!check.that(level != nullptr, "level", "is missing") ||
      !check.that(level->all_sectors() != nullptr, "the hash of all sectors", "is missing"))
    return check.fault;
  check.that(file.settings() != nullptr, "settings", "are missing");
  check.that(level->sun() <= SunTransfer::MAX, "sun", "must be none, sh or directional");
  check.that(within(level->sun_bounce_scale(), 0.0, kAny) && within(level->sky_scale(), 0.0, kAny), "scale",
             "has a value out of its domain");
  for (const auto& [path, name] : {std::pair(level->sun_path(), "sun"), std::pair(level->moon_path(), "moon")})
    if (path != nullptr) {
      const char* fault = faultOf(*path);
      check.that(fault == nullptr, name, fault);
    }
  check.that((level->sun_path() != nullptr) == (level->sun() == SunTransfer::directional), "sun",
             "must have a path where its transfer is directional, and only there");
  if (check.fault.what != nullptr || level->sectors() == nullptr) return check.fault;
  if (!check.that(reinterpret_cast<std::uintptr_t>(level->sectors()->Data()) % alignof(SectorEntry) == 0, "the sectors",
                  "are misaligned"))
    return check.fault;
  const SectorEntry* before = nullptr;
  for (const auto* s : *level->sectors()) {
    check.that(isPlace(s->x(), s->z()) && s->probes() <= kMostProbes, "a sector", "has a number out of its domain");
    check.that(before == nullptr || before->x() < s->x() || (before->x() == s->x() && before->z() < s->z()),
               "the sectors", "must ascend");
    before = s;
  }
  return check.fault;
}

}  // namespace welkin::format
