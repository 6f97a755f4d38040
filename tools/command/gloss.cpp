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
  double max_error = 0.0;
  ThreadsOption threads;
};

void say(const std::string& message) {
  std::fputs(fmt::format("welkin: {}\n", message).c_str(), stderr);  // fmt::print throws when stderr is full
}

gloss::Format formatOf(const std::string& name) {
  using gloss::Format;
  return name == "exr"     ? Format::exr
         : name == "png"   ? Format::png
         : name == "png16" ? Format::png16
         : name == "bc3"   ? Format::bc3
                           : Format::bc5;
}

void printBlocks(const gloss::BlockReport& report) {
  if (!report.bc3) {
    fmt::print("errors: normals {:.3f} degrees, y {:.4f}, gloss {:.4f} rms\n", report.apart.angle_rms,
               report.apart.y_rms, report.apart.gloss_rms);
    return;
  }
  fmt::print("errors with the gloss map in red: normals {:.3f} degrees, y {:.4f}, gloss {:.4f} rms\n",
             report.with_map.angle_rms, report.with_map.y_rms, report.with_map.gloss_rms);
  fmt::print("errors with one number in red: normals {:.3f} degrees, y {:.4f}, gloss {:.4f} rms\n",
             report.with_average.angle_rms, report.with_average.y_rms, report.with_average.gloss_rms);
  fmt::print("red holds {}\n", report.holds_map ? "the gloss map" : "the average Toksvig factor's gloss");
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
  request.format = formatOf(options.format);
  if (options.max_error > 0.0 && request.format != gloss::Format::bc3)
    throw base::Error(base::ExitStatus::usage, "--max-error: only bc3 has gloss and normals in one block");
  if (options.max_error > 0.0) request.max_error_deg = options.max_error;
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
  if (result.blocks) printBlocks(*result.blocks);
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
  command
      ->add_option(
          "--format", options->format,
          "exr (floats), png (8 bits), png16, bc3 (one DDS: x in alpha, y in green, gloss in red) or bc5 (DDS of "
          "normals, and bc4 of gloss)")
      ->check(CLI::IsMember({"exr", "png", "png16", "bc3", "bc5"}))
      ->capture_default_str();
  command
      ->add_option("--max-error", options->max_error,
                   "bc3: largest rms error of normals, degrees, with a gloss map in red; past it the average Toksvig "
                   "factor is there. Default: always the map")
      ->check(CLI::PositiveNumber);
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
