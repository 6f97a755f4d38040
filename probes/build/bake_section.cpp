// SPDX-License-Identifier: Apache-2.0
#include "probes/build/bake_section.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "probes/geometry/sector_name.h"
#include "probes/level/level_domain.h"
#include "sky/base/section.h"

namespace welkin::build {

using f64::Number3;
namespace {

using base::Section;
using base::TomlTable;

constexpr const char* kPoint = "[x, y, z]";
constexpr const char* kBox = "[min_x, min_y, min_z, max_x, max_y, max_z]";

geometry::Box boxOf(const TomlTable& table, const std::string& key, const toml::node* at,
                    const std::vector<double>& n) {
  for (std::size_t i = 0; i < 3; ++i)
    if (!(n[i] < n[i + 3]))
      table.refuse(key, at, fmt::format("every least coordinate of a box, {}, must be below its greatest", kBox));
  return {{n[0], n[1], n[2]}, {n[3], n[4], n[5]}};
}

placement::PlacementSettings readProbes(Section section) {
  TomlTable& table = section.table();
  placement::PlacementSettings probes;
  probes.spacing_m = section.number("spacing_m");
  probes.vegetation_spacing_m = section.number("vegetation_spacing_m");
  probes.minimum_separation_m = section.number("minimum_separation_m");
  probes.height_m = section.number("height_m");
  probes.headroom_m = section.number("headroom_m");
  probes.clearance_m = section.number("clearance_m");
  probes.coverage_m = section.number("coverage_m");
  probes.walls = section.word("walls") == "ignore" ? placement::Walls::ignore : placement::Walls::cut;
  for (const auto& p : table.lists("add", 3, section.rangeOf("add"), kPoint)) probes.add.push_back({p[0], p[1], p[2]});
  for (const auto& box : table.lists("remove", 6, section.rangeOf("remove"), kBox))
    probes.remove.push_back(boxOf(table, "remove", table.node("remove"), box));
  for (const auto& box : table.lists("within", 6, section.rangeOf("within"), kBox))
    probes.within.push_back(boxOf(table, "within", table.node("within"), box));
  table.finish();
  return probes;
}

/// The doors of a room.
void readDoors(TomlTable& table, const geometry::Box& room, std::vector<placement::RoomDoor>& doors) {
  constexpr const char* kKey = "doors";
  if (!table.has(kKey)) return;
  const toml::node* node = table.node(kKey);
  const base::Range& range = base::parameterOf(level::levelDomain(), "[room]", kKey).range;
  for (const auto& numbers : table.lists(kKey, 6, range, kBox)) {
    const geometry::Box box = boxOf(table, kKey, node, numbers);
    if (!placement::isDoorOf(box, room))
      table.refuse(kKey, node,
                   fmt::format("[{}] must cross one upright face of the room's box by {} m or more on each side, or, "
                               "without such, its top or bottom",
                               fmt::join(numbers, ", "), placement::kLeastDoor_m));
    doors.push_back({room, box});
  }
}

void readRooms(const std::string& file, TomlTable& top, placement::PlacementSettings& settings) {
  std::vector<geometry::Box>& rooms = settings.room;
  const toml::node* node = top.node("room");
  if (node == nullptr) return;
  if (!node->is_array_of_tables()) top.refuse("room", node, "must be tables, [[room]]");
  const base::Range& range = base::parameterOf(level::levelDomain(), "[room]", "box").range;
  for (const toml::node& entry : *node->as_array()) {
    TomlTable room(file, entry.as_table(), fmt::format("room[{}].", rooms.size()));
    rooms.push_back(boxOf(room, "box", room.node("box"), room.list("box", 6, range, kBox)));
    readDoors(room, rooms.back(), settings.door);
    room.finish();
  }
}

LocalLights readLocalLights(TomlTable& table) {
  using Where = LocalLights::Where;
  constexpr const char* kKey = "local_lights";
  constexpr const char* kMust = "must be \"auto\", true, false, or a list of sectors, [\"X_Z\", ...]";
  const toml::node* node = table.node(kKey);
  if (node == nullptr || node->value<std::string>() == "auto") return {};
  if (node->is_boolean()) return {*node->value<bool>() ? Where::everywhere : Where::nowhere, {}};
  if (!node->is_array()) table.refuse(kKey, node, kMust);
  LocalLights lights{Where::listed, {}};
  for (const toml::node& entry : *node->as_array()) {
    const auto name = entry.value<std::string>();
    const auto sector = name ? geometry::sectorOf(*name) : std::nullopt;
    if (!sector)
      table.refuse(kKey, &entry,
                   fmt::format("is no sector, \"X_Z\" with X and Z from -{0} to {0}", geometry::kFarthestSector));
    lights.sector.push_back(*sector);
  }
  std::sort(lights.sector.begin(), lights.sector.end());
  if (std::adjacent_find(lights.sector.begin(), lights.sector.end()) != lights.sector.end())
    table.refuse(kKey, node, "names a sector twice");
  return lights;
}

TransferSection readTransfer(Section section) {
  TransferSection transfer;
  const bool is_auto = section.table().has("rays") && !section.isFixed("rays");
  transfer.rays = is_auto ? std::nullopt : std::optional(section.wholeNumber("rays"));
  if (transfer.rays && *transfer.rays % 8 != 0)
    section.table().refuse("rays", section.table().node("rays"), "must be a multiple of 8");
  transfer.bounces = section.wholeNumber("bounces");
  const std::string sun = section.word("sun");
  for (const transfer::SunTransfer known :
       {transfer::SunTransfer::none, transfer::SunTransfer::sh, transfer::SunTransfer::directional})
    if (sun == nameOf(known)) transfer.sun = known;
  transfer.local_lights = readLocalLights(section.table());
  transfer.reach_m = section.number("reach_m");
  transfer.fit = section.word("fit") == "none" ? Fit::none : Fit::surfaces;
  section.table().finish();
  return transfer;
}

std::string boxesText(const std::vector<geometry::Box>& boxes) {
  std::vector<std::string> texts;
  for (const geometry::Box& b : boxes)
    texts.push_back(fmt::format("[{}, {}, {}, {}, {}, {}]", b.low.x, b.low.y, b.low.z, b.high.x, b.high.y, b.high.z));
  return fmt::format("[{}]", fmt::join(texts, ", "));
}

/// The settings' part for doors, which is empty without them.
std::string doorsText(const std::vector<placement::RoomDoor>& doors) {
  std::vector<geometry::Box> room, box;
  for (const placement::RoomDoor& d : doors) {
    room.push_back(d.room);
    box.push_back(d.box);
  }
  if (doors.empty()) return "";
  return fmt::format(R"(, "doors": {}, "rooms_of_doors": {})", boxesText(box), boxesText(room));
}

std::string lightsText(const LocalLights& lights) {
  std::vector<std::string> names;
  switch (lights.where) {
    case LocalLights::Where::near_lights:
      return "\"auto\"";
    case LocalLights::Where::everywhere:
      return "true";
    case LocalLights::Where::nowhere:
      return "false";
    case LocalLights::Where::listed:
      for (const geometry::SectorId sector : lights.sector) names.push_back(fmt::format("\"{}\"", nameOf(sector)));
      break;
  }
  return fmt::format("[{}]", fmt::join(names, ", "));
}

}  // namespace

const char* nameOf(transfer::SunTransfer sun) {
  switch (sun) {
    case transfer::SunTransfer::none:
      return "none";
    case transfer::SunTransfer::sh:
      return "sh";
    case transfer::SunTransfer::directional:
      break;
  }
  return "directional";
}

BakeSection bakeSectionOf(const base::TomlFile& toml) {
  const std::string name = toml.path.string();
  TomlTable top(name, &toml.root, "");
  BakeSection section;
  section.probes = readProbes(Section(top, "probes", level::levelDomain()));
  readRooms(name, top, section.probes);
  section.transfer = readTransfer(Section(top, "transfer", level::levelDomain()));
  Section scale(top, "scale", level::levelDomain());
  section.scale.sun_bounce = scale.number("sun_bounce");
  section.scale.sky = scale.number("sky");
  scale.table().finish();
  Section bake(top, "bake", level::levelDomain());
  if (bake.table().has("max_surface_error")) section.max_surface_error = bake.number("max_surface_error", std::nullopt);
  bake.table().finish();
  return section;
}

std::string settingsText(const BakeSection& section) {
  const placement::PlacementSettings& p = section.probes;
  const TransferSection& t = section.transfer;
  std::vector<std::string> points;
  for (const Number3& a : p.add) points.push_back(fmt::format("[{}, {}, {}]", a.x, a.y, a.z));
  const std::string probes = fmt::format(
      R"({{"spacing_m": {}, "vegetation_spacing_m": {}, "minimum_separation_m": {}, "height_m": {}, "headroom_m": {}, "clearance_m": {}, "coverage_m": {}, "walls": "{}", "add": [{}], "remove": {}{}}})",
      p.spacing_m, p.vegetation_spacing_m, p.minimum_separation_m, p.height_m, p.headroom_m, p.clearance_m,
      p.coverage_m, p.walls == placement::Walls::cut ? "cut" : "ignore", fmt::join(points, ", "), boxesText(p.remove),
      p.within.empty() ? "" : ", \"within\": " + boxesText(p.within));
  const std::string transfer =
      fmt::format(R"({{"rays": {}, "bounces": {}, "sun": "{}", "local_lights": {}, "reach_m": {}, "fit": "{}"}})",
                  t.rays ? fmt::format("{}", *t.rays) : "\"auto\"", t.bounces, nameOf(t.sun),
                  lightsText(t.local_lights), t.reach_m, t.fit == Fit::none ? "none" : "surfaces");
  const std::string budget = section.max_surface_error
                                 ? fmt::format(R"(, "bake": {{"max_surface_error": {}}})", *section.max_surface_error)
                                 : "";
  return fmt::format(R"({{"probes": {}, "room": {}{}, "transfer": {}{}}})", probes, boxesText(p.room),
                     doorsText(p.door), transfer, budget);
}

}  // namespace welkin::build
