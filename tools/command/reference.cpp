// SPDX-License-Identifier: Apache-2.0
// welkin reference: path traces the irradiance at a point of a level, with its standard error.
#include "probes/reference/reference.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>

#include "command/arguments.h"
#include "command/commands.h"
#include "command/lights_option.h"
#include "command/shared_options.h"
#include "command/surface_points.h"
#include "probes/build/subject.h"
#include "sky/base/error.h"
#include "sky/base/message.h"

namespace welkin::command {
namespace {

struct Options {
  std::string file, time;
  PointsOption points;
  ProgressOption progress;
  ThreadsOption threads;
  LightsOption lights;
  std::size_t samples = 65536;
  std::optional<int> bounces;
  std::uint64_t seed = 0;
  bool json = false;
};

using reference::ReferenceIrradiance;

nlohmann::ordered_json json(const f64::Number3& v) {
  return {v.x, v.y, v.z};
}

nlohmann::ordered_json jsonOf(const ReferenceIrradiance& light) {
  return {{"irradiance", json(light.total.value)},
          {"components",
           {{"sky", json(light.sky.value)},
            {"sun_bounce", json(light.sun_bounce.value)},
            {"local", json(light.local.value)}}},
          {"standard_error", json(light.total.standard_error)},
          {"component_standard_error",
           {{"sky", json(light.sky.standard_error)},
            {"sun_bounce", json(light.sun_bounce.standard_error)},
            {"local", json(light.local.standard_error)}}}};
}

void print(const ReferenceIrradiance& light) {
  const auto line = [](const char* name, const reference::Estimate& e) {
    fmt::print("{:<10} {:.6g} {:.6g} {:.6g} +- {:.2g} {:.2g} {:.2g}\n", name, e.value.x, e.value.y, e.value.z,
               e.standard_error.x, e.standard_error.y, e.standard_error.z);
  };
  line("irradiance", light.total);
  line("sky", light.sky);
  line("sun_bounce", light.sun_bounce);
  line("local", light.local);
}

/// Traces the points one after the other. Each has its own seed, so that their errors average out.
std::vector<ReferenceIrradiance> traced(const build::Subject& subject, double time_h,
                                        const std::vector<reference::LocalLight>& lights,
                                        const std::vector<SurfacePoint>& points,
                                        const reference::ReferenceSettings& settings, const base::Progress& progress) {
  constexpr double kFar_m = 1024.0;  // a tracer's floats are rounded to 0.1 mm within that
  std::vector<ReferenceIrradiance> result;
  std::optional<geometry::Tracer> tracer;
  f64::Number3 origin{0.0};
  const reference::DistantLight distant(subject.sky.sky, time_h);
  const std::size_t batches = reference::referenceBatches(settings);
  for (const SurfacePoint& point : points) {
    const f64::Number3 away = point.position - origin;
    if (!tracer || dot(away, away) > kFar_m * kFar_m) tracer.emplace(subject.level->surfaces, origin = point.position);
    reference::ReferenceSettings own = settings;
    own.seed = settings.seed + 0x9e3779b97f4a7c15U * result.size();
    result.push_back(reference::traceReference(*tracer, distant, lights, point.position, point.normal, own,
                                               progress.stage("paths", batches)));
  }
  return result;
}

void reference(const Options& options) {
  catchInterrupts();
  const std::vector<SurfacePoint> points = options.points.points();
  const double time_h = parseTime(options.time);
  const std::vector<reference::LocalLight> lights = options.lights.lights();
  const auto limit = options.threads.limit();
  const build::Subject subject = build::readLevel(options.file);
  for (const std::string& warning : subject.level->surfaces.warning)
    fmt::print(stderr, "welkin: warning: {}\n", base::oneLine(warning));
  const int bounces = options.bounces.value_or(subject.level->section.transfer.bounces);
  const reference::ReferenceSettings settings{options.samples, bounces, options.seed};
  std::vector<ReferenceIrradiance> result;
  {
    ProgressReport shown(options.progress.style());
    result = traced(subject, time_h, lights, points, settings, shown.progress());
  }
  if (!options.json) {
    for (const ReferenceIrradiance& light : result) print(light);
    return;
  }
  nlohmann::ordered_json output;
  if (options.points.isOne()) {
    output = jsonOf(result[0]);
  } else {
    output["points"] = nlohmann::ordered_json::array();
    for (const ReferenceIrradiance& light : result) output["points"].push_back(jsonOf(light));
  }
  output["samples"] = result[0].samples;
  output["bounces"] = bounces;
  fmt::print("{}\n", output.dump(2));
}

}  // namespace

void addReference(CLI::App& app) {
  auto options = std::make_shared<Options>();
  auto* command = app.add_subcommand("reference", "Irradiance in a level, path traced, with its standard error");
  command->add_option("LEVEL", options->file, "level.toml")->required();
  command->add_option("--time", options->time, "Hours")->required();
  options->points.addTo(*command);
  options->lights.addTo(*command, "RADIUS is that of its sphere in metres");
  command->add_option("--samples", options->samples, "Paths")
      ->check(CLI::Range(std::size_t{1}, std::size_t{1} << 40))
      ->capture_default_str();
  command
      ->add_option("--bounces", options->bounces,
                   "Surfaces that light bounces off at most; the level's own number when left out")
      ->check(CLI::Range(0, 1000));
  command->add_option("--seed", options->seed, "Other seeds draw independent paths")->capture_default_str();
  options->threads.addTo(*command, "The result does not depend on it");
  options->progress.addTo(*command);
  command->add_flag("--json", options->json, "Print JSON");
  command->callback([options] { reference(*options); });
}

}  // namespace welkin::command
