// SPDX-License-Identifier: Apache-2.0
// Options that several commands have, and mean the same by.
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
  int count = 0;  ///< 0: all

  /// `what` says what depends on it.
  void addTo(CLI::App& command, const std::string& what);
  /// Holds as long as it lives; null for all.
  std::unique_ptr<tbb::global_control> limit() const;
};

/// --certify.
struct CertifyOption {
  std::string name = "fast";

  void addTo(CLI::App& command);
  bake::Certify value() const;
};

}  // namespace welkin::command
