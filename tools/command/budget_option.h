// SPDX-License-Identifier: Apache-2.0
// The options that state an error budget, of bake, plan and study alike.
#pragma once

#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace welkin::command {

/// --max-error and --quality, of which one may be given.
struct BudgetOption {
  double max_error = 0.0;  ///< 0: not given
  std::string quality;     ///< empty: not given

  void addTo(CLI::App& command);
  /// In place of the sky file's own; none when neither was given.
  std::optional<double> value() const;
};

}  // namespace welkin::command
