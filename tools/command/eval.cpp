// SPDX-License-Identifier: Apache-2.0
// welkin eval: evaluates the sky model itself, in double, at one time and direction.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "command/arguments.h"
#include "command/commands.h"
#include "sky/bake/sky_file.h"
#include "sky/model/projection.h"

namespace welkin::command {
namespace {

struct Options {
  std::string file, time, direction, quantity = "sky";
  bool json = false;
};

constexpr double kConverged = 1e-9;  // finer than a bake

det::Number3 evaluate(const Options& options) {
  const auto v = parseDirection("--direction", options.direction);
  const det::Number3 direction(v.x, v.y, v.z);
  const double time_h = parseTime(options.time);
  const bake::SkyFile file = bake::readSkyFile(options.file);
  const model::SkyInstant instant(file.sky, time_h);
  if (options.quantity == "luminance") return det::Number3(instant.luminance(direction));
  const model::SkyProjector projector(file.sky.luminance, 1, kConverged);
  const auto ground = instant.groundRadiance(projector.project(instant).horizontal_irradiance);
  if (options.quantity == "sky") return instant.radiance(direction, ground);
  if (options.quantity == "dome") return instant.dome(direction, ground);
  const auto irradiance =
      projector.irradiance(instant, direction) * instant.intensity() + ground * (det::kPi * 0.5 * (1.0 - direction.y));
  return det::desaturate(irradiance, file.sky.ambient_saturation.at(time_h));
}

void eval(const Options& options) {
  const auto value = evaluate(options);
  if (options.json)
    fmt::print("{}\n", nlohmann::ordered_json{{"value", {value.x, value.y, value.z}}}.dump());
  else
    fmt::print("{} {} {}\n", value.x, value.y, value.z);
}

}  // namespace

void addEval(CLI::App& app) {
  auto options = std::make_shared<Options>();
  auto* command = app.add_subcommand("eval", "Evaluate the sky model in double");
  command->add_option("SKY", options->file, "sky.toml")->required();
  command->add_option("--time", options->time, "Hours")->required();
  command->add_option("--direction", options->direction, "X,Y,Z; the normal of an irradiance")->required();
  command
      ->add_option("--quantity", options->quantity,
                   "sky: radiance; dome: with the polarising tint; luminance: relative, without intensity; "
                   "irradiance: of a surface, pi included, desaturated, without sun and moon")
      ->check(CLI::IsMember({"sky", "dome", "luminance", "irradiance"}))
      ->capture_default_str();
  command->add_flag("--json", options->json, "Print JSON");
  command->callback([options] { eval(*options); });
}

}  // namespace welkin::command
