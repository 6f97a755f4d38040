// SPDX-License-Identifier: Apache-2.0
// welkin project: computes the spherical harmonics of a cubemap or latlong.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "command/commands.h"
#include "sh/basis.h"
#include "sky/base/error.h"
#include "sky/base/message.h"
#include "sky/cubemap/environment.h"

namespace welkin::command {
namespace {

struct Options {
  std::vector<std::string> images;
  cubemap::PictureChoice choice;
  int bands = 3;
  bool json = false;
};

/// One picture, or six of one face each.
cubemap::Environment environmentOf(const Options& options) {
  if (options.images.size() == 1) return cubemap::projectImage(options.images[0], options.bands, options.choice);
  if (options.images.size() != 6 || !options.choice.layout.empty())
    throw base::Error(base::ExitStatus::usage, "project takes one picture, or six faces without --layout");
  std::array<std::filesystem::path, 6> paths;
  std::copy(options.images.begin(), options.images.end(), paths.begin());
  return cubemap::projectFaces(paths, options.bands, options.choice.layer);
}

void project(const Options& options) {
  const cubemap::Environment environment = environmentOf(options);
  nlohmann::ordered_json warnings = nlohmann::json::array();
  const auto warn = [&](const std::string& message) {
    std::fputs(
        fmt::format("welkin: warning: {}: {}\n", base::oneLine(options.images[0]), base::oneLine(message)).c_str(),
        stderr);
  };
  for (const std::string& note : environment.notes) {
    warnings.push_back({{"id", "picture"}, {"message", base::oneLine(note)}});
    warn(note);
  }
  if (environment.negative > 0) {
    const std::string message = fmt::format("{} values are below 0; they were taken as they are", environment.negative);
    warnings.push_back({{"id", "negative"}, {"count", environment.negative}, {"message", message}});
    warn(message);
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
      ->add_option("IMAGE", options->images,
                   "A picture of the whole sphere: OpenEXR with an envmap attribute; or any image, 2:1 a latlong, 1:6 "
                   "or 6:1 the faces +x -x +y -y +z -z, 4:3 or 3:4 a cross. Or six pictures, one of each face")
      ->required()
      ->expected(1, 6);
  command->add_option("--layout", options->choice.layout,
                      "Layout of the picture: latlong, exr-latlong, vstrip, hstrip, exr-cube, hcross:MR or vcross:MR, "
                      "with the faces in its middle and right of it, such as hcross:-z+x (docs/pictures.md)");
  command->add_option("--layer", options->choice.layer, "Layer, view or part of an OpenEXR file");
  command->add_option("--bands", options->bands, "Bands: bands^2 coefficients of radiance")
      ->check(CLI::Range(1, sh::kMostBands))
      ->capture_default_str();
  command->add_flag("--json", options->json, "Print JSON");
  command->callback([options] { project(*options); });
}

}  // namespace welkin::command
