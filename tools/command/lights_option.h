// SPDX-License-Identifier: Apache-2.0
// --light: dynamic lights of a level, as many as there are.
#pragma once

#include <string>
#include <vector>

#include "probes/reference/light_path.h"

namespace CLI {
class App;
}

namespace welkin::command {

struct LightsOption {
  std::vector<std::string> text;

  /// Adds the option. `what` is the end of its help text.
  void addTo(CLI::App& command, const std::string& what);
  /// Throws Error(usage).
  std::vector<reference::LocalLight> lights() const;
};

/// Warns of lights that no virtual light of the level sees.
void warnOfUnseen(std::size_t unseen, std::size_t lights);

/// Warns of lights with a radius, which only the path tracer honours.
void warnOfRadii(const std::vector<reference::LocalLight>& lights);

}  // namespace welkin::command
