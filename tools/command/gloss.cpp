// SPDX-License-Identifier: Apache-2.0
// welkin gloss: makes the mips of a normal map and its gloss together.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <string>

#include "command/commands.h"
#include "command/progress.h"
#include "command/shared_options.h"
#include "gloss/write_gloss.h"
#include "sky/base/atomic_file.h"
#include "sky/base/error.h"
#include "sky/base/folder_lock.h"
#include "sky/base/message.h"

namespace welkin::command {
namespace {

struct Options {
  std::string normal, gloss, roughness, output, format = "exr", wrap = "repeat";
  gloss::NormalMapOptions map;
  bool flip_green = false;
  ThreadsOption threads;
};

void say(const std::string& message) {
  std::fputs(fmt::format("welkin: {}\n", message).c_str(), stderr);  // fmt::print throws when stderr is full
}

gloss::Request requestOf(const Options& options) {
  if (options.gloss.empty() == options.roughness.empty())
    throw base::Error(base::ExitStatus::usage, "gloss takes --gloss or --roughness, a number or a map, and not both");
  gloss::Request request;
  request.normal = options.normal;
  request.roughness = options.gloss.empty();
  request.gloss = request.roughness ? options.roughness : options.gloss;
  request.options = options.map;
  request.wrap = options.wrap == "repeat" ? gloss::Wrap::repeat : gloss::Wrap::clamp;
  request.flip_green = options.flip_green;
  request.format = options.format == "exr"   ? gloss::Format::exr
                   : options.format == "png" ? gloss::Format::png
                                             : gloss::Format::png16;
  return request;
}

void runGloss(const Options& options) {
  const gloss::Request request = requestOf(options);
  const auto limit = options.threads.limit();
  catchInterrupts();
  ProgressReport report(ProgressReport::Style::none);
  const std::filesystem::path folder = options.output;
  base::makeFolder(folder);
  const base::FolderLock lock(folder);
  const gloss::Result result = gloss::writeGloss(request, folder, report.progress());
  base::writeFile(folder / "report.json", gloss::reportOf(result));
  for (const gloss::Warning& warning : result.warnings)
    say(fmt::format("warning: {}: {}", base::oneLine(options.normal), base::oneLine(warning.message)));
  for (const gloss::WrittenFile& file : result.files)
    fmt::print("{} {} bytes\n", base::oneLine((folder / file.name).string()), file.bytes);
  fmt::print("average Toksvig factor {:.4f}, gloss {:.4f}\n", result.average.factor, result.average.gloss);
}

}  // namespace

void addGloss(CLI::App& app) {
  auto options = std::make_shared<Options>();
  auto* command =
      app.add_subcommand("gloss", "Make the mips of a normal map and its gloss together (docs/materials.md)");
  command->add_option("NORMAL", options->normal, "Normal map: PNG, OpenEXR, TIFF, JPEG, WebP, BMP, Targa or DDS")
      ->required();
  command->add_option("--gloss", options->gloss, "Gloss in [0, 1], or a map of it: specular power 2^(13 gloss)");
  command->add_option("--roughness", options->roughness, "glTF's roughness in [0, 1], or a map of it");
  command->add_option("-o,--output", options->output, "Folder to write to")->required();
  command->add_option("--format", options->format, "exr (floats), png (8 bits) or png16")
      ->check(CLI::IsMember({"exr", "png", "png16"}))
      ->capture_default_str();
  command->add_option("--wrap", options->wrap, "How the map's edges meet: repeat or clamp; for the check of green")
      ->check(CLI::IsMember({"repeat", "clamp"}))
      ->capture_default_str();
  command->add_flag("--flip-green", options->flip_green, "Turn y round: from DirectX's maps to glTF's, or back");
  command->add_flag("--decode-srgb", options->map.decode_srgb, "The normals were sRGB-encoded by mistake: decode them");
  command->add_flag("--repair", options->map.repair,
                    "Flat normals in place of zero ones and of those that point inward");
  options->threads.addTo(*command, "The files do not depend on it");
  command->callback([options] { runGloss(*options); });
}

}  // namespace welkin::command
