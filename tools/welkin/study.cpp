// SPDX-License-Identifier: Apache-2.0
// welkin study: cost against error of every way to bake a sky file, as a folder of tables, charts and words.
#include "study/study.h"

#include <fmt/format.h>
#include <tbb/global_control.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "sky/atomic_file.h"
#include "welkin/commands.h"
#include "welkin/progress.h"

namespace welkin::tools {
namespace {

struct Options {
  std::string file, folder, progress = "auto";
  bool quick = false;
  int threads = 0;
};

void study(const Options& options) {
  catchInterrupts();
  std::optional<tbb::global_control> limit;
  if (options.threads > 0)
    limit.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(options.threads));
  const sky::SkyFile file = sky::readSkyFile(options.file);
  makeFolder(options.folder);  // a minute before it is needed: who asked is still there
  ProgressReport progress(ProgressReport::styleOf(options.progress), "study", study::kAxes);
  const study::StudyOptions how{options.quick, [&] { return progress.step(); }, [] { return !interrupted(); }};
  const study::StudyReport report = study::studySky(file, how);
  study::writeReport(report, options.folder);
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
  command->add_option("--threads", options->threads, "Threads; 0: all. Only times depend on it")
      ->check(CLI::Range(0, 4096))
      ->capture_default_str();
  command->add_option("--progress", options->progress, "auto, bar, plain, json or none")
      ->check(CLI::IsMember({"auto", "bar", "plain", "json", "none"}))
      ->capture_default_str();
  command->callback([options] { study(*options); });
}

}  // namespace welkin::tools
