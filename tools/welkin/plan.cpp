// SPDX-License-Identifier: Apache-2.0
// welkin plan: what a bake would do, without doing it.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "sky/sky_file.h"
#include "welkin/commands.h"

namespace welkin::tools {
namespace {

void plan(const std::string& path, bool as_json) {
  const sky::SkyFile file = sky::readSkyFile(path);
  const auto& bake = file.bake;
  const auto coefficients = static_cast<std::size_t>(bake.bands * bake.bands);
  const std::size_t table_bytes = bake.key_time_h.size() * (8 + 12 * coefficients + 12);
  const std::size_t gradient_bytes = 4 * (file.sky.gradient_sun.rgb.size() + file.sky.gradient_anti.rgb.size());
  const auto size = static_cast<std::size_t>(bake.cubemap_size);
  const std::size_t cubemap_bytes = bake.cubemap_time_h.size() * 6 * size * size * 8;
  nlohmann::ordered_json inputs = nlohmann::json::array();
  for (const auto& input : file.inputs) inputs.push_back(input.name);
  const nlohmann::ordered_json json = {
      {"inputs", inputs},
      {"table",
       {{"bands", bake.bands},
        {"coefficients", coefficients},
        {"keys", bake.key_time_h.size()},
        {"bytes", table_bytes}}},
      {"gradients", {{"bytes", gradient_bytes}}},
      {"cubemaps", {{"count", bake.cubemap_time_h.size()}, {"size", bake.cubemap_size}, {"bytes", cubemap_bytes}}},
      {"moon", file.sky.moon.has_value()},
      {"bytes", table_bytes + gradient_bytes + cubemap_bytes}};
  if (as_json) {
    fmt::print("{}\n", json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
    return;
  }
  fmt::print("table      {} keys x {} bands ({} coefficients, RGB): {} bytes\n", bake.key_time_h.size(), bake.bands,
             coefficients, table_bytes);
  fmt::print("gradients  {} x {} and {} x {}: {} bytes\n", file.sky.gradient_sun.width, file.sky.gradient_sun.height,
             file.sky.gradient_anti.width, file.sky.gradient_anti.height, gradient_bytes);
  fmt::print("cubemaps   {} of 6 x {} x {}: {} bytes, and as EXR cube and latlong\n", bake.cubemap_time_h.size(), size,
             size, cubemap_bytes);
  fmt::print("moon       {}\n", file.sky.moon ? "yes" : "none");
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
