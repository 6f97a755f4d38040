// SPDX-License-Identifier: Apache-2.0
// welkin plan: what a bake would do, without doing it.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "picture/probe_picture.h"
#include "probes/sector_name.h"
#include "sky/atomic_file.h"
#include "sky/error.h"
#include "welkin/bake_level.h"
#include "welkin/budget_option.h"
#include "welkin/commands.h"
#include "welkin/sky_plan.h"
#include "welkin/subject.h"
#include "welkin/warnings.h"

namespace welkin::tools {
namespace {

constexpr double kDegree = 3.14159265358979323846 / 180.0;

nlohmann::ordered_json highestJson(const sky::LightPath& path) {
  const auto top = sky::culminationOf(path);
  return {{"highest_deg", top.elevation_rad / kDegree}, {"highest_time_h", top.time_h}};
}

/// Where a light stands highest, and whether that is above the horizon.
std::string highestText(const sky::LightPath& path) {
  const auto top = sky::culminationOf(path);
  return fmt::format("{}highest at {:.2f} h, {:.2f} degrees", top.elevation_rad < 0.0 ? "never rises: " : "",
                     top.time_h, top.elevation_rad / kDegree);
}

/// Bytes of a sector's local transfer, at most: it may have as many virtual lights as nine sectors like it have probes.
std::size_t localBytes(std::size_t count) {
  const std::size_t lights = 9 * count;
  const std::size_t most = 12 * lights + count * (1 + 28 * std::min(lights, probes::kMostLocalLights));
  return std::min(most, probes::kMostLocalBytes);
}

/// About the bytes of a sector's file.
std::size_t sectorBytes(const probes::SectorPlan& plan) {
  constexpr std::size_t kProbeBytes = 152;
  constexpr std::size_t kOtherBytes = 4096 + 1300;  // the grid, the modes, header and structure
  return kOtherBytes + kProbeBytes * plan.probes + (plan.has_local ? localBytes(plan.probes) : 0);
}

/// What a bake into `folder` (none: a new one) would do with every sector. Bytes of one that is out of date are about
/// those that it will have.
nlohmann::ordered_json sectorsJson(const LevelInput& level, const std::string& folder) {
  auto sectors = nlohmann::ordered_json::array();
  for (const probes::SectorId sector : level.bake.sectors()) {
    if (interrupted()) throw Error(ExitStatus::interrupted, "interrupted");
    const probes::SectorState state = level.bake.state(folder, sector);
    const bool fresh = state.stale.empty();
    const probes::SectorPlan plan = fresh
                                        ? probes::SectorPlan{state.file->probes.probes(), state.file->local.has_value()}
                                        : level.bake.plan(sector);
    sectors.push_back({{"sector", probes::nameOf(sector)},
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
  if (!level) throw Error(ExitStatus::usage, "--pictures: needs a level.toml: a sky has no probes");
  std::vector<probes::PlacedSector> placed;
  for (const probes::SectorId sector : level->bake.sectors()) {
    if (interrupted()) throw Error(ExitStatus::interrupted, "interrupted");
    placed.push_back(level->bake.place(sector));
  }
  const auto most = std::max_element(placed.begin(), placed.end(),
                                     [](const auto& a, const auto& b) { return a.probe.size() < b.probe.size(); });
  const probes::Tracer tracer(level->bake.surfaces());
  makeFolder(folder);
  writeFile(folder / "placement.png", picture::drawFromAbove(tracer, placed));
  if (most != placed.end())
    writeFile(folder / "section.png", picture::drawSection(tracer, placed, probes::kSector_m * (most->id.z + 0.5)));
}

struct Options {
  std::string file, folder, pictures, progress = "auto";
  bool json = false;
  BudgetOption budget;
};

void plan(const Options& options) {
  catchInterrupts();
  Subject subject = readSubject(options.file);
  sky::SkyFile& file = subject.sky;
  options.budget.applyTo(file.bake);
  std::optional<LevelInput> level;
  if (subject.level) level.emplace(readLevel(*subject.level, file.sky, file.bake.max_error));
  const auto style = options.json ? ProgressReport::Style::none : ProgressReport::styleOf(options.progress);
  const SkyPlan plan = SkyPlanner(file, style).plan(file.bake.max_error.value_or(0.0));
  const std::size_t star_bytes = file.sky.stars ? file.sky.stars->rgba.size() : 0;
  const std::size_t bytes = plan.table_bytes + plan.gradient_bytes + star_bytes + plan.cubemap_bytes;
  nlohmann::ordered_json inputs = nlohmann::json::array();
  for (const auto& input : file.inputs) inputs.push_back(input.name);
  nlohmann::ordered_json json = {{"inputs", inputs},
                                 {"table", planJson(plan, file.bake.max_error)},
                                 {"gradients",
                                  {{"format", sky::nameOf(plan.gradient_format)},
                                   {"bytes", plan.gradient_bytes},
                                   {"dome_error", plan.dome_error}}},
                                 {"stars", {{"bytes", star_bytes}}},
                                 {"cubemaps",
                                  {{"count", plan.cubemap_time_h.size()},
                                   {"size", plan.cubemap_size},
                                   {"format", format::nameOf(plan.cubemap_format)},
                                   {"bytes", plan.cubemap_bytes}}},
                                 {"moon", file.sky.moon.has_value()},
                                 {"sun_path", highestJson(file.sky.sun.path)},
                                 {"moon_path", file.sky.moon ? highestJson(file.sky.moon->path) : nullptr},
                                 {"left_out", leftOutJson(plan)},
                                 {"bytes", bytes},
                                 {"warnings", warningsJson(file)}};
  if (level) json["sectors"] = sectorsJson(*level, options.folder);
  if (!options.pictures.empty()) drawPictures(level, options.pictures);
  printWarnings(json["warnings"]);
  if (options.json) {
    fmt::print("{}\n", json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
    return;
  }
  if (file.bake.max_error)
    fmt::print("error      {:.3g} % of {:.3g} % for irradiance, at the instants that the plan looks at\n",
               100.0 * plan.predicted_error, 100.0 * *file.bake.max_error);
  fmt::print("table      {} keys x {}, {} channels, {}: {} bytes\n", plan.table.key_time_h.size(),
             plan.representation.name(), plan.table.channels, sky::nameOf(plan.encoding), plan.table_bytes);
  fmt::print("quadrature {}\n", textOf(plan.quadrature));
  fmt::print("gradients  {} x {} and {} x {} {}: {} bytes\n", file.sky.gradient_sun.width, file.sky.gradient_sun.height,
             file.sky.gradient_anti.width, file.sky.gradient_anti.height, sky::nameOf(plan.gradient_format),
             plan.gradient_bytes);
  fmt::print("cubemaps   {} of 6 x {} x {} {}: {} bytes, and as EXR cube and latlong\n", plan.cubemap_time_h.size(),
             plan.cubemap_size, plan.cubemap_size, format::nameOf(plan.cubemap_format), plan.cubemap_bytes);
  fmt::print("stars      {} bytes\n", star_bytes);
  fmt::print("sun        {}\n", highestText(file.sky.sun.path));
  fmt::print("moon       {}\n", file.sky.moon ? highestText(file.sky.moon->path) : "none");
  for (const LeftOut& l : plan.left_out)
    fmt::print("left out   {}: {}{}\n", l.what, l.why, l.bytes > 0 ? fmt::format("; saves {} bytes", l.bytes) : "");
  fmt::print("sky.welkin about {} bytes\n", bytes);
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
  command->add_option("-o", options->folder, "The folder of a bake: which of its sectors are out of date, and why");
  command->add_option("--pictures", options->pictures,
                      "A folder for placement.png, a level's probes and grid from above, and section.png");
  command->add_flag("--json", options->json, "Print JSON");
  command->add_option("--progress", options->progress, "auto, bar, plain, json or none")
      ->check(CLI::IsMember({"auto", "bar", "plain", "json", "none"}))
      ->capture_default_str();
  options->budget.addTo(*command);
  command->callback([options] { plan(*options); });
}

}  // namespace welkin::tools
