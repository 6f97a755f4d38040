// SPDX-License-Identifier: Apache-2.0
// welkin bake: a sky file, or a level, into a folder. welkin merge: the index of a level that shards have baked.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <memory>

#include "command/bake_level.h"
#include "command/bake_sky.h"
#include "command/budget_option.h"
#include "command/certificate_text.h"
#include "command/commands.h"
#include "command/level_files.h"
#include "command/merged_report.h"
#include "command/shared_options.h"
#include "command/subject.h"
#include "command/warnings.h"
#include "sky/base/atomic_file.h"
#include "sky/base/error.h"

namespace welkin::command {
namespace {

struct Options {
  std::string file, folder, report, depfile;
  std::string shard, sectors;
  ProgressOption progress;
  ThreadsOption threads;
  CertifyOption certify;
  BudgetOption budget;
  bool force = false;
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

void requireLevel(const Options& options) {
  for (const auto& [name, given] :
       {std::pair("--shard", !options.shard.empty()), {"--sectors", !options.sectors.empty()}})
    if (given)
      throw base::Error(base::ExitStatus::usage,
                        fmt::format("{}: {} is no level file: it has no sectors", name, options.file));
}

/// The output whose date says that the bake ran to its end: of a level its index, or a shard's part of it.
std::filesystem::path ruleTarget(const std::filesystem::path& folder, const std::optional<Shard>& shard,
                                 bool of_level) {
  if (shard) return partPath(folder, *shard);
  return of_level ? indexPath(folder) : folder / "sky.welkin";
}

void writeRule(const Options& options, const Subject& subject, const std::optional<LevelInput>& level,
               const std::optional<Shard>& shard) {
  const std::filesystem::path folder = options.folder;
  base::makeFolder(folder);
  std::vector<std::filesystem::path> inputs;
  for (const auto& input : subject.inputs()) inputs.push_back(input.path);
  if (level)
    for (const auto& file : level->files)
      if (std::find(inputs.begin(), inputs.end(), file) == inputs.end()) inputs.push_back(file);
  std::string rule = escaped(ruleTarget(folder, shard, level.has_value())) + ":";
  for (const auto& input : inputs) rule += " " + escaped(input);
  base::writeFile(options.depfile, rule + "\n");
}

void bake(const Options& options) {
  const auto start = std::chrono::steady_clock::now();
  catchInterrupts();
  const auto limit = options.threads.limit();
  const auto shard = options.shard.empty() ? std::nullopt : std::optional(parseShard(options.shard));
  Subject subject = readSubject(options.file);
  bake::SkyFile& file = subject.sky;
  options.budget.applyTo(file.bake);
  if (!subject.level) requireLevel(options);
  std::optional<LevelInput> level;
  if (subject.level) level.emplace(readLevel(*subject.level, file.sky, file.bake.max_error));
  LevelOptions wanted{options.folder, shard, {}, options.force};
  if (!options.sectors.empty()) wanted.sectors = parseSectors(options.sectors, level->bake.sectors());
  const auto style = options.progress.style();
  const std::filesystem::path folder = options.folder;
  // A bake may end at any of these writes. The rule is there before its target has a new date; the report, which has
  // the checksums of all outputs, comes last: a set that it does not fit is half of an old bake and half of a new one.
  if (!options.depfile.empty()) writeRule(options, subject, level, shard);
  nlohmann::ordered_json timing;
  nlohmann::ordered_json report = {{"warnings", nlohmann::ordered_json::array()}};
  if (!shard || shard->index == 0)  // else another shard bakes it
    report = bakeSky(subject, folder, {options.certify.value(), options.force}, style, timing);
  if (level) bakeSectors(*level, wanted, style, report, timing);
  timing["total_s"] = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  base::writeFile(timingPath(folder, shard), textOf(timing));
  base::writeFile(options.report.empty() ? reportPath(folder, shard) : std::filesystem::path(options.report),
                  textOf(report));
  printWarnings(report["warnings"]);
  if (report.contains("certificate"))
    std::fputs(fmt::format("welkin: {}\n", certificateText(report["certificate"])).c_str(), stderr);
}

}  // namespace

void addBake(CLI::App& app) {
  auto options = std::make_shared<Options>();
  auto* command = app.add_subcommand("bake", "Bake a sky file, or a level file's sky and sectors, into a folder");
  command
      ->add_option("FILE", options->file,
                   "sky.toml, or level.toml: its sky, with what the level requires, and its sectors")
      ->required();
  command->add_option("-o", options->folder, "Folder of the outputs; made when missing")->required();
  options->threads.addTo(*command, "The outputs do not depend on it");
  command->add_option("--report", options->report, "Write the report here instead of DIR/report.json");
  command->add_option(
      "--depfile", options->depfile,
      "Write the inputs here as a make rule of sky.welkin; of a level, level.welkin or the shard's part of it");
  options->progress.addTo(*command);
  auto* shard = command->add_option("--shard", options->shard,
                                    "i/n: every n-th sector from the i-th, 0 <= i < n; shard 0 bakes the sky, too");
  command->add_option("--sectors", options->sectors, "Only these sectors: X_Z,X_Z,...")->excludes(shard);
  command->add_flag("--force", options->force, "Bake what is up to date, too");
  options->budget.addTo(*command);
  options->certify.addTo(*command);
  command->callback([options] { bake(*options); });
}

void addMerge(CLI::App& app) {
  auto folder = std::make_shared<std::string>();
  auto* command = app.add_subcommand("merge", "Check that all shards of a level are there and agree; write its index");
  command->add_option("DIR", *folder, "The folder that the shards were baked into")->required();
  command->callback([folder] {
    const sectors::LevelIndex index = mergeParts(*folder);
    fmt::print("{}: {} sectors\n", indexPath(*folder).string(), index.sector.size());
  });
}

}  // namespace welkin::command
