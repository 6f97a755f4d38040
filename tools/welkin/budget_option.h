// SPDX-License-Identifier: Apache-2.0
// The options that state an error budget, of bake, plan and study alike.
#pragma once

#include <string>

#include "sky/sky_file.h"

namespace CLI {
class App;
}

namespace welkin::tools {

/// --max-error and --quality, of which one may be given.
struct BudgetOption {
  double max_error = 0.0;  ///< 0: not given
  std::string quality;     ///< empty: not given

  void addTo(CLI::App& command);
  /// In place of the sky file's own.
  void applyTo(sky::BakeSettings& bake) const;
};

}  // namespace welkin::tools
