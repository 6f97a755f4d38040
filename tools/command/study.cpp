// SPDX-License-Identifier: Apache-2.0
// welkin study: writes a folder of tables, charts and words about cost and error of every way to bake a sky or a level.
#include "study/study.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "command/budget_option.h"
#include "command/commands.h"
#include "command/shared_options.h"
#include "sky/base/atomic_file.h"
#include "sky/base/error.h"
#include "study/level_study.h"

namespace welkin::command {
namespace {

struct Options {
  std::string file, folder;
  ProgressOption progress;
  ThreadsOption threads;
  TargetOption target;
  bool quick = false;
};

study::StudyReport reportOf(const build::Subject& subject, bool quick, const base::Progress& progress) {
  if (subject.level) return study::studyLevel(subject, {quick, progress.stage("study", study::levelWays(quick))});
  return study::studySky(subject.sky, {.quick = quick, .progress = progress.stage("study", study::kAxes)});
}

void study(const Options& options) {
  catchInterrupts();
  const auto limit = options.threads.limit();
  build::Subject subject = build::readSubject(options.file);
  if (subject.level && !options.target.name.empty())
    throw base::Error(base::ExitStatus::usage, "--target: is of the study of a sky, and this file is a level");
  if (!options.target.name.empty()) bake::setTarget(subject.sky.bake, options.target.name);
  base::makeFolder(options.folder);  // early, so that an error shows while the user is still there
  ProgressReport shown(options.progress.style());
  const study::StudyReport report = reportOf(subject, options.quick, shown.progress());
  if (const std::size_t left_out = study::writeReport(report, options.folder); left_out > 0)
    fmt::print(stderr, "welkin: warning: {} charts are left out: gnuplot is not installed\n", left_out);
  for (const std::string& paragraph : report.paragraphs) fmt::print("{}\n", paragraph);
}

}  // namespace

void addStudy(CLI::App& app) {
  auto options = std::make_shared<Options>();
  auto* command =
      app.add_subcommand("study", "Measure cost against error of every way to bake a sky file, or a level's probes");
  command->add_option("FILE", options->file, "sky.toml or level.toml")->required();
  command->add_option("-o", options->folder, "Folder of tables, charts and conclusion.md; made when missing")
      ->required();
  command->add_flag("--quick", options->quick, "Fewer instants, ways and cubemaps: seconds instead of a minute or two");
  options->target.addTo(*command);
  options->threads.addTo(*command, "Only times depend on it");
  options->progress.addTo(*command);
  command->callback([options] { study(*options); });
}

}  // namespace welkin::command
