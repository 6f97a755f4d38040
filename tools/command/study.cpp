// SPDX-License-Identifier: Apache-2.0
// welkin study: writes a folder of tables, charts and words about cost and error of every way to bake a sky file.
#include "study/study.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "command/budget_option.h"
#include "command/commands.h"
#include "command/shared_options.h"
#include "sky/base/atomic_file.h"

namespace welkin::command {
namespace {

struct Options {
  std::string file, folder;
  ProgressOption progress;
  ThreadsOption threads;
  TargetOption target;
  bool quick = false;
};

void study(const Options& options) {
  catchInterrupts();
  const auto limit = options.threads.limit();
  bake::SkyFile file = bake::readSkyFile(options.file);
  if (!options.target.name.empty()) bake::setTarget(file.bake, options.target.name);
  base::makeFolder(options.folder);  // early, so that an error shows while the user is still there
  ProgressReport shown(options.progress.style());
  const study::StudyOptions how{.quick = options.quick, .progress = shown.progress().stage("study", study::kAxes)};
  const study::StudyReport report = study::studySky(file, how);
  if (const std::size_t left_out = study::writeReport(report, options.folder); left_out > 0)
    fmt::print(stderr, "welkin: warning: {} charts are left out: gnuplot is not installed\n", left_out);
  for (const std::string& paragraph : report.paragraphs) fmt::print("{}\n", paragraph);
}

}  // namespace

void addStudy(CLI::App& app) {
  auto options = std::make_shared<Options>();
  auto* command = app.add_subcommand("study", "Measure cost against error of every way to bake a sky file");
  command->add_option("FILE", options->file, "sky.toml")->required();
  command->add_option("-o", options->folder, "Folder of tables, charts and conclusion.md; made when missing")
      ->required();
  command->add_flag("--quick", options->quick, "Fewer instants, ways and cubemaps: seconds instead of a minute or two");
  options->target.addTo(*command);
  options->threads.addTo(*command, "Only times depend on it");
  options->progress.addTo(*command);
  command->callback([options] { study(*options); });
}

}  // namespace welkin::command
