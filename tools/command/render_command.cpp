// SPDX-License-Identifier: Apache-2.0
// welkin render: draws pictures of a baked sky with the runtime's own Vulkan passes.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>

#include "baked/level_folder.h"
#include "baked/level_source.h"
#include "baked/welkin_file.h"
#include "command/arguments.h"
#include "command/commands.h"
#include "command/level_picture.h"
#include "command/render_options.h"
#include "command/render_picture.h"
#include "probes/build/level_files.h"
#include "probes/contact/contact_file.h"
#include "probes/loader/read_scene.h"
#include "probes/loader/surfaces_of.h"
#include "sky/base/atomic_file.h"
#include "sky/base/error.h"
#include "sky/base/message.h"

namespace welkin::command {
namespace {

/// A level as the passes draw it: mean colours replace its textures, and dynamic lights are among its lamps.
level::Scene sceneOf(const base::TomlFile& level, const std::vector<reference::LocalLight>& lights,
                     double luminance_unit) {
  level::Scene scene = loader::readScene(level::levelFileOf(level));
  for (const std::string& warning : scene.warnings)
    std::fprintf(stderr, "welkin: warning: %s\n", base::oneLine(warning).c_str());
  loader::useMeanColours(scene);
  for (const reference::LocalLight& light : lights) {
    geometry::StaticLight lamp;
    lamp.position = light.position;
    lamp.intensity = light.intensity * luminance_unit;
    scene.lights.push_back(lamp);
  }
  return scene;
}

/// Sets the dynamic lights of a baked level. Its surfaces stand between them and its virtual lights.
void setLights(baked::LevelFolder& baked, const level::Scene& scene, const std::vector<reference::LocalLight>& lights) {
  if (lights.empty()) return;
  const geometry::Surfaces surfaces = loader::surfacesOf(scene, 1.0);
  const geometry::Tracer tracer(surfaces, lights.front().position);
  const auto sees = [&](const f64::Number3& from, const f64::Number3& to) {
    const f64::Number3 way = to - from;
    const double far = std::sqrt(dot(way, way));
    return far == 0.0 || !tracer.occluded(from, way / far, far);
  };
  warnOfUnseen(baked.setLights(lights, sees), lights.size());
}

/// Adds the folder's contact factors. Those that are not of this bake are left out, with a warning, unless they were
/// asked for by name.
void addContact(level::Scene& scene, const RenderOptions& options) {
  const std::filesystem::path folder = options.sky;
  try {
    const bool found = contact::addContact(scene, folder, base::hashOf(base::readFile(build::indexPath(folder))));
    if (!found && !options.occlusion.empty())
      throw base::Error(base::ExitStatus::file, fmt::format("{}: has no contact.json: welkin contact {} makes it",
                                                            folder.string(), folder.string()));
  } catch (const base::Error& e) {
    if (!options.occlusion.empty()) throw;
    std::fprintf(stderr, "welkin: warning: contact factors are left out: %s\n", base::oneLine(e.what()).c_str());
  }
}

/// The folder of a baked level shows the level, whose file need not be given.
RenderOptions withLevel(RenderOptions options) {
  const bool shows_level = options.view.empty() || options.view == "level";
  if (!shows_level || !build::isLevelFolder(options.sky)) return options;
  const baked::LevelSource source = baked::levelSource(options.sky, options.level);
  if (!source.warning.empty()) std::fprintf(stderr, "welkin: warning: %s\n", base::oneLine(source.warning).c_str());
  options.level = source.file.string();
  return options;
}

void runRender(const RenderOptions& given) {
  const RenderOptions options = withLevel(given);
  checkOptions(options);
  const Sky sky = baked::openSky(baked::skyFileOf(options.sky));
  if (parseSource(options) == WELKIN_VULKAN_CUBEMAP && sky.info().cubemap_count == 0)
    throw base::Error(base::ExitStatus::content,
                      "the sky has no cubemaps; draw it with the analytic sky, or bake with cubemap_size");
  const bool level = parseView(options) == View::level;
  const std::vector<reference::LocalLight> lights = options.lights.lights();
  const base::TomlFile file = level ? base::readToml(options.level) : base::TomlFile{};
  level::Scene scene = level ? sceneOf(file, lights, double{sky.info().luminance_unit}) : level::Scene{};
  if (level && parseOcclusion(options, parseLevelLight(options)) == Occlusion::contact) addContact(scene, options);
  std::optional<baked::LevelFolder> baked;
  if (level && parseLevelLight(options) == LevelLight::probes) {
    baked.emplace(options.sky, lights.size());
    setLights(*baked, scene, lights);
  }
  std::optional<render::LevelProbes> probes;
  if (!options.probes.empty()) probes.emplace(file, options.probes);
  render::VulkanDevice device(options.validate);
  std::fprintf(stderr, "device: %s\n", device.properties().deviceName);
  WelkinLevel* const light = baked ? baked->level().get() : nullptr;
  nlohmann::ordered_json numbers;
  const render::Picture picture = !level ? drawSky(device, sky, options)
                                  : parseShown(options) == Shown::drawn
                                      ? drawLevel(device, sky, scene, light, probes ? &*probes : nullptr, options)
                                      : drawTraced(device, sky, scene, light, options, numbers);
  if (device.messageCount() > 0)
    throw base::Error(base::ExitStatus::internal,
                      std::to_string(device.messageCount()) + " Vulkan validation messages");
  render::writePng(picture, options.output);
  if (options.json) fmt::print("{}\n", numbers.dump(2));
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
                      "probes' light sky, sun-bounce or local; occlusion: the share of ambient light that is left, as "
                      "grey, without the sea");
  command->add_option(
      "--occlusion", options->occlusion,
      "What corrects a level's ambient light where surfaces are near: contact, the folder's factors of `welkin "
      "contact`; screen, by what the picture shows; none. Default: contact where probes light the level and the folder "
      "has factors, else none; without probes screen");
  command->add_option("--exposure", options->exposure, "auto, or stops: radiance is multiplied by 2^EV");
  command->add_option("--yaw", options->yaw_deg,
                      "Degrees clockwise from north; default: towards the sun or the moon, for the spheres 120 degrees "
                      "to its right, for a level towards its middle");
  command->add_option("--pitch", options->pitch_deg, "Degrees above the horizon; default: 18, or a level's middle");
  command->add_option("--fov", options->fov_deg, "Vertical field of view, degrees");
  command->add_option(
      "--level", options->level,
      "The level.toml whose geometry is drawn under the sky; default, of the folder of a baked level: the one "
      "that was baked");
  command->add_option("--probes", options->probes,
                      "The folder that the level was baked into: the probes of its sectors as white spheres, lit by "
                      "level.toml's sky, its bounced sun and moon, and emission at that hour");
  command->add_option("--camera", options->camera, "X,Y,Z: where to stand in the level, metres");
  options->lights.addTo(
      *command,
      "The probes of a level with local transfer reflect it. RADIUS is that of its sphere for the path "
      "tracer's bounces");
  command->add_flag("--reference", options->reference,
                    "Light a level's surfaces by the path tracer instead, at the exposure of the same picture without "
                    "this option; sky, sea, glass and mist stay");
  command->add_flag("--difference", options->difference,
                    "Draw in false colours how much brighter the picture's irradiance is than the path tracer's");
  command->add_flag("--compare", options->compare,
                    "Draw flat ambient light, the probes and the path tracer side by side, each with its error");
  command
      ->add_option("--paths", options->paths,
                   "Paths of the path tracer, a pixel; rounded up to 8, 32, 72, 128, 200, ...")
      ->check(CLI::Range(std::size_t{1}, std::size_t{1} << 20))
      ->capture_default_str();
  command->add_flag("--json", options->json, "Print the errors against the path tracer as JSON");
  options->threads.addTo(*command, "Of the path tracer; the picture does not depend on it");
  options->progress.addTo(*command);
  command->add_flag("--no-tint", options->no_tint, "Leave the polarising tint out of the sky");
  command->add_flag("--no-reflections", options->no_reflections,
                    "Draw all of a level's materials but the sea as matt: they reflect neither the sky nor the sun");
  command->add_flag("--validate", options->validate, "Run with Vulkan's validation layer; any message is an error");
  command->callback([options] { runRender(*options); });
}

}  // namespace welkin::command
