// SPDX-License-Identifier: Apache-2.0
// Parses the options of welkin render.
#include "command/render_options.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "command/arguments.h"
#include "probes/build/level_files.h"
#include "sky/base/error.h"
#include "sky/base/message.h"

namespace welkin::command {
namespace {

/// The value whose name is `text`. Throws Error(usage) with a list of the names.
template <typename Value, std::size_t N>
Value choose(const char* option, const std::string& text, const std::pair<const char*, Value> (&values)[N]) {
  std::string names;
  for (const auto& [name, value] : values) {
    if (text == name) return value;
    names += (names.empty() ? "" : ", ") + std::string(name);
  }
  throw base::Error(base::ExitStatus::usage, fmt::format("{}: '{}' is none of {}", option, text, names));
}

}  // namespace

View parseView(const RenderOptions& options) {
  if (options.view.empty() && !options.level.empty()) return View::level;
  if (options.view.empty()) return options.times.size() > 1 ? View::sheet : View::dome;
  return choose<View>("--view", options.view,
                      {{"dome", View::dome},
                       {"horizon", View::horizon},
                       {"spheres", View::spheres},
                       {"sheet", View::sheet},
                       {"level", View::level}});
}

WelkinVulkanSource parseSource(const RenderOptions& options) {
  if (options.source.empty()) return WELKIN_VULKAN_ANALYTIC;
  return choose<WelkinVulkanSource>("--sky", options.source,
                                    {{"analytic", WELKIN_VULKAN_ANALYTIC}, {"cubemap", WELKIN_VULKAN_CUBEMAP}});
}

render::SkyLight parseSkyLight(const RenderOptions& options) {
  if (options.sky_light.empty() || parseView(options) == View::level) return render::SkyLight::both;
  return choose<render::SkyLight>(
      "--sky-light", options.sky_light,
      {{"flat", render::SkyLight::flat}, {"sh", render::SkyLight::sh}, {"both", render::SkyLight::both}});
}

LevelLight parseLevelLight(const RenderOptions& options) {
  if (options.sky_light.empty()) return build::isLevelFolder(options.sky) ? LevelLight::probes : LevelLight::sh;
  return choose<LevelLight>("--sky-light", options.sky_light,
                            {{"flat", LevelLight::flat}, {"sh", LevelLight::sh}, {"probes", LevelLight::probes}});
}

Component parseComponent(const RenderOptions& options) {
  if (options.component.empty()) return Component::all;
  return choose<Component>("--component", options.component,
                           {{"all", Component::all},
                            {"ambient", Component::ambient},
                            {"sky", Component::sky},
                            {"sun-bounce", Component::sun_bounce},
                            {"local", Component::local},
                            {"occlusion", Component::occlusion}});
}

Shown parseShown(const RenderOptions& options) {
  if (int{options.reference} + int{options.difference} + int{options.compare} > 1)
    throw base::Error(base::ExitStatus::usage, "--reference, --difference and --compare: give one of them");
  return options.reference    ? Shown::reference
         : options.difference ? Shown::difference
         : options.compare    ? Shown::compare
                              : Shown::drawn;
}

Occlusion parseOcclusion(const RenderOptions& options, LevelLight light) {
  if (options.occlusion.empty())
    return light == LevelLight::probes && parseComponent(options) != Component::occlusion ? Occlusion::contact
                                                                                          : Occlusion::screen;
  const auto occlusion =
      choose<Occlusion>("--occlusion", options.occlusion,
                        {{"contact", Occlusion::contact}, {"screen", Occlusion::screen}, {"none", Occlusion::none}});
  // Factors are for the probes' light alone.
  return occlusion == Occlusion::contact && light != LevelLight::probes ? Occlusion::screen : occlusion;
}

Size parseSize(const std::string& text, Size fallback) {
  if (text.empty()) return fallback;
  Size size{};
  int used = 0;
  const bool parsed = std::sscanf(text.c_str(), "%5ux%5u%n", &size.width, &size.height, &used) == 2 &&
                      static_cast<std::size_t>(used) == text.size();
  if (!parsed || size.width < 1 || size.height < 1)
    throw base::Error(base::ExitStatus::usage, "--size: '" + text + "' is not WIDTHxHEIGHT, for example 640x360");
  return size;
}

std::optional<double> parseExposure(const std::string& text) {
  if (text == "auto") return std::nullopt;
  char* end = nullptr;
  const double stops = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0' || !std::isfinite(stops) || std::abs(stops) > 60.0)
    throw base::Error(base::ExitStatus::usage,
                      "--exposure: '" + text + "' is neither auto nor a number of stops, -60 to 60");
  return stops;
}

std::optional<f64::Number3> parseCamera(const RenderOptions& options) {
  if (options.camera.empty()) return std::nullopt;
  f64::Number3 p;
  int used = 0;
  const bool parsed = std::sscanf(options.camera.c_str(), "%lf,%lf,%lf%n", &p.x, &p.y, &p.z, &used) == 3 &&
                      static_cast<std::size_t>(used) == options.camera.size();
  constexpr double kFarthest = 1e6;
  if (!parsed || !(std::abs(p.x) <= kFarthest && std::abs(p.y) <= kFarthest && std::abs(p.z) <= kFarthest))
    throw base::Error(base::ExitStatus::usage,
                      "--camera: '" + options.camera + "' is not X,Y,Z in metres, each -1e6 to 1e6");
  return p;
}

void checkOptions(const RenderOptions& options) {
  const auto refuse = [](const std::string& why) { throw base::Error(base::ExitStatus::usage, why); };
  if (std::filesystem::path(options.output).extension() != ".png")
    refuse(
        fmt::format("-o {}: the picture is a PNG; a name that ends in .png is allowed", base::oneLine(options.output)));
  if (!(options.fov_deg > 0.0 && options.fov_deg < 180.0))
    refuse(fmt::format("--fov: {} is not above 0 and below 180 degrees", options.fov_deg));
  if (options.pitch_deg && !(std::abs(*options.pitch_deg) <= 90.0))
    refuse(fmt::format("--pitch: {} is not -90 to 90 degrees", *options.pitch_deg));
  if (options.yaw_deg && !std::isfinite(*options.yaw_deg)) refuse("--yaw: must be a finite number of degrees");
  for (const std::string& time : options.times) parseTime(time);
  const bool level = parseView(options) == View::level;
  const bool cubemap = parseSource(options) == WELKIN_VULKAN_CUBEMAP;
  parseSkyLight(options);
  const Component component = parseComponent(options);
  parseOcclusion(options, LevelLight::flat);
  parseExposure(options.exposure);
  parseSize(options.size, {});
  parseCamera(options);
  if (level && options.level.empty()) refuse("--view level needs --level LEVEL.toml");
  if (!level && !options.level.empty()) refuse("--level: --view " + options.view + " shows no level");
  if (!level && !options.probes.empty()) refuse("--probes: only a level has probes; give --level LEVEL.toml");
  if (!level && !options.camera.empty()) refuse("--camera: only a level has places to stand; give --level LEVEL.toml");
  const bool probes = level && parseLevelLight(options) == LevelLight::probes;
  if (probes && !build::isLevelFolder(options.sky))
    refuse("--sky-light probes: " + options.sky + " is not the folder of a baked level (it has no level.welkin)");
  const bool of_probes =
      component == Component::sky || component == Component::sun_bounce || component == Component::local;
  if (!probes && of_probes)
    refuse("--component " + options.component + ": only probes tell these parts apart; give --sky-light probes");
  if (!level && component != Component::all) refuse("--component: only a level has parts; give --level LEVEL.toml");
  if (!level && !options.occlusion.empty())
    refuse("--occlusion: only a level has surfaces that hide the sky; give --level LEVEL.toml");
  if (component == Component::occlusion && parseOcclusion(options, LevelLight::flat) != Occlusion::screen)
    refuse("--component occlusion: --occlusion none leaves it out");
  if (options.occlusion == "contact" && !probes)
    refuse("--occlusion contact: only the probes' light has contact factors; give the folder of a baked level");
  if (!level && options.no_reflections) refuse("--no-reflections: only a level has materials; give --level LEVEL.toml");
  if (!level && !options.lights.text.empty()) refuse("--light: only a level has lamps; give --level LEVEL.toml");
  options.lights.lights();
  const Shown shown = parseShown(options);
  if (!level && shown != Shown::drawn)
    refuse("--reference, --difference and --compare: only a level is traced; give --level LEVEL.toml");
  if (shown == Shown::drawn && options.json)
    refuse("--json: only --reference, --difference and --compare have numbers to print");
  if (shown != Shown::drawn && component == Component::occlusion)
    refuse("--component occlusion: the path tracer knows no occlusion in screen space");
  if (shown == Shown::compare && !options.sky_light.empty())
    refuse("--compare: it shows the flat light and the probes'; leave --sky-light out");
  if (shown == Shown::compare && options.times.size() > 1) refuse("--compare: give one --time");
  if (shown == Shown::compare && !probes)
    refuse("--compare: " + options.sky + " is not the folder of a baked level (it has no level.welkin)");
  if (shown != Shown::drawn && !options.probes.empty())
    refuse("--probes: the path tracer does not know these spheres; leave it out");
  if (cubemap && options.no_tint) refuse("--no-tint: the tint is baked into the cubemaps; leave --sky cubemap out");
}

}  // namespace welkin::command
