// SPDX-License-Identifier: Apache-2.0
// welkin plan: what a bake would do, without doing it.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "sky/sky_file.h"
#include "welkin/commands.h"
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

void plan(const std::string& path, bool as_json) {
  const sky::SkyFile file = sky::readSkyFile(path);
  const auto& bake = file.bake;
  const auto coefficients = static_cast<std::size_t>(bake.bands * bake.bands);
  const std::size_t table_bytes = bake.key_time_h.size() * (8 + 12 * coefficients + 12);
  const std::size_t gradient_bytes = 4 * (file.sky.gradient_sun.rgb.size() + file.sky.gradient_anti.rgb.size());
  const auto size = static_cast<std::size_t>(bake.cubemap_size);
  const std::size_t cubemap_bytes =
      bake.cubemap_time_h.size() * 6 * size * size * format::texelBytes(bake.cubemap_format);
  nlohmann::ordered_json inputs = nlohmann::json::array();
  for (const auto& input : file.inputs) inputs.push_back(input.name);
  const nlohmann::ordered_json json = {{"inputs", inputs},
                                       {"table",
                                        {{"bands", bake.bands},
                                         {"coefficients", coefficients},
                                         {"keys", bake.key_time_h.size()},
                                         {"bytes", table_bytes}}},
                                       {"gradients", {{"bytes", gradient_bytes}}},
                                       {"cubemaps",
                                        {{"count", bake.cubemap_time_h.size()},
                                         {"size", bake.cubemap_size},
                                         {"format", format::nameOf(bake.cubemap_format)},
                                         {"bytes", cubemap_bytes}}},
                                       {"moon", file.sky.moon.has_value()},
                                       {"sun_path", highestJson(file.sky.sun.path)},
                                       {"moon_path", file.sky.moon ? highestJson(file.sky.moon->path) : nullptr},
                                       {"bytes", table_bytes + gradient_bytes + cubemap_bytes},
                                       {"warnings", warningsJson(file)}};
  printWarnings(json["warnings"]);
  if (as_json) {
    fmt::print("{}\n", json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
    return;
  }
  fmt::print("table      {} keys x {} bands ({} coefficients, RGB): {} bytes\n", bake.key_time_h.size(), bake.bands,
             coefficients, table_bytes);
  fmt::print("gradients  {} x {} and {} x {}: {} bytes\n", file.sky.gradient_sun.width, file.sky.gradient_sun.height,
             file.sky.gradient_anti.width, file.sky.gradient_anti.height, gradient_bytes);
  fmt::print("cubemaps   {} of 6 x {} x {} {}: {} bytes, and as EXR cube and latlong\n", bake.cubemap_time_h.size(),
             size, size, format::nameOf(bake.cubemap_format), cubemap_bytes);
  fmt::print("sun        {}\n", highestText(file.sky.sun.path));
  fmt::print("moon       {}\n", file.sky.moon ? highestText(file.sky.moon->path) : "none");
  fmt::print("sky.welkin about {} bytes\n", table_bytes + gradient_bytes + cubemap_bytes);
}

}  // namespace

void addPlan(CLI::App& app) {
  auto file = std::make_shared<std::string>();
  auto json = std::make_shared<bool>(false);
  auto* command = app.add_subcommand("plan", "Say what a bake would make, and how large");
  command->add_option("FILE", *file, "sky.toml")->required();
  command->add_flag("--json", *json, "Print JSON");
  command->callback([file, json] { plan(*file, *json); });
}

}  // namespace welkin::tools
