// SPDX-License-Identifier: Apache-2.0
// welkin plan: describes a bake without running it.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "command/budget_option.h"
#include "command/certificate_text.h"
#include "command/commands.h"
#include "command/shared_options.h"
#include "picture/probe_picture.h"
#include "probes/build/plan_file.h"
#include "sky/base/atomic_file.h"
#include "sky/base/error.h"

namespace welkin::command {
namespace {

/// Text with the time and the elevation at which a light is highest. It says so if the light never rises.
std::string highestText(const model::LightPath& path) {
  const auto top = model::culminationOf(path);
  return fmt::format("{}highest at {:.2f} h, {:.2f} degrees", top.elevation_rad < 0.0 ? "never rises: " : "",
                     top.time_h, top.elevation_rad / det::kDegree);
}

/// The rays that a bake traces at most, or why they are not known before.
std::string raysText(const nlohmann::ordered_json& sectors) {
  std::uint64_t rays = 0;
  for (const auto& s : sectors) {
    if (s["most_rays"].is_null()) return "as many rays as the budget needs";
    rays += s["most_rays"].get<std::uint64_t>();
  }
  return fmt::format("at most {} rays", rays);
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
  fmt::print("sectors    {}, {} to bake; {} probes, about {} bytes; {}\n", sectors.size(), stale, probes, bytes,
             raysText(sectors));
}

/// Draws placement and grid from above, and in a section through the middle of the sector with the most probes.
void drawPictures(const std::optional<build::LevelBake>& level, const std::filesystem::path& folder,
                  const base::Progress& progress) {
  if (!level) throw base::Error(base::ExitStatus::usage, "--pictures: needs a level.toml: a sky has no probes");
  std::vector<geometry::PlacedSector> placed;
  for (const geometry::SectorId sector : level->sectors()) {
    progress.check();
    placed.push_back(level->place(sector, progress));
  }
  const auto most = std::max_element(placed.begin(), placed.end(),
                                     [](const auto& a, const auto& b) { return a.probe.size() < b.probe.size(); });
  const geometry::Tracer tracer(level->surfaces());
  base::makeFolder(folder);
  base::writeFile(folder / "placement.png", picture::drawFromAbove(tracer, placed));
  if (most != placed.end())
    base::writeFile(folder / "section.png",
                    picture::drawSection(tracer, placed, geometry::kSector_m * (most->id.z + 0.5)));
}

struct Options {
  std::vector<std::string> files;
  std::string folder, pictures;
  ProgressOption progress;
  CertifyOption certify;
  bool json = false;
  BudgetOption budget;
  SurfaceBudgetOption surface_budget;
  CubemapsOption cubemaps;
  TargetOption target;
};

/// `compares`: the plan has a folder, and says what of it is out of date.
void printSky(const nlohmann::ordered_json& plan, const bake::SkyFile& file, bool compares) {
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
  fmt::print("cubemaps   {} of 6 x {} x {} {}: {} bytes, and as EXR cube and latlong{}\n", number(cubemaps["count"]),
             number(cubemaps["size"]), number(cubemaps["size"]), text(cubemaps["format"]), number(cubemaps["bytes"]),
             cubemaps.contains("predicted_error")
                 ? fmt::format("; error {:.3g} %", 100.0 * cubemaps["predicted_error"].get<double>())
                 : "");
  fmt::print("stars      {} bytes\n", number(plan["stars"]["bytes"]));
  fmt::print("sun        {}\n", highestText(file.sky.sun.path));
  fmt::print("moon       {}\n", file.sky.moon ? highestText(file.sky.moon->path) : "none");
  for (const auto& l : plan["left_out"])
    fmt::print("left out   {}: {}{}\n", text(l["what"]), text(l["why"]),
               number(l["bytes"]) > 0 ? fmt::format("; saves {} bytes", number(l["bytes"])) : "");
  fmt::print("{}.welkin about {} bytes{}\n", file.name, number(plan["bytes"]),
             compares ? "  " + text(plan["sky"]["why"]) : "");
}

void plan(const Options& options) {
  catchInterrupts();
  build::BakeRequest request;
  request.file = options.files.front();
  request.more.assign(options.files.begin() + 1, options.files.end());
  request.folder = options.folder;
  request.max_error = options.budget.value();
  request.max_surface_error = options.surface_budget.value();
  request.cubemap_error = options.cubemaps.value();
  request.target = options.target.name;
  request.certify = options.certify.value();
  ProgressReport shown(options.json ? ProgressReport::Style::none : options.progress.style());
  const base::Progress progress = shown.progress();
  const build::BakeInput read = build::readInput(request, progress);
  const nlohmann::ordered_json json = build::planFile(request, read, progress);
  if (!options.pictures.empty()) drawPictures(read.level, options.pictures, progress);
  printWarnings(json["warnings"]);
  if (options.json) {
    fmt::print("{}", build::reportText(json));
    return;
  }
  for (const bake::SkyFile& sky : build::skiesOf(read))
    printSky(json.contains("skies") ? json["skies"][sky.name] : json, sky, !options.folder.empty());
  if (read.level) printSectors(json["sectors"]);
}

}  // namespace

void addPlan(CLI::App& app) {
  auto options = std::make_shared<Options>();
  auto* command = app.add_subcommand("plan", "Say what a bake would make, and how large");
  command
      ->add_option("FILE", options->files,
                   "sky.toml, or level.toml: its sky, with what the level requires, and its sectors; or several sky "
                   "files, a family")
      ->required();
  command->add_option("-o", options->folder, "The folder of a bake: what of it is out of date, and why");
  command->add_option("--pictures", options->pictures,
                      "A folder for placement.png, a level's probes and grid from above, and section.png");
  command->add_flag("--json", options->json, "Print JSON");
  options->progress.addTo(*command);
  options->budget.addTo(*command);
  options->surface_budget.addTo(*command);
  options->cubemaps.addTo(*command);
  options->target.addTo(*command);
  options->certify.addTo(*command);
  command->callback([options] { plan(*options); });
}

}  // namespace welkin::command
