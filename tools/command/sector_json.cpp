// SPDX-License-Identifier: Apache-2.0
#include "command/sector_json.h"

#include <fmt/format.h>

#include "command/sky_json.h"
#include "format/container.h"
#include "format/sector_check.h"
#include "probes/build/bake_section.h"
#include "probes/build/sector_report.h"
#include "probes/geometry/sector_name.h"
#include "probes/sectors/occlusion_tile.h"

namespace welkin::command {
namespace {

using Json = nlohmann::ordered_json;
using f64::Number3;
using transfer::kDirections;

Json vectorJson(const Number3& v) {
  return {v.x, v.y, v.z};
}

/// {"r": [direction][number], "g": ..., "b": ...} from value(direction, number).
template <typename Value>
Json channelsJson(std::size_t numbers, const Value& value) {
  Json json;
  for (int channel = 0; channel < 3; ++channel) {
    Json directions = Json::array();
    for (std::size_t b = 0; b < kDirections; ++b) {
      Json row = Json::array();
      for (std::size_t i = 0; i < numbers; ++i) row.push_back(value(b, i)[channel]);
      directions.push_back(row);
    }
    json[std::string(1, "rgb"[channel])] = directions;
  }
  return json;
}

/// Local transfers of a probe: coefficients of radiance by channel.
Json localJson(const std::vector<transfer::LocalTransfer>& transfers) {
  Json json = Json::array();
  for (const transfer::LocalTransfer& t : transfers) {
    Json radiance;
    for (int channel = 0; channel < 3; ++channel) {
      Json& row = radiance[std::string(1, "rgb"[channel])];
      for (const Number3& coefficient : t.radiance) row.push_back(coefficient[channel]);
    }
    json.push_back({{"light", t.light}, {"radiance", radiance}});
  }
  return json;
}

Json probeJson(const Number3& position, const transfer::ProbeTransfer& t, const transfer::SunCoefficients& sun,
               const std::vector<transfer::LocalTransfer>& local) {
  Json json = {{"position", vectorJson(position)},
               {"visibility", t.visibility},
               {"transfer", channelsJson(4, [&](std::size_t b, std::size_t k) { return t.sky[b][k]; })},
               {"sun", sun}};
  Json emitted = Json::array();
  for (const Number3& e : t.emitted) emitted.push_back(vectorJson(e));
  json["emitted"] = emitted;
  json["local_count"] = local.size();
  json["local"] = localJson(local);
  return json;
}

/// Positions of the virtual lights.
Json lightsJson(const sectors::SectorFile& s) {
  Json lights = Json::array();
  if (!s.local) return lights;
  const auto& p = s.local->encoded.position;
  const f64::Number3 corner = geometry::cornerOf(s.id);
  for (std::size_t i = 0; i < p.size(); i += 3)
    lights.push_back({corner.x + double{p[i]}, double{p[i + 1]}, corner.z + double{p[i + 2]}});
  return lights;
}

Json roomsJson(const sectors::SectorFile& s) {
  const f64::Number3 corner = geometry::cornerOf(s.id);
  Json list = Json::array();
  for (const geometry::Room& r : s.room) {
    const f64::Number3 low = r.box.low + corner;
    const f64::Number3 high = r.box.high + corner;
    list.push_back({{"box", {low.x, low.y, low.z, high.x, high.y, high.z}}, {"probe", r.probe}});
  }
  return list;
}

Json doorsJson(const sectors::SectorFile& s) {
  const f64::Number3 corner = geometry::cornerOf(s.id);
  Json list = Json::array();
  for (const geometry::Door& d : s.door) {
    const f64::Number3 low = d.box.low + corner, high = d.box.high + corner;
    list.push_back({{"box", {low.x, low.y, low.z, high.x, high.y, high.z}}, {"room", d.room + 1}});
  }
  return list;
}

/// The cut cells with their trees, and the planes and masks that these name (runtime/format/welkin.fbs).
Json cutsJson(const sectors::SectorFile& s) {
  Json planes = Json::array();
  for (const format::CutPlane& plane : s.cuts.plane) {
    const format::FromCorner n = format::normalOf(plane);
    planes.push_back({{"normal", {n[0], n[1], n[2]}}, {"offset", plane.offset()}});
  }
  return {{"cells", s.cuts.cell},
          {"trees", s.cuts.tree},
          {"nodes", s.cuts.node},
          {"planes", planes},
          {"masks", s.cuts.mask}};
}

/// The occlusion tile, one number per cell seen from above; empty arrays in a sector without probes.
Json occlusionJson(const sectors::SectorFile& s, const transfer::SectorProbes& decoded) {
  const auto tile = sectors::occlusionTileOf(s.top, decoded);
  const Json none = Json::array();
  return {{"probe", tile ? Json(s.top) : none},
          {"sky_visibility", tile ? Json(tile->sky_visibility) : none},
          {"probe_y", tile ? Json(tile->probe_y) : none}};
}

Json modesJson(const transfer::SunModes& m) {
  Json modes = Json::array();
  for (std::size_t i = 0; i < m.count(); ++i) {
    Json mode = Json::array();
    for (std::size_t k = 0; k < m.knots(); ++k) mode.push_back(vectorJson(m.value[i * m.knots() + k]));
    modes.push_back(mode);
  }
  return {{"sun_time_h", m.sun_time_h}, {"moon_time_h", m.moon_time_h}, {"modes", modes}};
}

/// Adds the sizes of the parts of "probes".
void addParts(Json& bytes, const transfer::ProbeBytes& probes) {
  bytes["probes_position"] = probes.position;
  bytes["probes_visibility"] = probes.visibility;
  bytes["probes_sky"] = probes.sky;
  bytes["probes_sun"] = probes.sun;
  bytes["probes_emitted"] = probes.emitted;
  bytes["probes_scales"] = probes.scales;
  bytes["probes_heights"] = probes.heights;
  bytes["probes_modes"] = probes.modes;
}

}  // namespace

Json bytesJson(const sectors::SectorFile& s, std::size_t total) {
  const std::size_t header = sizeof(format::Header);
  const std::size_t probes = s.probes.bytes().total();
  const std::size_t grid = s.grid.size();
  const std::size_t local = s.local ? s.local->encoded.bytes() : 0;
  const std::size_t settings = s.settings.size();
  const std::size_t rooms =
      s.room.size() * sizeof(format::Room) + s.in_room.size() + s.door.size() * sizeof(format::Door);
  const std::size_t cuts = s.cuts.bytes();
  Json bytes = {{"probes", probes},
                {"grid", grid},
                {"occlusion", s.top.size()},
                {"rooms", rooms},
                {"cuts", cuts},
                {"local", local},
                {"settings", settings},
                {"header", header},
                {"structure", total - header - probes - grid - s.top.size() - rooms - cuts - local - settings},
                {"total", total},
                {"a_probe", s.probes.bytesAProbe()}};
  addParts(bytes, s.probes.bytes());
  if (!s.local) return bytes;
  const transfer::EncodedLocal& e = s.local->encoded;
  const auto of = [](const auto& array) { return array.size() * sizeof array[0]; };
  bytes["local_position"] = of(e.position);
  bytes["local_count"] = of(e.count);
  bytes["local_light"] = of(e.light);
  bytes["local_scale"] = of(e.scale);
  bytes["local_radiance"] = of(e.radiance);
  return bytes;
}

Json sectorJson(const sectors::SectorFile& s, std::size_t total) {
  const transfer::SectorProbes decoded = transfer::decodedProbes(s.probes, s.id);
  const transfer::SectorLocal local = s.local ? transfer::decodedLocal(s.local->encoded) : transfer::SectorLocal{};
  const double x = s.id.x * geometry::kSector_m;
  const double z = s.id.z * geometry::kSector_m;
  Json list = Json::array();
  for (std::size_t i = 0; i < decoded.position.size(); ++i)
    list.push_back(probeJson(decoded.position[i], decoded.transfer[i], decoded.sun[i],
                             s.local ? local.probe[i] : std::vector<transfer::LocalTransfer>{}));
  for (std::size_t i = 0; i < s.in_room.size(); ++i) list[i]["room"] = s.in_room[i];
  Json sector = {
      {"x", s.id.x},
      {"z", s.id.z},
      {"bounds",
       {x, s.low_y, z, x + geometry::kSector_m, s.low_y + geometry::kCells * s.cell_height_m, z + geometry::kSector_m}},
      {"cell_height_m", s.cell_height_m},
      {"sun", build::nameOf(s.sun)},
      {"bytes", bytesJson(s, total)},
      {"rays", s.rays},
      {"error", build::errorJson(s)},
      {"placement", build::placementJson(s)},
      {"baked_from", build::fromJson(s.baked_from)},
      {"light", modesJson(decoded.modes)},
      {"virtual_lights", lightsJson(s)},
      {"probes", list},
      {"grid", s.grid},
      {"occlusion", occlusionJson(s, decoded)},
      {"rooms", roomsJson(s)},
      {"doors", doorsJson(s)},
      {"cuts", cutsJson(s)},
      {"unlit", s.unlit}};
  return {{"sector", sector}, {"settings", settingsJson(s.settings)}};
}

Json indexJson(const sectors::LevelIndex& index) {
  Json sectors = Json::array();
  for (const sectors::SectorEntry& s : index.sector)
    sectors.push_back({{"x", s.id.x},
                       {"z", s.id.z},
                       {"probes", s.probes},
                       {"bytes", s.bytes},
                       {"xxh3_128", textOf(s.checksum)},
                       {"baked_from", textOf(s.baked_from)}});
  Json level = {{"sectors", sectors},
                {"all_sectors", textOf(index.all_sectors)},
                {"sky_xxh3_128", index.sky_checksum ? Json(textOf(*index.sky_checksum)) : Json(nullptr)},
                {"sun", build::nameOf(index.sun)},
                {"scale", {{"sky", index.scale.sky}, {"sun_bounce", index.scale.sun_bounce}}}};
  return {{"level", level}, {"settings", settingsJson(index.settings)}};
}

}  // namespace welkin::command
