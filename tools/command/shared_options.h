// SPDX-License-Identifier: Apache-2.0
// Options that several commands share.
#pragma once

#include <tbb/global_control.h>

#include <memory>
#include <string>

#include "command/progress.h"
#include "sky/bake/certify.h"

namespace CLI {
class App;
}

namespace welkin::command {

/// --progress.
struct ProgressOption {
  std::string name = "auto";

  void addTo(CLI::App& command);
  ProgressReport::Style style() const { return ProgressReport::styleOf(name); }
};

/// --threads.
struct ThreadsOption {
  int count = 0;  ///< most threads; 0: one per processor

  /// Adds the option. `what` is the end of its help text.
  void addTo(CLI::App& command, const std::string& what);
  /// Limits oneTBB's threads for as long as the result lives; null without a limit.
  std::unique_ptr<tbb::global_control> limit() const;
};

/// --certify.
struct CertifyOption {
  std::string name = "fast";

  void addTo(CLI::App& command);
  bake::Certify value() const;
};

}  // namespace welkin::command
