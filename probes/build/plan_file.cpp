// SPDX-License-Identifier: Apache-2.0
#include "probes/build/plan_file.h"

#include <algorithm>

#include "probes/build/sector_warnings.h"
#include "probes/geometry/sector_name.h"
#include "sky/bake/bake_family.h"
#include "sky/bake/family.h"
#include "sky/bake/sky_plan_json.h"
#include "sky/bake/sky_record.h"
#include "sky/bake/warnings.h"

namespace welkin::build {
namespace {

using Json = nlohmann::ordered_json;

Json highestJson(const model::LightPath& path) {
  const auto top = model::culminationOf(path);
  return {{"highest_deg", top.elevation_rad / det::kDegree}, {"highest_time_h", top.time_h}};
}

Json sectorsJson(const LevelBake& level, const std::filesystem::path& folder, const base::Progress& progress) {
  Json sectors = Json::array();
  const base::Progress planned = progress.stage("sectors", level.sectors().size());
  for (const geometry::SectorId sector : level.sectors()) {
    progress.check();
    const SectorState state = level.state(folder, sector);
    const bool fresh = state.stale.empty();
    const SectorPlan plan =
        fresh ? SectorPlan{state.file->probes.probes(), state.file->local.has_value(), state.bytes.size(), 0}
              : level.plan(sector, progress);
    sectors.push_back({{"sector", nameOf(sector)},
                       {"bake", !fresh},
                       {"why", fresh ? "up to date" : state.stale},
                       {"probes", plan.probes},
                       {"local", plan.has_local},
                       {"bytes", plan.bytes},
                       {"most_rays", plan.rays ? Json(*plan.rays) : Json()}});
    planned.step();
  }
  return sectors;
}

/// A sky's table, bytes and paths, from its plan as JSON; and whether it is to be baked.
Json skyJson(const bake::SkyFile& file, const Json& plan, const std::string& stale) {
  Json json;
  for (const char* part : {"table", "gradients", "cubemaps", "left_out"}) json[part] = plan[part];
  const std::size_t star_bytes = file.sky.stars ? file.sky.stars->rgba.size() : 0;
  json["stars"] = {{"bytes", star_bytes}};
  json["moon"] = file.sky.moon.has_value();
  json["sun_path"] = highestJson(file.sky.sun.path);
  json["moon_path"] = file.sky.moon ? highestJson(file.sky.moon->path) : nullptr;
  std::size_t bytes = star_bytes;
  for (const char* part : {"table", "gradients", "cubemaps"}) bytes += plan[part]["bytes"].get<std::size_t>();
  json["bytes"] = bytes;
  json["sky"] = {{"bake", !stale.empty()}, {"why", stale.empty() ? "up to date" : stale}};
  json["warnings"] = bake::warningsJson(file.warnings);
  json["warnings"].insert(json["warnings"].end(), plan["warnings"].begin(), plan["warnings"].end());
  return json;
}

/// What a bake into the folder would do with the skies, in their order. Those that are up to date are not
/// planned: their records have their plans.
std::vector<Json> skiesJson(const BakeRequest& request, const std::vector<bake::SkyFile>& skies,
                            const base::Progress& progress) {
  std::vector<bake::SkyState> states;
  bool fresh = true;
  for (const bake::SkyFile& sky : skies) {
    states.push_back(bake::skyState(request.folder, sky, request.certify));
    fresh = fresh && states.back().stale.empty();
  }
  std::vector<Json> list;
  std::vector<bake::SkyPlan> plans;
  if (!fresh) plans = bake::FamilyPlanner(skies, progress).plan(1.0);
  for (std::size_t i = 0; i < skies.size(); ++i) {
    const Json plan = fresh ? states[i].made : bake::planJson(plans[i], skies[i].bake.max_error);
    const std::string with = "another sky of its family";
    list.push_back(skyJson(skies[i], plan, !fresh && states[i].stale.empty() ? with : states[i].stale));
  }
  return list;
}

/// A sky's plan, with those of its family under "skies"; of a family without a level, these alone.
Json familyJson(const BakeRequest& request, const BakeInput& read, const base::Progress& progress) {
  Json json = {{"inputs", Json::array()}};
  for (const auto& input : read.inputs) json["inputs"].push_back(input.name);
  std::vector<bake::SkyFile> files = skiesOf(read);
  std::sort(files.begin(), files.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
  if (files.size() > 1) bake::relate(files);
  std::vector<Json> skies = skiesJson(request, files, progress);
  if (files.size() == 1) {
    json.update(skies.front());
    return json;
  }
  Json warnings = Json::array();
  for (std::size_t i = 0; i < skies.size(); ++i) {
    warnings.insert(warnings.end(), skies[i]["warnings"].begin(), skies[i]["warnings"].end());
    if (read.level && files[i].name == read.sky.name) json.update(skies[i]);
    json["skies"][files[i].name] = std::move(skies[i]);
  }
  json["warnings"] = std::move(warnings);
  return json;
}

}  // namespace

Json planFile(const BakeRequest& request, const BakeInput& read, const base::Progress& progress) {
  Json json = familyJson(request, read, progress);
  if (!read.level) return json;
  addWarnings(*read.level, json["warnings"]);
  json["sectors"] = sectorsJson(*read.level, request.folder, progress);
  std::size_t probes = 0;
  for (const Json& sector : json["sectors"]) probes += sector["probes"].get<std::size_t>();
  addProbelessWarning(json["sectors"].size(), probes, json["warnings"]);
  return json;
}

}  // namespace welkin::build
