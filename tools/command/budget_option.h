// SPDX-License-Identifier: Apache-2.0
// The options that state an error budget. The commands bake and plan share them.
#pragma once

#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace welkin::command {

/// --cubemaps: the cubemaps' own budget, or none of them.
struct CubemapsOption {
  std::string text;  ///< empty: not given

  void addTo(CLI::App& command);
  /// The budget that replaces the sky file's settings of cubemaps; 0: none are made; nothing if it was not given.
  std::optional<double> value() const;
};

/// --target: the reader of the ambient light.
struct TargetOption {
  std::string name;  ///< empty: the sky file's

  void addTo(CLI::App& command);
};

/// --max-surface-error: the budget of a level's error on surfaces and in the air.
struct SurfaceBudgetOption {
  double max_error = 0.0;  ///< 0: not given

  void addTo(CLI::App& command);
  std::optional<double> value() const { return max_error > 0.0 ? std::optional(max_error) : std::nullopt; }
};

/// --max-error and --quality. At most one of them may be given.
struct BudgetOption {
  double max_error = 0.0;  ///< 0: not given
  std::string quality;     ///< empty: not given

  void addTo(CLI::App& command);
  /// The budget that replaces the sky file's own; none if neither option was given.
  std::optional<double> value() const;
};

}  // namespace welkin::command
