// SPDX-License-Identifier: Apache-2.0
// welkin bake: a sky file into a folder.
#include <fmt/format.h>
#include <tbb/global_control.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <memory>

#include "sky/atomic_file.h"
#include "sky/error.h"
#include "welkin/bake_sky.h"
#include "welkin/budget_option.h"
#include "welkin/certificate_text.h"
#include "welkin/commands.h"
#include "welkin/subject.h"
#include "welkin/warnings.h"

namespace welkin::tools {
namespace {

struct Options {
  std::string file, folder, report, depfile, progress = "auto", certify = "fast";
  BudgetOption budget;
  int threads = 0;
};

/// A path in a make rule.
std::string escaped(const std::filesystem::path& path) {
  std::string out;
  for (const char c : path.string()) {
    if (c == ' ' || c == '#') out += '\\';
    if (c == '$') out += '$';
    out += c;
  }
  return out;
}

/// A file name that is not UTF-8 is shown with replacement characters.
std::string textOf(const nlohmann::ordered_json& json) {
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

void bake(const Options& options) {
  const auto start = std::chrono::steady_clock::now();
  catchInterrupts();
  std::optional<tbb::global_control> limit;
  if (options.threads > 0)
    limit.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(options.threads));
  Subject subject = readSubject(options.file);
  sky::SkyFile& file = subject.sky;
  options.budget.applyTo(file.bake);
  const Certify how = options.certify == "none"   ? Certify::none
                      : options.certify == "full" ? Certify::full
                                                  : Certify::fast;
  const std::filesystem::path folder = options.folder;
  // A bake may end at any of these writes. The rule is there before its target has a new date; the report, which has
  // the checksums of all outputs, comes last: a set that it does not fit is half of an old bake and half of a new one.
  if (!options.depfile.empty()) {
    makeFolder(folder);
    std::string rule = escaped(folder / "sky.welkin") + ":";
    for (const auto& input : file.inputs) rule += " " + escaped(input.path);
    writeFile(options.depfile, rule + "\n");
  }
  nlohmann::ordered_json timing;
  const auto report = bakeSky(file, folder, how, ProgressReport::styleOf(options.progress), timing);
  timing["total_s"] = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  writeFile(folder / "timing.json", textOf(timing));
  writeFile(options.report.empty() ? folder / "report.json" : std::filesystem::path(options.report), textOf(report));
  printWarnings(report["warnings"]);
  if (report.contains("certificate"))
    std::fputs(fmt::format("welkin: {}\n", certificateText(report["certificate"])).c_str(), stderr);
}

}  // namespace

void addBake(CLI::App& app) {
  auto options = std::make_shared<Options>();
  auto* command = app.add_subcommand("bake", "Bake a sky file, or the sky of a level file, into a folder");
  command->add_option("FILE", options->file, "sky.toml, or level.toml: its sky, with what the level requires")
      ->required();
  command->add_option("-o", options->folder, "Folder of the outputs; made when missing")->required();
  command->add_option("--threads", options->threads, "Threads; 0: all. The outputs do not depend on it")
      ->check(CLI::Range(0, 4096))
      ->capture_default_str();
  command->add_option("--report", options->report, "Write the report here instead of DIR/report.json");
  command->add_option("--depfile", options->depfile, "Write the inputs here as a make rule");
  command->add_option("--progress", options->progress, "auto, bar, plain, json or none")
      ->check(CLI::IsMember({"auto", "bar", "plain", "json", "none"}))
      ->capture_default_str();
  options->budget.addTo(*command);
  command
      ->add_option("--certify", options->certify,
                   "How to measure the error that the bake makes: fast, full (minutes) or none")
      ->check(CLI::IsMember({"fast", "full", "none"}))
      ->capture_default_str();
  command->callback([options] { bake(*options); });
}

}  // namespace welkin::tools
