// SPDX-License-Identifier: Apache-2.0
// welkin gloss: makes the mips of a normal map and its gloss together.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "command/commands.h"
#include "command/progress.h"
#include "command/shared_options.h"
#include "gloss/batch.h"
#include "sky/base/atomic_file.h"
#include "sky/base/error.h"
#include "sky/base/folder_lock.h"
#include "sky/base/make_rule.h"
#include "sky/base/message.h"

namespace welkin::command {
namespace {

using Json = nlohmann::ordered_json;

struct Options {
  std::string normal, gloss, roughness, output, depfile, format = "exr", wrap = "repeat";
  gloss::NormalMapOptions map;
  bool flip_green = false, force = false;
  double max_error = 0.0;
  ThreadsOption threads;
  ProgressOption progress;
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

void printErrors(const std::string& of, const Json& error) {
  fmt::print("errors{}: normals {:.3f} degrees, y {:.4f}, gloss {:.4f} rms\n", of, double{error["normal_rms_deg"]},
             double{error["y_rms"]}, double{error["gloss_rms"]});
}

void printBlocks(const Json& blocks) {
  if (blocks["format"] == "bc5") return printErrors("", blocks["error"]);
  printErrors(" with the gloss map in red", blocks["with_map"]);
  printErrors(" with one number in red", blocks["with_average"]);
  fmt::print("red holds {}\n", blocks["red"] == "map" ? "the gloss map" : "the average Toksvig factor's gloss");
}

void printTexture(const gloss::Made& made, const std::filesystem::path& folder) {
  const Json& report = made.report;
  const std::string name = report["normal"];
  for (const Json& warning : report["warnings"])
    say(fmt::format("warning: {}: {}", name, std::string(warning["message"])));
  if (made.up_to_date) say(fmt::format("{}: up to date", name));
  for (const Json& file : report["files"])
    fmt::print("{} {} bytes\n", base::oneLine((folder / std::string(file["name"])).string()), int{file["bytes"]});
  if (report.contains("blocks")) printBlocks(report["blocks"]);
  fmt::print("{}: average Toksvig factor {:.4f}, gloss {:.4f}\n", name, double{report["average_toksvig"]["factor"]},
             double{report["average_toksvig"]["gloss"]});
}

/// report.json of a former run; empty if there is none.
std::string formerReport(const Options& options) {
  const std::filesystem::path path = std::filesystem::path(options.output) / "report.json";
  std::error_code none;
  if (options.force || !std::filesystem::is_regular_file(path, none)) return "";
  const std::vector<std::byte> bytes = base::readFile(path);
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

void writeRule(const Options& options, const std::vector<gloss::Request>& requests) {
  std::string rule = base::inMakeRule(std::filesystem::path(options.output) / "report.json") + ":";
  for (const gloss::Request& request : requests)
    for (const auto& input : gloss::inputsOf(request)) rule += " " + base::inMakeRule(input);
  base::writeFile(options.depfile, rule + "\n");
}

gloss::Request requestOf(const Options& options) {
  if (!options.gloss.empty() && !options.roughness.empty())
    throw base::Error(base::ExitStatus::usage, "gloss takes --gloss or --roughness, and not both");
  gloss::Request request;
  request.normal = options.normal;
  request.roughness = !options.roughness.empty();
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

/// The report of one texture, or of a folder's.
Json reportOfAll(const gloss::BatchResult& result, bool folder) {
  if (!folder) return result.made[0].report;
  Json report = {{"textures", Json::array()}, {"failed", Json::array()}};
  for (const gloss::Made& made : result.made)
    if (!made.report.is_null()) report["textures"].push_back(made.report);
  for (const auto& failure : result.failed)
    report["failed"].push_back(
        {{"normal", base::oneLine(failure.normal)}, {"message", base::oneLine(failure.error.what())}});
  return report;
}

void runGloss(const Options& options) {
  const gloss::Request common = requestOf(options);
  std::error_code none;
  const bool many = std::filesystem::is_directory(options.normal, none);
  if (!many && common.gloss.empty())
    throw base::Error(base::ExitStatus::usage, "gloss takes --gloss or --roughness, a number or a map");
  const std::vector<gloss::Request> requests =
      many ? gloss::texturesIn(options.normal, common) : std::vector<gloss::Request>{common};
  const auto limit = options.threads.limit();
  catchInterrupts();
  ProgressReport shown(many ? options.progress.style() : ProgressReport::Style::none);
  const std::filesystem::path folder = options.output;
  base::makeFolder(folder);
  const base::FolderLock lock(folder);
  const gloss::FormerReports former(formerReport(options));
  const gloss::BatchResult result = gloss::makeAll(requests, folder, former, shown.progress());
  if (!many && !result.failed.empty()) throw result.failed[0].error;
  for (const gloss::Made& made : result.made)
    if (!made.report.is_null()) printTexture(made, folder);
  base::writeFile(folder / "report.json", reportOfAll(result, many).dump(2) + "\n");
  if (!options.depfile.empty()) writeRule(options, requests);
  if (result.failed.empty()) return;
  for (const auto& failure : result.failed) say(base::oneLine(failure.error.what()));
  throw base::Error(result.failed[0].error.status(),
                    fmt::format("{} of {} textures failed", result.failed.size(), requests.size()));
}

}  // namespace

void addGloss(CLI::App& app) {
  auto options = std::make_shared<Options>();
  auto* command =
      app.add_subcommand("gloss", "Make the mips of a normal map and its gloss together (docs/materials.md)");
  command
      ->add_option(
          "NORMAL", options->normal,
          "Normal map: PNG, OpenEXR, TIFF, JPEG, WebP, BMP, Targa or DDS. Or a folder of pictures: normal maps end in "
          "_normal, _nrm or _n, and those with _gloss or _roughness in that place belong to them")
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
  command->add_option("--depfile", options->depfile, "Write the inputs here as a make rule of report.json");
  command->add_flag("--force", options->force, "Make textures that are up to date, too");
  options->progress.addTo(*command);
  options->threads.addTo(*command, "The files do not depend on it");
  command->callback([options] { runGloss(*options); });
}

}  // namespace welkin::command
