// SPDX-License-Identifier: Apache-2.0
// welkin plan: what a bake would do, without doing it.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "command/bake_level.h"
#include "command/budget_option.h"
#include "command/commands.h"
#include "command/shared_options.h"
#include "command/sky_plan_json.h"
#include "command/sky_record.h"
#include "command/subject.h"
#include "command/warnings.h"
#include "picture/probe_picture.h"
#include "probes/geometry/sector_name.h"
#include "sky/base/atomic_file.h"
#include "sky/base/error.h"

namespace welkin::command {
namespace {

constexpr double kDegree = 3.14159265358979323846 / 180.0;

nlohmann::ordered_json highestJson(const model::LightPath& path) {
  const auto top = model::culminationOf(path);
  return {{"highest_deg", top.elevation_rad / kDegree}, {"highest_time_h", top.time_h}};
}

/// Where a light stands highest, and whether that is above the horizon.
std::string highestText(const model::LightPath& path) {
  const auto top = model::culminationOf(path);
  return fmt::format("{}highest at {:.2f} h, {:.2f} degrees", top.elevation_rad < 0.0 ? "never rises: " : "",
                     top.time_h, top.elevation_rad / kDegree);
}

/// Bytes of a sector's local transfer, at most: it may have as many virtual lights as nine sectors like it have probes.
std::size_t localBytes(std::size_t count) {
  const std::size_t lights = 9 * count;
  const std::size_t most = transfer::kVirtualLightBytes * lights +
                           count * (1 + transfer::kLocalTransferBytes * std::min(lights, transfer::kMostLocalLights));
  return std::min(most, transfer::kMostLocalBytes);
}

/// About the bytes of a sector's file.
std::size_t sectorBytes(const build::SectorPlan& plan) {
  constexpr std::size_t kProbeBytes = 152;
  constexpr std::size_t kOtherBytes = 4096 + 1300;  // the grid, the modes, header and structure
  return kOtherBytes + kProbeBytes * plan.probes + (plan.has_local ? localBytes(plan.probes) : 0);
}

/// What a bake into `folder` (none: a new one) would do with every sector. Bytes of one that is out of date are about
/// those that it will have.
nlohmann::ordered_json sectorsJson(const LevelInput& level, const std::string& folder) {
  auto sectors = nlohmann::ordered_json::array();
  for (const geometry::SectorId sector : level.bake.sectors()) {
    endIfInterrupted();
    const build::SectorState state = level.bake.state(folder, sector);
    const bool fresh = state.stale.empty();
    const build::SectorPlan plan = fresh ? build::SectorPlan{state.file->probes.probes(), state.file->local.has_value()}
                                         : level.bake.plan(sector, endIfInterrupted);
    sectors.push_back({{"sector", nameOf(sector)},
                       {"bake", !fresh},
                       {"why", fresh ? "up to date" : state.stale},
                       {"probes", plan.probes},
                       {"local", plan.has_local},
                       {"bytes", fresh ? state.bytes.size() : sectorBytes(plan)}});
  }
  return sectors;
}

void printSectors(const nlohmann::ordered_json& sectors) {
  std::size_t stale = 0;
  std::size_t probes = 0;
  std::size_t bytes = 0;
  for (const auto& s : sectors) {
    stale += s["bake"].get<bool>() ? 1 : 0;
    probes += s["probes"].get<std::size_t>();
    bytes += s["bytes"].get<std::size_t>();
    fmt::print("sector     {:>9} {:4} probes {:7} bytes  {}\n", s["sector"].get<std::string>(),
               s["probes"].get<std::size_t>(), s["bytes"].get<std::size_t>(), s["why"].get<std::string>());
  }
  fmt::print("sectors    {}, {} to bake; {} probes, about {} bytes\n", sectors.size(), stale, probes, bytes);
}

/// Placement and grid from above, and in section through the middle of the sector with the most probes.
void drawPictures(const std::optional<LevelInput>& level, const std::filesystem::path& folder) {
  if (!level) throw base::Error(base::ExitStatus::usage, "--pictures: needs a level.toml: a sky has no probes");
  std::vector<geometry::PlacedSector> placed;
  for (const geometry::SectorId sector : level->bake.sectors()) {
    endIfInterrupted();
    placed.push_back(level->bake.place(sector, endIfInterrupted));
  }
  const auto most = std::max_element(placed.begin(), placed.end(),
                                     [](const auto& a, const auto& b) { return a.probe.size() < b.probe.size(); });
  const geometry::Tracer tracer(level->bake.surfaces());
  base::makeFolder(folder);
  base::writeFile(folder / "placement.png", picture::drawFromAbove(tracer, placed));
  if (most != placed.end())
    base::writeFile(folder / "section.png",
                    picture::drawSection(tracer, placed, geometry::kSector_m * (most->id.z + 0.5)));
}

struct Options {
  std::string file, folder, pictures;
  ProgressOption progress;
  CertifyOption certify;
  bool json = false;
  BudgetOption budget;
};

/// What a bake into the folder would do with the sky. One that is up to date is not planned: its record has its plan.
nlohmann::ordered_json skyJson(const Options& options, const Subject& subject) {
  const bake::SkyFile& file = subject.sky;
  auto inputs = nlohmann::ordered_json::array();
  for (const auto& input : subject.inputs()) inputs.push_back(input.name);
  nlohmann::ordered_json json = {{"inputs", inputs}};
  const SkyState state = skyState(options.folder, file, options.certify.value());
  const bool fresh = state.stale.empty();
  const auto style = options.json ? ProgressReport::Style::none : options.progress.style();
  const nlohmann::ordered_json plan =
      fresh ? state.made
            : planJson(SkyPlanner(file, style).plan(file.bake.max_error.value_or(0.0)), file.bake.max_error);
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
  json["warnings"] = warningsJson(file);
  return json;
}

void printSky(const nlohmann::ordered_json& plan, const bake::SkyFile& file) {
  const auto text = [](const nlohmann::ordered_json& value) { return value.get<std::string>(); };
  const auto number = [](const nlohmann::ordered_json& value) { return value.get<std::size_t>(); };
  const auto& table = plan["table"];
  const auto& cubemaps = plan["cubemaps"];
  if (file.bake.max_error)
    fmt::print("error      {:.3g} % of {:.3g} % for irradiance, at the instants that the plan looks at\n",
               100.0 * table["predicted_error"].get<double>(), 100.0 * *file.bake.max_error);
  fmt::print("table      {} keys x {}, {} channels, {}: {} bytes\n", number(table["keys"]), text(table["name"]),
             number(table["channels"]), text(table["encoding"]), number(table["bytes"]));
  fmt::print("quadrature {}\n", text(table["quadrature"]));
  fmt::print("gradients  {} x {} and {} x {} {}: {} bytes\n", file.sky.gradient_sun.width, file.sky.gradient_sun.height,
             file.sky.gradient_anti.width, file.sky.gradient_anti.height, text(plan["gradients"]["format"]),
             number(plan["gradients"]["bytes"]));
  fmt::print("cubemaps   {} of 6 x {} x {} {}: {} bytes, and as EXR cube and latlong\n", number(cubemaps["count"]),
             number(cubemaps["size"]), number(cubemaps["size"]), text(cubemaps["format"]), number(cubemaps["bytes"]));
  fmt::print("stars      {} bytes\n", number(plan["stars"]["bytes"]));
  fmt::print("sun        {}\n", highestText(file.sky.sun.path));
  fmt::print("moon       {}\n", file.sky.moon ? highestText(file.sky.moon->path) : "none");
  for (const auto& l : plan["left_out"])
    fmt::print("left out   {}: {}{}\n", text(l["what"]), text(l["why"]),
               number(l["bytes"]) > 0 ? fmt::format("; saves {} bytes", number(l["bytes"])) : "");
  fmt::print("sky.welkin about {} bytes  {}\n", number(plan["bytes"]), text(plan["sky"]["why"]));
}

void plan(const Options& options) {
  catchInterrupts();
  Subject subject = readSubject(options.file);
  bake::SkyFile& file = subject.sky;
  options.budget.applyTo(file.bake);
  std::optional<LevelInput> level;
  if (subject.level) level.emplace(readLevel(*subject.level, file.sky, file.bake.max_error));
  nlohmann::ordered_json json = skyJson(options, subject);
  if (level) addLevelWarnings(*level, json["warnings"]);
  if (level) json["sectors"] = sectorsJson(*level, options.folder);
  if (!options.pictures.empty()) drawPictures(level, options.pictures);
  printWarnings(json["warnings"]);
  if (options.json) {
    fmt::print("{}\n", json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
    return;
  }
  printSky(json, file);
  if (level) printSectors(json["sectors"]);
}

}  // namespace

void addPlan(CLI::App& app) {
  auto options = std::make_shared<Options>();
  auto* command = app.add_subcommand("plan", "Say what a bake would make, and how large");
  command
      ->add_option("FILE", options->file,
                   "sky.toml, or level.toml: its sky, with what the level requires, and its sectors")
      ->required();
  command->add_option("-o", options->folder, "The folder of a bake: what of it is out of date, and why");
  command->add_option("--pictures", options->pictures,
                      "A folder for placement.png, a level's probes and grid from above, and section.png");
  command->add_flag("--json", options->json, "Print JSON");
  options->progress.addTo(*command);
  options->budget.addTo(*command);
  options->certify.addTo(*command);
  command->callback([options] { plan(*options); });
}

}  // namespace welkin::command
