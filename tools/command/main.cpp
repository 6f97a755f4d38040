// SPDX-License-Identifier: Apache-2.0
// welkin: bakes skies and levels, and shows the results. Results go to stdout, everything else to stderr.
#include <fmt/format.h>
#include <welkin/welkin.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <cstdio>

#include "command/arguments.h"
#include "command/commands.h"
#include "sh/arithmetic.h"
#include "sky/base/error.h"
#include "sky/base/failure.h"
#include "sky/base/message.h"

namespace {

int status(welkin::base::ExitStatus s) {
  return static_cast<int>(s);
}

int fail(welkin::base::ExitStatus s, const std::string& message) {
  std::fputs(fmt::format("welkin: {}\n", welkin::base::oneLine(message)).c_str(),
             stderr);  // fmt::print throws when stderr is full
  return status(s);
}

/// Refuses a first word that is not a command, because CLI11's own message does not name it.
void refuseUnknownCommand(const CLI::App& app, int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return;
  std::string names;
  for (const CLI::App* command : app.get_subcommands({})) {
    if (command->get_name() == argv[1]) return;
    names += (names.empty() ? "" : ", ") + command->get_name();
  }
  throw welkin::base::Error(welkin::base::ExitStatus::usage,
                            fmt::format("\"{}\" is not a command; those are {}", argv[1], names));
}

int run(int argc, char** argv) {
  using namespace welkin::command;
  if (const char* why = welkin::sh::whyArithmeticDiffers())
    return fail(welkin::base::ExitStatus::internal,
                fmt::format("{}: what is baked would differ from what other machines bake. A library that was loaded "
                            "with the program, by LD_PRELOAD perhaps, has changed the floating-point environment",
                            why));
  CLI::App app("Precomputed sky and ambient lighting for games.", "welkin");
  app.set_version_flag("--version",
                       fmt::format("{}.{}.{}", WELKIN_VERSION_MAJOR, WELKIN_VERSION_MINOR, WELKIN_VERSION_PATCH));
  app.require_subcommand(1);
  app.footer(
      "Exit status: 0 done, 1 usage, 2 file or device, or a folder in use, 3 invalid input or a budget not met, 4 "
      "internal, "
      "130 interrupted.");
  for (auto* add : {addInit, addBake, addMerge, addPlan, addProject, addInspect, addValidate, addEval, addSample,
                    addExport, addGloss, addReference, addStudy, addRender, addView, addCalibrate, addContact})
    add(app);
  refuseUnknownCommand(app, argc, argv);
  std::vector<std::string> arguments = joinSignedValues(argc, argv);
  std::reverse(arguments.begin(), arguments.end());  // CLI11 takes a vector in this order
  try {
    app.parse(arguments);
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() != 0)
      return fail(welkin::base::ExitStatus::usage,
                  fmt::format("{}; run \"welkin --help\" or \"welkin COMMAND --help\"", e.what()));
    app.exit(e);  // --help and --version
  }
  // If stdout is a file on a full disk, only the flush shows it.
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
    return fail(welkin::base::ExitStatus::file, "stdout: cannot write the results");
  return status(welkin::base::ExitStatus::done);
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // past the limit on file sizes write() then fails, and the process lives on
  try {
    return run(argc, argv);
  } catch (const std::exception& e) {
    const welkin::base::Error error = welkin::base::errorOf(e);
    return fail(error.status(),  // fmt::print throws where stdout is full
                fmt::format("{}{}", std::ferror(stdout) != 0 ? "stdout: " : "", error.what()));
  }
}
