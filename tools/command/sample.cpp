// SPDX-License-Identifier: Apache-2.0
// welkin sample: prints a baked sky at one time, or the light at points of a baked level, as the runtime gives it.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <welkin/welkin.hpp>

#include "baked/level_folder.h"
#include "baked/welkin_file.h"
#include "command/arguments.h"
#include "command/commands.h"
#include "command/lights_option.h"
#include "command/surface_points.h"
#include "probes/build/level_files.h"
#include "sky/base/error.h"

namespace welkin::command {
namespace {

struct Options {
  std::string path, time;
  PointsOption points;
  LightsOption lights;
  bool json = false;
};

nlohmann::ordered_json rgbJson(const Float3& v) {
  return vectorJson(v.data());
}

nlohmann::ordered_json jsonOf(const std::optional<baked::PointLight>& light) {
  if (!light) return nullptr;
  return {
      {"irradiance", rgbJson(light->irradiance)},
      {"components",
       {{"sky", rgbJson(light->sky)}, {"sun_bounce", rgbJson(light->sun_bounce)}, {"local", rgbJson(light->local)}}}};
}

/// The light at points of a level.
void sampleLevel(const Options& options) {
  const double time_h = parseTime(options.time);
  const std::vector<SurfacePoint> points = options.points.points();
  const std::vector<reference::LocalLight> lamps = options.lights.lights();
  warnOfRadii(lamps);
  baked::LevelFolder level(options.path, lamps.size());
  warnOfUnseen(level.setLights(lamps), lamps.size());
  const auto lights = level.at(points, time_h);
  if (options.json && options.points.isOne()) {
    fmt::print("{}\n", jsonOf(lights[0]).dump(2));
  } else if (options.json) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const auto& light : lights) list.push_back(jsonOf(light));
    fmt::print("{}\n", nlohmann::ordered_json{{"points", std::move(list)}}.dump(2));
  } else {
    for (const auto& light : lights) {
      if (!light) {
        fmt::print("no probe serves this point\n");
        continue;
      }
      const auto line = [](const char* name, const Float3& v) {
        fmt::print("{:<10} {:.6g} {:.6g} {:.6g}\n", name, v[0], v[1], v[2]);
      };
      line("irradiance", light->irradiance);
      line("sky", light->sky);
      line("sun_bounce", light->sun_bounce);
      line("local", light->local);
    }
  }
}

void sample(const Options& options) {
  const bool at_points = !options.points.position.empty() || !options.points.isOne();
  if (at_points && !build::isLevelFolder(options.path))
    throw base::Error(base::ExitStatus::usage,
                      fmt::format("{}: not the folder of a baked level (it has no level.welkin), which --position and "
                                  "--points need",
                                  options.path));
  if (at_points) return sampleLevel(options);
  if (!options.lights.text.empty())
    throw base::Error(base::ExitStatus::usage, "--light: needs --position and --normal, or --points");
  const auto n = parseDirection("--normal", options.points.normal.empty() ? "0,1,0" : options.points.normal);
  const double time_h = parseTime(options.time);
  const std::string file = baked::skyFileOf(options.path);
  const Sky sky = baked::openSky(file);
  WelkinSkySample s{};
  if (!sky.sample(time_h, s)) throw base::Error(base::ExitStatus::internal, "sample failed");
  const float normal[3] = {static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z)};
  float irradiance[3];
  welkin_sky_irradiance(sky.get(), &s, normal, irradiance);
  if (!options.json) {
    fmt::print("time       {:.6g} h\n", s.time_h);
    fmt::print("sun        azimuth {:.3f}, elevation {:.3f} degrees, illuminance {:.6g}\n",
               azimuthDegrees(s.sun.direction), elevationDegrees(s.sun.direction), s.sun.illuminance);
    fmt::print("irradiance {:.6g} {:.6g} {:.6g} on normal {:.4g} {:.4g} {:.4g}\n", irradiance[0], irradiance[1],
               irradiance[2], normal[0], normal[1], normal[2]);
    return;
  }
  nlohmann::ordered_json json = {{"time_h", s.time_h}, {"sun", lightJson(s.sun)}};
  if (sky.info().has_moon != 0) json["moon"] = lightJson(s.moon);
  json["intensity"] = double{s.intensity};
  json["ambient_saturation"] = double{s.ambient_saturation};
  json["polarising_tint"] = vectorJson(s.polarising_tint);
  json["ground_radiance"] = vectorJson(s.ground_radiance);
  if (s.mode_count > 0) {
    json["mode_weight"] = nlohmann::json::array();
    for (std::uint32_t k = 0; k < s.mode_count; ++k) json["mode_weight"].push_back(vectorJson(s.mode_weight[k]));
  }
  json["radiance_sh"] = coefficientsJson(s.radiance_sh, s.coefficient_count);
  json["ambient_sh"] = coefficientsJson(s.ambient_sh, s.coefficient_count);
  if (sky.info().cubemap_count > 0)
    json["cubemaps"] = {{"first", s.cubemap[0]}, {"second", s.cubemap[1]}, {"weight", double{s.cubemap_weight}}};
  json["normal"] = vectorJson(normal);
  json["irradiance"] = vectorJson(irradiance);
  fmt::print("{}\n", json.dump(2));
}

}  // namespace

void addSample(CLI::App& app) {
  auto options = std::make_shared<Options>();
  auto* command = app.add_subcommand("sample", "Sample a baked sky, or points of a baked level, through the runtime");
  command->add_option("PATH", options->path, "Folder of a bake, or the .welkin file of a sky")->required();
  command->add_option("--time", options->time, "Hours")->required();
  options->points.addTo(*command);
  options->lights.addTo(*command,
                        "Of a level with local transfer. Walls between it and the level's virtual lights are not known "
                        "here, so all that are near enough see it. RADIUS has no effect");
  command->add_flag("--json", options->json, "Print JSON");
  command->callback([options] { sample(*options); });
}

}  // namespace welkin::command
