// SPDX-License-Identifier: Apache-2.0
// The options that state an error budget. The commands bake, plan and study share them.
#pragma once

#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace welkin::command {

/// --max-error and --quality. At most one of them may be given.
struct BudgetOption {
  double max_error = 0.0;  ///< 0: not given
  std::string quality;     ///< empty: not given

  void addTo(CLI::App& command);
  /// The budget that replaces the sky file's own; none if neither option was given.
  std::optional<double> value() const;
};

}  // namespace welkin::command
