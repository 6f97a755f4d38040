// SPDX-License-Identifier: Apache-2.0
#include "probes/sectors/level_index.h"

#include "format/domain_check.h"
#include "probes/sectors/hash_record.h"
#include "sky/bake/checked_file.h"
#include "sky/bake/encode.h"

namespace welkin::sectors {
namespace {

std::optional<model::LightPath> decode(const format::LightPath* p) {
  if (p == nullptr) return std::nullopt;
  const auto copyOf = [](const flatbuffers::Vector<double>* v) {
    const auto values = format::spanOf(v);
    return std::vector<double>(values.begin(), values.end());
  };
  return model::LightPath{p->latitude_rad(),
                          p->declination_rad(),
                          p->transit_h(),
                          p->north_offset_rad(),
                          copyOf(p->key_time_h()),
                          copyOf(p->key_azimuth_rad()),
                          copyOf(p->key_elevation_rad())};
}

}  // namespace

base::Hash128 hashOf(const std::vector<SectorEntry>& sectors) {
  base::Hasher hasher;
  for (const SectorEntry& s : sectors) {
    hasher.add(s.id.x);
    hasher.add(s.id.z);
    hasher.add(s.baked_from);
  }
  return hasher.digest();
}

std::vector<std::byte> encodeLevel(const LevelIndex& index) {
  flatbuffers::FlatBufferBuilder b(1 << 14);
  std::vector<format::SectorEntry> entries;
  for (const SectorEntry& s : index.sector)
    entries.emplace_back(s.id.x, s.id.z, static_cast<std::uint32_t>(s.probes), s.bytes, encode(s.checksum),
                         encode(s.baked_from));
  const auto sectors = b.CreateVectorOfStructs(entries);
  const auto sun_path = index.sun_path ? bake::encodePath(b, *index.sun_path) : 0;
  const auto moon_path = index.moon_path ? bake::encodePath(b, *index.moon_path) : 0;
  const auto number = [&](std::size_t c) { return static_cast<float>(index.ground_albedo[c]); };
  const format::Rgb ground(number(0), number(1), number(2));
  const format::Hash all_sectors = encode(index.all_sectors);
  const format::Hash sky_checksum = encode(index.sky_checksum.value_or(base::Hash128{}));
  const auto level = format::CreateLevel(b, sectors, &all_sectors, index.sky_checksum ? &sky_checksum : nullptr,
                                         static_cast<format::SunTransfer>(index.sun), sun_path, moon_path,
                                         index.scale.sun_bounce, index.scale.sky, &ground);
  const auto settings = b.CreateString(index.settings);
  format::FinishFileBuffer(b, format::CreateFile(b, settings, 0, 0, 0, level));
  return format::seal({b.GetBufferPointer(), b.GetSize()}, format::Kind::level);
}

LevelIndex decodeLevel(std::span<const std::byte> bytes, const std::string& name) {
  const format::File& file = bake::openChecked(bytes, name, format::Kind::level, format::levelFaultOf);
  const format::Level& level = *file.level();
  LevelIndex index;
  if (level.sectors() != nullptr)
    for (const format::SectorEntry* s : *level.sectors())
      index.sector.push_back(
          {{s->x(), s->z()}, s->probes(), s->bytes(), decode(s->checksum()), decode(s->baked_from())});
  index.all_sectors = decode(*level.all_sectors());
  if (level.sky_checksum() != nullptr) index.sky_checksum = decode(*level.sky_checksum());
  index.sun = static_cast<transfer::SunTransfer>(level.sun());
  index.sun_path = decode(level.sun_path());
  index.moon_path = decode(level.moon_path());
  index.scale = {level.sky_scale(), level.sun_bounce_scale()};
  if (const format::Rgb* a = level.ground_albedo(); a != nullptr)
    index.ground_albedo = {double{a->r()}, double{a->g()}, double{a->b()}};
  index.settings = file.settings()->str();
  return index;
}

}  // namespace welkin::sectors
