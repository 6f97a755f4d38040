// SPDX-License-Identifier: Apache-2.0
// welkin reference: path traces the irradiance at a point of a level, with its standard error.
#include "probes/reference/reference.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>

#include "command/arguments.h"
#include "command/commands.h"
#include "command/shared_options.h"
#include "probes/build/subject.h"
#include "sky/base/error.h"
#include "sky/base/message.h"

namespace welkin::command {
namespace {

struct Options {
  std::string file, time, position, normal;
  ProgressOption progress;
  ThreadsOption threads;
  std::vector<std::string> lights;
  std::size_t samples = 65536;
  std::optional<int> bounces;
  std::uint64_t seed = 0;
  bool json = false;
};

/// Parses "X,Y,Z,R,G,B" or "X,Y,Z,R,G,B,RADIUS". Throws Error(usage).
reference::LocalLight parseLight(const std::string& text) {
  const auto refuse = [&] {
    return base::Error(
        base::ExitStatus::usage,
        fmt::format("--light: \"{}\" is not a light: X,Y,Z,R,G,B or X,Y,Z,R,G,B,RADIUS, finite numbers, the "
                    "intensity and the radius in metres at least 0",
                    text));
  };
  const auto v = parseNumbers(text);
  if (!v || v->size() < 6 || v->size() > 7) throw refuse();
  for (std::size_t i = 3; i < v->size(); ++i)
    if ((*v)[i] < 0.0) throw refuse();
  const auto& n = *v;
  return {{n[0], n[1], n[2]}, {n[3], n[4], n[5]}, n.size() == 7 ? n[6] : 0.0};
}

void reference(const Options& options) {
  catchInterrupts();
  const f64::Number3 normal = parseDirection("--normal", options.normal);
  const f64::Number3 position = parsePosition("--position", options.position);
  const double time_h = parseTime(options.time);
  std::vector<reference::LocalLight> lights;
  for (const std::string& light : options.lights) lights.push_back(parseLight(light));
  const auto limit = options.threads.limit();
  const build::Subject subject = build::readLevel(options.file);
  for (const std::string& warning : subject.level->surfaces.warning)
    fmt::print(stderr, "welkin: warning: {}\n", base::oneLine(warning));
  const geometry::Tracer tracer(subject.level->surfaces, position);
  const int bounces = options.bounces.value_or(subject.level->section.transfer.bounces);
  const reference::ReferenceSettings settings{options.samples, bounces, options.seed};
  reference::ReferenceIrradiance result;
  {
    ProgressReport shown(options.progress.style());
    result =
        reference::traceReference(tracer, reference::DistantLight(subject.sky.sky, time_h), lights, position, normal,
                                  settings, shown.progress().stage("paths", reference::referenceBatches(settings)));
  }
  const auto json = [](const f64::Number3& v) { return nlohmann::ordered_json{v.x, v.y, v.z}; };
  if (options.json) {
    fmt::print("{}\n", nlohmann::ordered_json{{"irradiance", json(result.total.value)},
                                              {"components",
                                               {{"sky", json(result.sky.value)},
                                                {"sun_bounce", json(result.sun_bounce.value)},
                                                {"local", json(result.local.value)}}},
                                              {"standard_error", json(result.total.standard_error)},
                                              {"component_standard_error",
                                               {{"sky", json(result.sky.standard_error)},
                                                {"sun_bounce", json(result.sun_bounce.standard_error)},
                                                {"local", json(result.local.standard_error)}}},
                                              {"samples", result.samples},
                                              {"bounces", bounces}}
                           .dump(2));
    return;
  }
  const auto line = [](const char* name, const reference::Estimate& e) {
    fmt::print("{:<10} {:.6g} {:.6g} {:.6g} +- {:.2g} {:.2g} {:.2g}\n", name, e.value.x, e.value.y, e.value.z,
               e.standard_error.x, e.standard_error.y, e.standard_error.z);
  };
  line("irradiance", result.total);
  line("sky", result.sky);
  line("sun_bounce", result.sun_bounce);
  line("local", result.local);
}

}  // namespace

void addReference(CLI::App& app) {
  auto options = std::make_shared<Options>();
  auto* command = app.add_subcommand("reference", "Irradiance in a level, path traced, with its standard error");
  command->add_option("LEVEL", options->file, "level.toml")->required();
  command->add_option("--time", options->time, "Hours")->required();
  command->add_option("--position", options->position, "X,Y,Z in metres; it may lie on a surface")->required();
  command->add_option("--normal", options->normal, "X,Y,Z of the surface")->required();
  command->add_option("--light", options->lights,
                      "X,Y,Z,R,G,B[,RADIUS]: a dynamic light, its radiant intensity and the radius of its sphere in "
                      "metres; as many as there are");
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
