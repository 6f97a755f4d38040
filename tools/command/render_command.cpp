// SPDX-License-Identifier: Apache-2.0
// welkin render: pictures of a baked sky by the runtime's own Vulkan passes.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "command/arguments.h"
#include "command/commands.h"
#include "command/render_options.h"
#include "probes/loader/read_scene.h"
#include "probes/loader/surfaces_of.h"
#include "render/level_probes.h"
#include "render/level_view.h"
#include "render/picture.h"
#include "render/views.h"
#include "shared.h"
#include "sky/base/error.h"

namespace welkin::command {
namespace {

Sky openSky(const std::string& path) {
  const std::string file = skyFileOf(path);
  Sky sky;
  const Status status = sky.open(file);
  require(status.code, file, status.message.c_str());
  return sky;
}

/// Mean radiance over the upper hemisphere, cosine-weighted, at the brightest of the day's quarter hours: E(up) / pi.
double brightestLuminance(const Sky& sky) {
  double brightest = 0.0;
  for (int quarter = 0; quarter < 96; ++quarter) {
    WelkinSkySample sample;
    const float up[3] = {0.0F, 1.0F, 0.0F};
    float e[3];
    if (!sky.sample(quarter / 4.0, sample) || welkin_sample_irradiance(&sample, up, e) != WELKIN_OK) continue;
    brightest = std::max(brightest, f64::luminanceOf({double{e[0]}, double{e[1]}, double{e[2]}}) / f64::kPi);
  }
  return brightest;
}

/// The pictures of one instant, in the order of the sheet's rows.
std::vector<render::FloatImage> drawInstant(render::Views& views, const RenderOptions& options, View view, bool sheet) {
  constexpr double kRadians = f64::kPi / 180.0;
  render::Camera camera = render::towardsLight(views.sample());
  if (options.yaw_deg) camera.yaw_rad = *options.yaw_deg * kRadians;
  camera.pitch_rad = options.pitch_deg.value_or(18.0) * kRadians;
  camera.fov_rad = options.fov_deg * kRadians;
  render::Camera from_the_side =
      camera;  // the light comes from behind and the left, so that the spheres show their round
  if (!options.yaw_deg) from_the_side.yaw_rad += 120.0 * kRadians;
  const Size wide = parseSize(options, sheet ? Size{320, 180} : Size{768, 432});
  const Size dome = sheet ? Size{wide.width, wide.width} : parseSize(options, {512, 512});
  std::vector<render::FloatImage> images;
  if (view == View::dome || view == View::sheet) images.push_back(views.dome(dome.width, dome.height, true));
  if (view == View::horizon || view == View::sheet)
    images.push_back(views.perspective(wide.width, wide.height, camera, true));
  if (view == View::spheres || view == View::sheet)
    images.push_back(views.spheres(wide.width, wide.height, from_the_side, parseSkyLight(options)));
  return images;
}

/// Calls `draw` for every hour asked for, exposes what it returns, and lays several hours side by side.
render::Picture drawTimes(const Sky& sky, const RenderOptions& options, bool sheet, uint32_t samples,
                          const std::function<std::vector<render::FloatImage>(double time_h)>& draw) {
  const std::optional<double> stops = parseExposure(options.exposure);
  const double day = brightestLuminance(sky);
  std::vector<render::SheetColumn> columns;
  for (const std::string& time : options.times) {
    const double time_h = parseTime(time);
    const std::vector<render::FloatImage> images = draw(time_h);
    const double exposure =
        stops ? std::exp2(*stops) : render::automaticExposure(render::logAverageLuminance(images), day);
    render::SheetColumn column{render::clockLabel(time_h - 24.0 * std::floor(time_h / 24.0)), {}};
    for (const render::FloatImage& image : images) column.pictures.push_back(render::tonemap(image, exposure, samples));
    columns.push_back(std::move(column));
  }
  return sheet ? render::contactSheet(columns) : std::move(columns.front().pictures.front());
}

render::Picture drawSky(render::VulkanDevice& device, const Sky& sky, const RenderOptions& options) {
  const View view = parseView(options);
  const bool sheet = options.times.size() > 1 || view == View::sheet;
  render::Views views(device, sky, parseSource(options));
  return drawTimes(sky, options, sheet, 1, [&](double time_h) {
    views.setTime(time_h, !options.no_tint);
    return drawInstant(views, options, view, sheet);
  });
}

render::Picture drawLevel(render::VulkanDevice& device, const Sky& sky, const level::Scene& scene,
                          const render::LevelProbes* probes, const RenderOptions& options) {
  constexpr double kRadians = f64::kPi / 180.0;
  constexpr uint32_t kSamples = 2;  // along each side of a pixel
  const bool sheet = options.times.size() > 1;
  const Size size = parseSize(options, sheet ? Size{480, 270} : Size{960, 540});
  render::PlacedCamera from = render::overview(scene, options.fov_deg * kRadians);
  if (const auto position = parseCamera(options)) {
    from.position = *position;
    render::lookAtMiddle(scene, from.position, from.camera);
  }
  if (options.yaw_deg) from.camera.yaw_rad = *options.yaw_deg * kRadians;
  if (options.pitch_deg) from.camera.pitch_rad = *options.pitch_deg * kRadians;
  render::LevelView view(device, sky, scene,
                         {.flat_light = parseSkyLight(options) == render::SkyLight::flat,
                          .tint = !options.no_tint,
                          .cubemaps = parseSource(options) == WELKIN_VULKAN_CUBEMAP});
  return drawTimes(sky, options, sheet, kSamples, [&](double time_h) {
    view.setTime(time_h);
    if (probes != nullptr) view.setProbes(probes->at(time_h));
    std::vector<render::FloatImage> images;
    images.push_back(view.draw(kSamples * size.width, kSamples * size.height, from.camera, from.position));
    return images;
  });
}

/// A level as the passes draw it: its textures as their mean colours.
level::Scene sceneOf(const std::string& level) {
  level::Scene scene = loader::readScene(level::readLevelFile(level));
  for (const std::string& warning : scene.warnings) std::fprintf(stderr, "warning: %s\n", warning.c_str());
  loader::useMeanColours(scene);
  return scene;
}

void runRender(const RenderOptions& options) {
  checkOptions(options);
  const Sky sky = openSky(options.sky);
  if (parseSource(options) == WELKIN_VULKAN_CUBEMAP && sky.info().cubemap_count == 0)
    throw base::Error(base::ExitStatus::content,
                      "the sky has no cubemaps; draw it with the analytic sky, or bake with cubemap_size");
  const bool level = parseView(options) == View::level;
  const level::Scene scene = level ? sceneOf(options.level) : level::Scene{};
  std::optional<render::LevelProbes> probes;
  if (!options.probes.empty()) probes.emplace(options.level, options.probes);
  render::VulkanDevice device(options.validate);
  std::fprintf(stderr, "device: %s\n", device.properties().deviceName);
  const render::Picture picture =
      level ? drawLevel(device, sky, scene, probes ? &*probes : nullptr, options) : drawSky(device, sky, options);
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
  command->add_option("sky", options->sky, "A baked sky, or the directory that holds sky.welkin")->required();
  command->add_option("-o,--output", options->output, "The PNG to write")->required();
  command->add_option("--time", options->times, "Hour of the day; several make a contact sheet, a column each")
      ->required()
      ->allow_extra_args(false);
  command->add_option("--view", options->view,
                      "dome: the hemisphere, looking up; horizon; spheres; sheet: all of them; level: the level");
  command->add_option("--size", options->size, "Pixels, WIDTHxHEIGHT; in a sheet those of its horizon pictures");
  command->add_option("--sky", options->source, "analytic: formulas and gradients; cubemap: the baked cubemaps");
  command->add_option("--sky-light", options->sky_light,
                      "Ambient light: flat, sh, or for the spheres both: left and right");
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
