// SPDX-License-Identifier: Apache-2.0
#include "sky/bake/family.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "sky/base/error.h"

namespace welkin::bake {
namespace {

using Json = nlohmann::ordered_json;

/// The value of a key as the file has it.
std::string valueOf(const SkyFile& file, const std::string& section, const std::string& key) {
  const Json settings = Json::parse(file.settings);
  const Json value = settings.value(section, Json::object()).value(key, Json());
  constexpr std::size_t kMost = 60;
  if (value.is_null()) return "absent";
  const std::string text = value.dump(-1, ' ', false, Json::error_handler_t::replace);
  return text.size() <= kMost ? text : text.substr(0, kMost) + "...";
}

[[noreturn]] void refuse(const SkyFile& first, const SkyFile& other, const std::string& section, const std::string& key,
                         const std::string& why) {
  throw base::Error(
      base::ExitStatus::content,
      fmt::format("{}: {}.{} is {}, must be as in {}, {}: {}", other.inputs.front().path.string(), section, key,
                  valueOf(other, section, key), first.inputs.front().path.string(), valueOf(first, section, key), why));
}

/// The key by which two paths differ; null if they are equal.
const char* differenceOf(const model::LightPath& a, const model::LightPath& b, bool is_moon) {
  if (a.key_time_h != b.key_time_h || a.key_azimuth_rad != b.key_azimuth_rad ||
      a.key_elevation_rad != b.key_elevation_rad)
    return "path";
  if (a.latitude_rad != b.latitude_rad) return "latitude_deg";
  if (a.declination_rad != b.declination_rad) return is_moon ? "declination_deg" : "day_of_year";
  if (a.transit_h != b.transit_h) return is_moon ? "phase" : "longitude_deg";
  return a.north_offset_rad != b.north_offset_rad ? "north_offset_deg" : nullptr;
}

}  // namespace

void checkFamily(std::span<const SkyFile> family) {
  const SkyFile& first = family.front();
  const BakeSettings& a = first.bake;
  for (const SkyFile& other : family.subspan(1)) {
    if (const char* key = differenceOf(first.sky.sun.path, other.sky.sun.path, false))
      refuse(first, other, "sun", key, "skies of a family share the sun's path");
    if (first.sky.luminance_unit != other.sky.luminance_unit)
      refuse(first, other, "sky", "luminance_unit", "a blend adds their radiances");
    const BakeSettings& b = other.bake;
    constexpr const char* kHeld = "skies of a family hold their light in one form";
    if (a.max_error.has_value() != b.max_error.has_value())
      refuse(first, other, "bake", "max_error", "skies of a family all have a budget, or none");
    if (a.target.sh_bands != b.target.sh_bands) refuse(first, other, "bake", "target", kHeld);
    if (a.fixed.bands != b.fixed.bands || a.bands != b.bands) refuse(first, other, "bake", "bands", kHeld);
    if (a.fixed.reconstruction != b.fixed.reconstruction || a.reconstruction != b.reconstruction)
      refuse(first, other, "bake", "reconstruction", kHeld);
    if (a.mildest_window != b.mildest_window) refuse(first, other, "bake", "window", kHeld);
  }
}

void checkLevelFamily(std::span<const SkyFile> family) {
  const SkyFile& first = family.front();
  for (const SkyFile& other : family.subspan(1)) {
    constexpr const char* kSectors = "the level's sectors are baked for one";
    const auto& moon = first.sky.moon;
    if (moon.has_value() != other.sky.moon.has_value()) refuse(first, other, "moon", "path", kSectors);
    if (moon)
      if (const char* key = differenceOf(moon->path, other.sky.moon->path, true))
        refuse(first, other, "moon", key, kSectors);
    if (!(first.sky.ground_albedo == other.sky.ground_albedo)) refuse(first, other, "sky", "ground_albedo", kSectors);
  }
}

void nameAfterFiles(std::span<SkyFile> family, std::size_t named) {
  for (std::size_t i = 0; i < family.size(); ++i) {
    const std::filesystem::path& path = family[i].inputs.front().path;
    if (i >= named) family[i].name = path.stem().string();
    const std::string& name = family[i].name;
    for (const char* taken : {"level", "report", "timing"})
      if (name == taken)
        throw base::Error(base::ExitStatus::content,
                          fmt::format("{}: would be baked as {}.welkin and {}.json, which are names of other outputs; "
                                      "rename it",
                                      path.string(), name, name));
    for (std::size_t j = 0; j < i; ++j)
      if (family[j].name == name)
        throw base::Error(base::ExitStatus::content,
                          fmt::format("{} and {}: both would be baked as {}.welkin; rename one",
                                      family[j].inputs.front().path.string(), path.string(), name));
  }
}

void relate(std::span<SkyFile> family) {
  std::vector<const SkyFile*> by_name;
  for (const SkyFile& file : family) by_name.push_back(&file);
  std::sort(by_name.begin(), by_name.end(), [](const SkyFile* a, const SkyFile* b) { return a->name < b->name; });
  for (SkyFile& file : family) {
    file.family.clear();
    for (const SkyFile* other : by_name)
      if (other != &file) file.family.insert(file.family.end(), other->inputs.begin(), other->inputs.end());
  }
}

}  // namespace welkin::bake
