// SPDX-License-Identifier: Apache-2.0
// welkin plan: what a bake would do, without doing it.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "sky/sky_file.h"
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

struct Options {
  std::string file, progress = "auto";
  bool json = false;
  BudgetOption budget;
};

void plan(const Options& options) {
  catchInterrupts();
  Subject subject = readSubject(options.file);
  sky::SkyFile& file = subject.sky;
  options.budget.applyTo(file.bake);
  const auto style = options.json ? ProgressReport::Style::none : ProgressReport::styleOf(options.progress);
  const SkyPlan plan = SkyPlanner(file, style).plan(file.bake.max_error.value_or(0.0));
  const std::size_t star_bytes = file.sky.stars ? file.sky.stars->rgba.size() : 0;
  const std::size_t bytes = plan.table_bytes + plan.gradient_bytes + star_bytes + plan.cubemap_bytes;
  nlohmann::ordered_json inputs = nlohmann::json::array();
  for (const auto& input : file.inputs) inputs.push_back(input.name);
  const nlohmann::ordered_json json = {{"inputs", inputs},
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
}

}  // namespace

void addPlan(CLI::App& app) {
  auto options = std::make_shared<Options>();
  auto* command = app.add_subcommand("plan", "Say what a bake would make, and how large");
  command->add_option("FILE", options->file, "sky.toml, or level.toml: its sky, with what the level requires")
      ->required();
  command->add_flag("--json", options->json, "Print JSON");
  command->add_option("--progress", options->progress, "auto, bar, plain, json or none")
      ->check(CLI::IsMember({"auto", "bar", "plain", "json", "none"}))
      ->capture_default_str();
  options->budget.addTo(*command);
  command->callback([options] { plan(*options); });
}

}  // namespace welkin::tools
