// SPDX-License-Identifier: Apache-2.0
// welkin render: draws pictures of a baked sky with the runtime's own Vulkan passes.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>

#include "command/arguments.h"
#include "command/commands.h"
#include "command/level_folder.h"
#include "command/render_options.h"
#include "command/render_picture.h"
#include "command/welkin_file.h"
#include "probes/loader/read_scene.h"
#include "probes/loader/surfaces_of.h"
#include "sky/base/error.h"
#include "sky/base/message.h"

namespace welkin::command {
namespace {

/// A level as the passes draw it: mean colours replace its textures.
level::Scene sceneOf(const base::TomlFile& level) {
  level::Scene scene = loader::readScene(level::levelFileOf(level));
  for (const std::string& warning : scene.warnings)
    std::fprintf(stderr, "welkin: warning: %s\n", base::oneLine(warning).c_str());
  loader::useMeanColours(scene);
  return scene;
}

void runRender(const RenderOptions& options) {
  checkOptions(options);
  const Sky sky = openSky(skyFileOf(options.sky));
  if (parseSource(options) == WELKIN_VULKAN_CUBEMAP && sky.info().cubemap_count == 0)
    throw base::Error(base::ExitStatus::content,
                      "the sky has no cubemaps; draw it with the analytic sky, or bake with cubemap_size");
  const bool level = parseView(options) == View::level;
  const base::TomlFile file = level ? base::readToml(options.level) : base::TomlFile{};
  const level::Scene scene = level ? sceneOf(file) : level::Scene{};
  std::optional<LevelFolder> baked;
  if (level && parseLevelLight(options) == LevelLight::probes) baked.emplace(options.sky);
  std::optional<render::LevelProbes> probes;
  if (!options.probes.empty()) probes.emplace(file, options.probes);
  render::VulkanDevice device(options.validate);
  std::fprintf(stderr, "device: %s\n", device.properties().deviceName);
  const render::Picture picture = level ? drawLevel(device, sky, scene, baked ? baked->level().get() : nullptr,
                                                    probes ? &*probes : nullptr, options)
                                        : drawSky(device, sky, options);
  if (device.messageCount() > 0)
    throw base::Error(base::ExitStatus::internal,
                      std::to_string(device.messageCount()) + " Vulkan validation messages");
  render::writePng(picture, options.output);
}

}  // namespace

void addRender(CLI::App& app) {
  auto options = std::make_shared<RenderOptions>();
  auto* command =
      app.add_subcommand("render", "Draw a baked sky, or a level under it, with the runtime's own Vulkan passes");
  command->add_option("path", options->sky, "A baked sky, or the folder of a baked sky or level")->required();
  command->add_option("-o,--output", options->output, "The PNG to write")->required();
  command->add_option("--time", options->times, "Hour of the day; several make a contact sheet, a column each")
      ->required()
      ->allow_extra_args(false);
  command->add_option("--view", options->view,
                      "dome: the hemisphere, looking up; horizon; spheres; sheet: all of them; level: the level");
  command->add_option("--size", options->size, "Pixels, WIDTHxHEIGHT; in a sheet those of its horizon pictures");
  command->add_option("--sky", options->source, "analytic: formulas and gradients; cubemap: the baked cubemaps");
  command->add_option(
      "--sky-light", options->sky_light,
      "Ambient light: of a level flat, sh or probes, by default the probes where the folder has them; of the "
      "spheres flat, sh or both: left and right");
  command->add_option("--component", options->component,
                      "The part of a level's light: all, ambient (without sun, moon, lamps and emission), or of the "
                      "probes' light sky, sun-bounce or local");
  command->add_option("--occlusion", options->occlusion,
                      "What darkens a level's ambient light where surfaces are near: screen (default), by what the "
                      "picture shows; none");
  command->add_option("--exposure", options->exposure, "auto, or stops: radiance is multiplied by 2^EV");
  command->add_option("--yaw", options->yaw_deg,
                      "Degrees clockwise from north; default: towards the sun or the moon, for the spheres 120 degrees "
                      "to its right, for a level towards its middle");
  command->add_option("--pitch", options->pitch_deg, "Degrees above the horizon; default: 18, or a level's middle");
  command->add_option("--fov", options->fov_deg, "Vertical field of view, degrees");
  command->add_option("--level", options->level, "The level.toml whose geometry is drawn under the sky");
  command->add_option("--probes", options->probes,
                      "The folder that the level was baked into: the probes of its sectors as white spheres, lit by "
                      "level.toml's sky, its bounced sun and moon, and emission at that hour");
  command->add_option("--camera", options->camera, "X,Y,Z: where to stand in the level, metres");
  command->add_flag("--no-tint", options->no_tint, "Leave the polarising tint out of the sky");
  command->add_flag("--validate", options->validate, "Run with Vulkan's validation layer; any message is an error");
  command->callback([options] { runRender(*options); });
}

}  // namespace welkin::command
