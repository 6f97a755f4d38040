// SPDX-License-Identifier: Apache-2.0
#include "probes/build/plan_file.h"

#include "probes/build/sector_warnings.h"
#include "probes/geometry/sector_name.h"
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
  }
  return sectors;
}

/// What a bake into the folder would do with the sky. One that is up to date is not planned: its record has its plan.
Json skyJson(const BakeRequest& request, const BakeInput& read, const base::Progress& progress) {
  const bake::SkyFile& file = read.sky;
  Json inputs = Json::array();
  for (const auto& input : read.inputs) inputs.push_back(input.name);
  Json json = {{"inputs", inputs}};
  const bake::SkyState state = bake::skyState(request.folder, file, request.certify);
  const bool fresh = state.stale.empty();
  const Json plan = fresh ? state.made
                          : bake::planJson(bake::SkyPlanner(file, progress).plan(file.bake.max_error.value_or(0.0)),
                                           file.bake.max_error);
  for (const char* part : {"table", "gradients", "cubemaps", "left_out"}) json[part] = plan[part];
  const std::size_t star_bytes = file.sky.stars ? file.sky.stars->rgba.size() : 0;
  json["stars"] = {{"bytes", star_bytes}};
  json["moon"] = file.sky.moon.has_value();
  json["sun_path"] = highestJson(file.sky.sun.path);
  json["moon_path"] = file.sky.moon ? highestJson(file.sky.moon->path) : nullptr;
  std::size_t bytes = star_bytes;
  for (const char* part : {"table", "gradients", "cubemaps"}) bytes += plan[part]["bytes"].get<std::size_t>();
  json["bytes"] = bytes;
  json["sky"] = {{"bake", !fresh}, {"why", fresh ? "up to date" : state.stale}};
  json["warnings"] = bake::warningsJson(file.warnings);
  json["warnings"].insert(json["warnings"].end(), plan["warnings"].begin(), plan["warnings"].end());
  return json;
}

}  // namespace

Json planFile(const BakeRequest& request, const BakeInput& read, const base::Progress& progress) {
  Json json = skyJson(request, read, progress);
  if (!read.level) return json;
  addWarnings(*read.level, json["warnings"]);
  json["sectors"] = sectorsJson(*read.level, request.folder, progress);
  std::size_t probes = 0;
  for (const Json& sector : json["sectors"]) probes += sector["probes"].get<std::size_t>();
  addProbelessWarning(json["sectors"].size(), probes, json["warnings"]);
  return json;
}

}  // namespace welkin::build
