// SPDX-License-Identifier: Apache-2.0
// welkin render: pictures of a baked sky by the runtime's own Vulkan passes.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "render/picture.h"
#include "render/views.h"
#include "shared.h"
#include "sky/error.h"
#include "welkin/arguments.h"
#include "welkin/commands.h"

namespace welkin::tools {
namespace {

enum class View { dome, horizon, spheres, sheet };

struct RenderOptions {
  std::string sky;
  std::string output;
  std::vector<std::string> times;
  std::string view;  ///< empty: dome for one time, sheet for several
  std::string size;
  std::string source = "analytic";
  std::string sky_light = "both";
  std::string exposure = "auto";
  std::optional<double> yaw_deg;  ///< else the sun's or the moon's azimuth
  double pitch_deg = 18.0;
  double fov_deg = 60.0;
  bool validate = false;
};

/// The value named by `text`. Throws Error(usage) that lists the names.
template <typename Value, std::size_t N>
Value choose(const char* option, const std::string& text, const std::pair<const char*, Value> (&values)[N]) {
  std::string names;
  for (const auto& [name, value] : values) {
    if (text == name) return value;
    names += (names.empty() ? "" : ", ") + std::string(name);
  }
  throw Error(ExitStatus::usage, fmt::format("{}: '{}' is none of {}", option, text, names));
}

View parseView(const RenderOptions& options) {
  if (options.view.empty()) return options.times.size() > 1 ? View::sheet : View::dome;
  return choose<View>(
      "--view", options.view,
      {{"dome", View::dome}, {"horizon", View::horizon}, {"spheres", View::spheres}, {"sheet", View::sheet}});
}

WelkinVulkanSource parseSource(const RenderOptions& options) {
  return choose<WelkinVulkanSource>("--sky", options.source,
                                    {{"analytic", WELKIN_VULKAN_ANALYTIC}, {"cubemap", WELKIN_VULKAN_CUBEMAP}});
}

SkyLight parseSkyLight(const RenderOptions& options) {
  return choose<SkyLight>("--sky-light", options.sky_light,
                          {{"flat", SkyLight::flat}, {"sh", SkyLight::sh}, {"both", SkyLight::both}});
}

struct Size {
  uint32_t width, height;
};

Size parseSize(const RenderOptions& options, Size fallback) {
  if (options.size.empty()) return fallback;
  Size size{};
  int used = 0;
  const bool parsed = std::sscanf(options.size.c_str(), "%5ux%5u%n", &size.width, &size.height, &used) == 2 &&
                      static_cast<std::size_t>(used) == options.size.size();
  if (!parsed || size.width < 1 || size.height < 1)
    throw Error(ExitStatus::usage, "--size: '" + options.size + "' is not WIDTHxHEIGHT, for example 640x360");
  return size;
}

/// Fixed exposure in stops, or nothing for automatic.
std::optional<double> parseExposure(const std::string& text) {
  if (text == "auto") return std::nullopt;
  char* end = nullptr;
  const double stops = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0' || !std::isfinite(stops) || std::abs(stops) > 60.0)
    throw Error(ExitStatus::usage, "--exposure: '" + text + "' is neither auto nor a number of stops, -60 to 60");
  return stops;
}

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
std::vector<FloatImage> drawInstant(Views& views, const RenderOptions& options, View view, bool sheet) {
  constexpr double kRadians = f64::kPi / 180.0;
  Camera camera = views.towardsLight();
  if (options.yaw_deg) camera.yaw_rad = *options.yaw_deg * kRadians;
  camera.pitch_rad = options.pitch_deg * kRadians;
  camera.fov_rad = options.fov_deg * kRadians;
  Camera from_the_side = camera;  // the light comes from behind and the left, so that the spheres show their round
  if (!options.yaw_deg) from_the_side.yaw_rad += 120.0 * kRadians;
  const Size wide = parseSize(options, sheet ? Size{320, 180} : Size{768, 432});
  const Size dome = sheet ? Size{wide.width, wide.width} : parseSize(options, {512, 512});
  std::vector<FloatImage> images;
  if (view == View::dome || view == View::sheet) images.push_back(views.dome(dome.width, dome.height, true));
  if (view == View::horizon || view == View::sheet)
    images.push_back(views.perspective(wide.width, wide.height, camera, true));
  if (view == View::spheres || view == View::sheet)
    images.push_back(views.spheres(wide.width, wide.height, from_the_side, parseSkyLight(options)));
  return images;
}

Picture drawPicture(Views& views, const Sky& sky, const RenderOptions& options) {
  const std::optional<double> stops = parseExposure(options.exposure);
  const View view = parseView(options);
  const bool sheet = options.times.size() > 1 || view == View::sheet;
  const double day = brightestLuminance(sky);
  std::vector<SheetColumn> columns;
  for (const std::string& time : options.times) {
    views.setTime(parseTime(time));
    const std::vector<FloatImage> images = drawInstant(views, options, view, sheet);
    const double exposure = stops ? std::exp2(*stops) : automaticExposure(logAverageLuminance(images), day);
    SheetColumn column{clockLabel(views.sample().time_h), {}};
    for (const FloatImage& image : images) column.pictures.push_back(tonemap(image, exposure));
    columns.push_back(std::move(column));
  }
  return sheet ? contactSheet(columns) : std::move(columns.front().pictures.front());
}

void runRender(const RenderOptions& options) {
  if (!(options.fov_deg > 0.0 && options.fov_deg < 180.0))
    throw Error(ExitStatus::usage, fmt::format("--fov: {} is not above 0 and below 180 degrees", options.fov_deg));
  if (!(std::abs(options.pitch_deg) <= 90.0))
    throw Error(ExitStatus::usage, fmt::format("--pitch: {} is not -90 to 90 degrees", options.pitch_deg));
  if (options.yaw_deg && !std::isfinite(*options.yaw_deg))
    throw Error(ExitStatus::usage, "--yaw: must be a finite number of degrees");
  for (const std::string& time : options.times) parseTime(time);
  parseView(options);
  parseSource(options);
  parseSkyLight(options);
  parseExposure(options.exposure);
  parseSize(options, {});
  const Sky sky = openSky(options.sky);
  VulkanDevice device(options.validate);
  std::fprintf(stderr, "device: %s\n", device.properties().deviceName);
  Picture picture;
  {
    Views views(device, sky, parseSource(options));
    picture = drawPicture(views, sky, options);
  }
  if (device.messageCount() > 0)
    throw Error(ExitStatus::internal, std::to_string(device.messageCount()) + " Vulkan validation messages");
  writePng(picture, options.output);
}

}  // namespace

void addRender(CLI::App& app) {
  auto options = std::make_shared<RenderOptions>();
  auto* command = app.add_subcommand("render", "Draw a baked sky with the runtime's own Vulkan passes");
  command->add_option("sky", options->sky, "A baked sky, or the directory that holds sky.welkin")->required();
  command->add_option("-o,--output", options->output, "The PNG to write")->required();
  command->add_option("--time", options->times, "Hour of the day; several make a contact sheet, a column each")
      ->required()
      ->allow_extra_args(false);
  command->add_option("--view", options->view,
                      "dome: the hemisphere, looking up; horizon; spheres; sheet: all of them");
  command->add_option("--size", options->size, "Pixels, WIDTHxHEIGHT; in a sheet those of its horizon pictures");
  command->add_option("--sky", options->source, "analytic: formulas and gradients; cubemap: the baked cubemaps");
  command->add_option("--sky-light", options->sky_light, "Light of the spheres: flat, sh, or both: left and right");
  command->add_option("--exposure", options->exposure, "auto, or stops: radiance is multiplied by 2^EV");
  command->add_option("--yaw", options->yaw_deg,
                      "Degrees clockwise from north; default: towards the sun or the moon, and for the spheres 120 "
                      "degrees to its right");
  command->add_option("--pitch", options->pitch_deg, "Degrees above the horizon");
  command->add_option("--fov", options->fov_deg, "Vertical field of view, degrees");
  command->add_flag("--validate", options->validate, "Run with Vulkan's validation layer; any message is an error");
  command->callback([options] { runRender(*options); });
}

}  // namespace welkin::tools
