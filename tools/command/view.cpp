// SPDX-License-Identifier: Apache-2.0
// welkin view: a baked level to look at, to pick and to compare.
#include <CLI/CLI.hpp>
#include <memory>

#include "command/commands.h"
#include "command/render_options.h"
#include "command/shared_options.h"
#include "view/example_level.h"
#include "view/run.h"
#include "view/window.h"

namespace welkin::command {
namespace {

struct Options {
  view::ViewOptions view;
  std::string size;
  ThreadsOption threads;
  ProgressOption progress;
  bool headless = false;
};

void runView(const Options& options) {
  view::ViewOptions view = options.view;
  if (!options.size.empty()) {
    const Size size = parseSize(options.size, {view.width, view.height});
    view.width = size.width;
    view.height = size.height;
    view.has_size = true;
  }
  const auto limit = options.threads.limit();
  if (view.folder.empty()) {
    catchInterrupts();
    ProgressReport shown(options.progress.style());
    view.folder = view::bakedExample(shown.progress());
  }
  options.headless ? view::runHeadless(view) : view::runWindow(view);
}

}  // namespace

void addView(CLI::App& app) {
  auto options = std::make_shared<Options>();
  auto* command =
      app.add_subcommand("view", "Look at a baked level: pick points, compare with the truth, change light");
  command->add_option("LEVEL_DIR", options->view.folder,
                      "The folder of a baked level; default: examples/island, baked on first use");
  command->add_option("--level", options->view.level, "The level.toml that was baked; default: the one that was baked");
  command->add_option("--script", options->view.script, "A file of commands to perform, one a line (docs/viewer.md)");
  command->add_option("--screenshot", options->view.screenshot, "A PNG to write at the end");
  command->add_option("--state", options->view.state,
                      "A JSON file to write at the end: what the panels say, in numbers");
  command->add_option("--size", options->size, "Pixels, WIDTHxHEIGHT");
  command->add_flag("--headless", options->headless, "Without a window: perform the script, write the files and end");
  options->threads.addTo(*command, "Of the path tracer");
  options->progress.addTo(*command);
  command->add_flag("--validate", options->view.validate,
                    "Run with Vulkan's validation layer; any message is an error");
  command->callback([options] { runView(*options); });
}

}  // namespace welkin::command
