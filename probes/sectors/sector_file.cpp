// SPDX-License-Identifier: Apache-2.0
#include "probes/sectors/sector_file.h"

#include <algorithm>

#include "format/domain_check.h"
#include "format/sector_check.h"
#include "probes/geometry/sector_name.h"
#include "probes/sectors/hash_record.h"
#include "sky/bake/checked_file.h"

namespace welkin::sectors {
namespace {

static_assert(geometry::kMostProbes == format::kMostProbes && geometry::kNoProbe == format::kNoProbe &&
                  geometry::kCells * geometry::kCells * geometry::kCells == format::kGridCells &&
                  transfer::kMostSunModes == format::kMostSunModes && geometry::kMostRooms == format::kMostRooms &&
                  geometry::kMostDoors == format::kMostDoors &&
                  4 * placement::kMostNamed + placement::kMostNamedByHand <= format::kMostNamedPlaces &&
                  geometry::kFarthestSector == format::kFarthestSector,
              "what a bake makes and what a file may hold");
static_assert(static_cast<format::PlaceKind>(placement::NamedPlace::Kind::moved) == format::PlaceKind::moved &&
                  static_cast<format::PlaceKind>(placement::NamedPlace::Kind::thinned) == format::PlaceKind::thinned,
              "the file's kinds in the file's order");

using flatbuffers::FlatBufferBuilder;
using flatbuffers::Offset;
using format::spanOf;

template <typename T>
Offset<flatbuffers::Vector<T>> vectorOf(FlatBufferBuilder& b, const std::vector<T>& values) {
  return values.empty() ? 0 : b.CreateVector(values);
}

template <typename T>
std::vector<T> copyOf(const flatbuffers::Vector<T>* vector) {
  const std::span<const T> values = spanOf(vector);
  return {values.begin(), values.end()};
}

Offset<format::Probes> encode(FlatBufferBuilder& b, const transfer::EncodedProbes& p) {
  const auto position = vectorOf(b, p.position);
  const auto visibility = vectorOf(b, p.visibility);
  const auto sky_scale = vectorOf(b, p.sky_scale);
  const auto sky = vectorOf(b, p.sky);
  const auto sky_side = vectorOf(b, p.sky_side);
  const auto sun_scale = vectorOf(b, p.sun_scale);
  const auto sun = vectorOf(b, p.sun);
  const auto emitted_scale = vectorOf(b, p.emitted_scale);
  const auto emitted = vectorOf(b, p.emitted);
  const auto sun_time_h = vectorOf(b, p.sun_time_h);
  const auto moon_time_h = vectorOf(b, p.moon_time_h);
  const auto coefficient_scale = vectorOf(b, p.coefficient_scale);
  const auto mode_scale = vectorOf(b, p.mode_scale);
  const auto mode = vectorOf(b, p.mode);
  return format::CreateProbes(b, p.low_y, p.high_y, position, visibility, sky_scale, sky, sky_side, sun_scale, sun,
                              emitted_scale, emitted, sun_time_h, moon_time_h, coefficient_scale, mode_scale, mode);
}

transfer::EncodedProbes decode(const format::Probes& p) {
  transfer::EncodedProbes e;
  e.low_y = p.low_y();
  e.high_y = p.high_y();
  e.position = copyOf(p.position());
  e.visibility = copyOf(p.visibility());
  e.sky_scale = copyOf(p.sky_scale());
  e.sky = copyOf(p.sky());
  e.sky_side = copyOf(p.sky_side());
  e.sun_scale = copyOf(p.sun_scale());
  e.sun = copyOf(p.sun());
  e.emitted_scale = copyOf(p.emitted_scale());
  e.emitted = copyOf(p.emitted());
  e.sun_time_h = copyOf(p.sun_time_h());
  e.moon_time_h = copyOf(p.moon_time_h());
  e.coefficient_scale = copyOf(p.coefficient_scale());
  e.mode_scale = copyOf(p.mode_scale());
  e.mode = copyOf(p.mode());
  return e;
}

Offset<format::SectorError> encode(FlatBufferBuilder& b, const SectorError& e) {
  return format::CreateSectorError(b, e.sampling, static_cast<std::uint8_t>(e.sampling_probe), e.encoding.position_m,
                                   e.encoding.visibility, e.encoding.sky, e.encoding.sun, e.encoding.emitted,
                                   e.modes.rms, e.modes.worst_row, e.modes.worst);
}

SectorError decode(const format::SectorError& e) {
  return {e.sampling(),
          e.sampling_probe(),
          {e.position_m(), e.visibility(), e.sky(), e.sun(), e.emitted()},
          {e.modes_rms(), e.modes_worst_row(), e.modes_worst()}};
}

Offset<format::LocalTransfer> encode(FlatBufferBuilder& b, const BakedLocal& l) {
  const auto position = vectorOf(b, l.encoded.position);
  const auto count = vectorOf(b, l.encoded.count);
  const auto light = vectorOf(b, l.encoded.light);
  const auto scale = vectorOf(b, l.encoded.scale);
  const auto radiance = vectorOf(b, l.encoded.radiance);
  const auto error = format::CreateLocalError(
      b, l.sampling.error, static_cast<std::uint8_t>(l.sampling.probe), l.encoding.position_m, l.encoding.radiance,
      static_cast<std::uint32_t>(l.thinning.dropped), l.thinning.lost, l.thinning.worst_probe);
  return format::CreateLocalTransfer(b, position, count, light, scale, radiance, error, l.sampling.rays);
}

BakedLocal decode(const format::LocalTransfer& l) {
  BakedLocal local;
  local.encoded = {copyOf(l.position()), copyOf(l.count()), copyOf(l.light()), copyOf(l.scale()), copyOf(l.radiance())};
  local.sampling.rays = l.rays();
  local.thinning.kept = local.encoded.light.size();
  if (const format::LocalError* e = l.error(); e != nullptr) {
    local.sampling.error = e->sampling();
    local.sampling.probe = e->sampling_probe();
    local.encoding = {e->position_m(), e->radiance()};
    local.thinning.dropped = e->dropped();
    local.thinning.lost = e->lost();
    local.thinning.worst_probe = e->worst_probe();
  }
  return local;
}

Offset<format::Placement> encode(FlatBufferBuilder& b, const placement::PlacementCounts& c) {
  const auto count = [](std::size_t n) { return static_cast<std::uint32_t>(n); };
  std::vector<format::NamedPlace> places;
  for (const placement::NamedPlace& n : c.named)
    places.emplace_back(n.position.x, n.position.y, n.position.z, n.moved_m, static_cast<format::PlaceKind>(n.kind),
                        n.by_hand);
  const auto named = places.empty() ? 0 : b.CreateVectorOfStructs(places);
  return format::CreatePlacement(b, count(c.columns), count(c.ground), count(c.walkable), count(c.moved),
                                 count(c.inside), count(c.too_close), count(c.thinned), count(c.uncovered),
                                 count(c.cells_without), count(c.by_hand_moved), count(c.by_hand_dropped), named);
}

placement::PlacementCounts decode(const format::Placement& p) {
  placement::PlacementCounts c{p.columns(),       p.ground(),        p.walkable(),        p.moved(),
                               p.inside(),        p.too_close(),     p.thinned(),         p.uncovered(),
                               p.cells_without(), p.by_hand_moved(), p.by_hand_dropped(), {}};
  if (p.named() == nullptr) return c;
  for (const format::NamedPlace* n : *p.named())
    c.named.push_back(
        {{n->x(), n->y(), n->z()}, n->moved_m(), static_cast<placement::NamedPlace::Kind>(n->kind()), n->by_hand()});
  return c;
}

Offset<flatbuffers::Vector<const format::Room*>> encode(FlatBufferBuilder& b,
                                                        const std::vector<geometry::Room>& rooms) {
  std::vector<format::Room> result;
  const auto number = [](double v) { return static_cast<float>(v); };
  for (const geometry::Room& r : rooms)
    result.emplace_back(number(r.box.low.x), number(r.box.low.y), number(r.box.low.z), number(r.box.high.x),
                        number(r.box.high.y), number(r.box.high.z), r.probe);
  return result.empty() ? 0 : b.CreateVectorOfStructs(result);
}

std::vector<geometry::Room> decode(const flatbuffers::Vector<const format::Room*>& rooms) {
  std::vector<geometry::Room> result;
  for (const format::Room* r : rooms)
    result.push_back({{{double{r->low_x()}, double{r->low_y()}, double{r->low_z()}},
                       {double{r->high_x()}, double{r->high_y()}, double{r->high_z()}}},
                      r->probe()});
  return result;
}

Offset<flatbuffers::Vector<const format::Door*>> encode(FlatBufferBuilder& b,
                                                        const std::vector<geometry::Door>& doors) {
  std::vector<format::Door> result;
  const auto number = [](double v) { return static_cast<float>(v); };
  for (const geometry::Door& d : doors)
    result.emplace_back(number(d.box.low.x), number(d.box.low.y), number(d.box.low.z), number(d.box.high.x),
                        number(d.box.high.y), number(d.box.high.z), d.room);
  return result.empty() ? 0 : b.CreateVectorOfStructs(result);
}

std::vector<geometry::Door> decode(const flatbuffers::Vector<const format::Door*>& doors) {
  std::vector<geometry::Door> result;
  for (const format::Door* d : doors)
    result.push_back({{{double{d->low_x()}, double{d->low_y()}, double{d->low_z()}},
                       {double{d->high_x()}, double{d->high_y()}, double{d->high_z()}}},
                      d->room()});
  return result;
}

Offset<format::Cuts> encode(FlatBufferBuilder& b, const placement::SectorCuts& c) {
  const auto cell = vectorOf(b, c.cell);
  const auto tree = vectorOf(b, c.tree);
  const auto node = vectorOf(b, c.node);
  const auto plane = c.plane.empty() ? 0 : b.CreateVectorOfStructs(c.plane);
  const auto mask = vectorOf(b, c.mask);
  return format::CreateCuts(b, cell, tree, node, plane, mask);
}

placement::SectorCuts decode(const format::Cuts& c) {
  placement::SectorCuts cuts{copyOf(c.cell()), copyOf(c.tree()), copyOf(c.node()), {}, copyOf(c.mask())};
  if (c.plane() != nullptr)
    for (const format::CutPlane* plane : *c.plane()) cuts.plane.push_back(*plane);
  return cuts;
}

}  // namespace

std::vector<std::byte> encodeSector(const SectorFile& s) {
  FlatBufferBuilder b(1 << 16);
  b.ForceVectorAlignment(s.grid.size(), 1, 16);
  const auto grid = b.CreateVector(s.grid.data(), s.grid.size());
  const auto probes = encode(b, s.probes);
  const auto error = encode(b, s.error);
  const format::BakedFrom baked_from(encode(s.baked_from.all), encode(s.baked_from.surfaces),
                                     encode(s.baked_from.settings), encode(s.baked_from.light_paths));
  const auto placement = encode(b, s.placement);
  const Offset<format::LocalTransfer> local = s.local ? encode(b, *s.local) : 0;
  b.ForceVectorAlignment(s.top.size(), 1, 16);
  const auto top = b.CreateVector(s.top.data(), s.top.size());
  const auto room = encode(b, s.room);
  const auto in_room = vectorOf(b, s.in_room);
  const Offset<format::Cuts> cuts = s.cuts.empty() ? 0 : encode(b, s.cuts);
  const auto door = encode(b, s.door);
  const auto sector = format::CreateSector(
      b, s.id.x, s.id.z, s.low_y, s.cell_height_m, grid, static_cast<format::SunTransfer>(s.sun), probes, &baked_from,
      placement, s.rays, error, local, top, room, in_room, static_cast<std::uint32_t>(s.unlit), cuts, door);
  const auto settings = b.CreateString(s.settings);
  format::FinishFileBuffer(b, format::CreateFile(b, settings, 0, 0, sector));
  return format::seal({b.GetBufferPointer(), b.GetSize()}, format::Kind::sector);
}

SectorFile decodeSector(std::span<const std::byte> bytes, const std::string& name) {
  const format::File& file = bake::openChecked(bytes, name, format::Kind::sector, format::sectorFaultOf);
  const format::Sector& sector = *file.sector();
  SectorFile s;
  s.id = {sector.x(), sector.z()};
  s.low_y = sector.low_y();
  s.cell_height_m = sector.cell_height_m();
  std::copy(sector.grid()->begin(), sector.grid()->end(), s.grid.begin());
  s.sun = static_cast<transfer::SunTransfer>(sector.sun());
  s.probes = decode(*sector.probes());
  s.settings = file.settings()->str();
  const format::BakedFrom& from = *sector.baked_from();
  s.baked_from = {decode(from.all()), decode(from.surfaces()), decode(from.settings()), decode(from.light_paths())};
  if (sector.placement() != nullptr) s.placement = decode(*sector.placement());
  s.rays = sector.rays();
  if (sector.error() != nullptr) s.error = decode(*sector.error());
  if (sector.local() != nullptr) s.local = decode(*sector.local());
  std::copy(sector.top()->begin(), sector.top()->end(), s.top.begin());
  if (sector.room() != nullptr) s.room = decode(*sector.room());
  s.in_room = copyOf(sector.in_room());
  s.unlit = sector.unlit();
  if (sector.door() != nullptr) s.door = decode(*sector.door());
  if (sector.cuts() != nullptr) s.cuts = decode(*sector.cuts());
  return s;
}

}  // namespace welkin::sectors
