// SPDX-License-Identifier: Apache-2.0
// welkin project: computes the spherical harmonics of a cubemap or latlong.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "command/commands.h"
#include "sh/basis.h"
#include "sky/base/message.h"
#include "sky/cubemap/environment.h"

namespace welkin::command {
namespace {

struct Options {
  std::string image;
  int bands = 3;
  bool json = false;
};

void project(const Options& options) {
  const cubemap::Environment environment = cubemap::projectImage(options.image, options.bands);
  nlohmann::ordered_json warnings = nlohmann::json::array();
  if (environment.negative > 0) {
    const std::string message = fmt::format("{} values are below 0; they were taken as they are", environment.negative);
    warnings.push_back({{"id", "negative"}, {"count", environment.negative}, {"message", message}});
    std::fputs(fmt::format("welkin: warning: {}: {}\n", base::oneLine(options.image), message).c_str(), stderr);
  }
  const char* rule = environment.rule == sh::TexelRule::half_texel ? "half-texel" : "openexr";
  if (options.json) {
    nlohmann::ordered_json channels;
    for (int c = 0; c < 3; ++c)
      for (const auto& coefficient : environment.radiance_sh)
        channels[std::string(1, "rgb"[c])].push_back(coefficient[c]);
    const nlohmann::ordered_json json = {{"layout", environment.layout}, {"rule", rule},
                                         {"width", environment.width},   {"height", environment.height},
                                         {"bands", options.bands},       {"radiance_sh", channels},
                                         {"warnings", warnings}};
    fmt::print("{}\n", json.dump(2));
    return;
  }
  fmt::print("{} of {} x {}, {} rule\n", environment.layout, environment.width, environment.height, rule);
  fmt::print("  l   m {:>23} {:>23} {:>23}\n", "red", "green", "blue");
  for (int l = 0; l < options.bands; ++l)
    for (int m = -l; m <= l; ++m) {
      const auto& c = environment.radiance_sh[static_cast<std::size_t>(sh::indexOf(l, m))];
      fmt::print("{:3} {:3} {:23.16g} {:23.16g} {:23.16g}\n", l, m, c.x, c.y, c.z);
    }
}

}  // namespace

void addProject(CLI::App& app) {
  auto options = std::make_shared<Options>();
  auto* command = app.add_subcommand("project", "Project a cubemap or latlong into spherical harmonics");
  command
      ->add_option("IMAGE", options->image,
                   "OpenEXR with an envmap attribute; or any image: 2:1 a latlong, 1:6 or 6:1 the faces +x -x +y -y +z "
                   "-z, 4:3 or 3:4 a cross")
      ->required();
  command->add_option("--bands", options->bands, "Bands: bands^2 coefficients of radiance")
      ->check(CLI::Range(1, sh::kMostBands))
      ->capture_default_str();
  command->add_flag("--json", options->json, "Print JSON");
  command->callback([options] { project(*options); });
}

}  // namespace welkin::command
