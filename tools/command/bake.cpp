// SPDX-License-Identifier: Apache-2.0
// welkin bake: bakes a sky file or a level into a folder. welkin merge: writes the index of a level baked in shards.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

#include "command/budget_option.h"
#include "command/certificate_text.h"
#include "command/commands.h"
#include "command/shared_options.h"
#include "probes/build/bake_file.h"
#include "probes/build/level_files.h"

namespace welkin::command {
namespace {

struct Options {
  std::vector<std::string> files;
  std::string folder, report, depfile;
  std::string shard, sectors;
  ProgressOption progress;
  ThreadsOption threads;
  CertifyOption certify;
  BudgetOption budget;
  SurfaceBudgetOption surface_budget;
  CubemapsOption cubemaps;
  TargetOption target;
  bool force = false;
};

void bake(const Options& options) {
  catchInterrupts();
  const auto limit = options.threads.limit();
  build::BakeRequest request;
  request.file = options.files.front();
  request.more.assign(options.files.begin() + 1, options.files.end());
  request.folder = options.folder;
  request.report = options.report;
  request.depfile = options.depfile;
  request.max_error = options.budget.value();
  request.max_surface_error = options.surface_budget.value();
  request.cubemap_error = options.cubemaps.value();
  request.target = options.target.name;
  request.certify = options.certify.value();
  if (!options.shard.empty()) request.shard = build::parseShard(options.shard);
  request.sectors = options.sectors;
  request.force = options.force;
  std::vector<std::string> told;
  request.warn = [&told](const std::string& message) {
    printWarning(message);
    told.push_back(message);
  };
  ProgressReport shown(options.progress.style());
  const nlohmann::ordered_json report = build::bakeFile(request, shown.progress());
  printWarnings(report["warnings"], told);
  printCertificates(report);
  if (report.contains("surfaces"))
    std::fputs(fmt::format("welkin: {}\n", surfacesText(report["surfaces"])).c_str(), stderr);
}

}  // namespace

void addBake(CLI::App& app) {
  auto options = std::make_shared<Options>();
  auto* command = app.add_subcommand("bake", "Bake a sky file, or a level file's sky and sectors, into a folder");
  command
      ->add_option("FILE", options->files,
                   "sky.toml, or level.toml: its sky, with what the level requires, and its sectors; or several sky "
                   "files, a family: DIR/NAME.welkin of each NAME.toml, whose blends are as exact as each sky")
      ->required();
  command->add_option("-o", options->folder, "Folder of the outputs; made when missing")->required();
  options->threads.addTo(*command, "The outputs do not depend on it");
  command->add_option("--report", options->report, "Write the report here instead of DIR/report.json");
  command->add_option(
      "--depfile", options->depfile,
      "Write the inputs here as a make rule of the sky; of a level, level.welkin or the shard's part of it");
  options->progress.addTo(*command);
  auto* shard = command->add_option("--shard", options->shard,
                                    "i/n: every n-th sector from the i-th, 0 <= i < n; shard 0 bakes the sky, too");
  command->add_option("--sectors", options->sectors, "Only these sectors: X_Z,X_Z,...")->excludes(shard);
  command->add_flag("--force", options->force, "Bake what is up to date, too");
  options->budget.addTo(*command);
  options->surface_budget.addTo(*command);
  options->cubemaps.addTo(*command);
  options->target.addTo(*command);
  options->certify.addTo(*command);
  command->callback([options] { bake(*options); });
}

void addMerge(CLI::App& app) {
  auto folder = std::make_shared<std::string>();
  auto* command = app.add_subcommand("merge", "Check that all shards of a level are there and agree; write its index");
  command->add_option("DIR", *folder, "The folder that the shards were baked into")->required();
  command->callback([folder] {
    const sectors::LevelIndex index = build::mergeParts(*folder);
    fmt::print("{}: {} sectors\n", build::indexPath(*folder).string(), index.sector.size());
  });
}

}  // namespace welkin::command
