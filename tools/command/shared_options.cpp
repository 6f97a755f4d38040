// SPDX-License-Identifier: Apache-2.0
#include "command/shared_options.h"

#include <CLI/CLI.hpp>

namespace welkin::command {

void ProgressOption::addTo(CLI::App& command) {
  command.add_option("--progress", name, "auto, bar, plain, json or none")
      ->check(CLI::IsMember({"auto", "bar", "plain", "json", "none"}))
      ->capture_default_str();
}

void ThreadsOption::addTo(CLI::App& command, const std::string& what) {
  command.add_option("--threads", count, "Threads; 0: all. " + what)->check(CLI::Range(0, 4096))->capture_default_str();
}

std::unique_ptr<tbb::global_control> ThreadsOption::limit() const {
  if (count == 0) return nullptr;
  return std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                               static_cast<std::size_t>(count));
}

void CertifyOption::addTo(CLI::App& command) {
  command.add_option("--certify", name, "How to measure the error that the bake makes: fast, full (minutes) or none")
      ->check(CLI::IsMember({"fast", "full", "none"}))
      ->capture_default_str();
}

bake::Certify CertifyOption::value() const {
  for (const bake::Certify certify : {bake::Certify::none, bake::Certify::full})
    if (name == bake::nameOf(certify)) return certify;
  return bake::Certify::fast;
}

}  // namespace welkin::command
