// SPDX-License-Identifier: Apache-2.0
// One drawn sky: read, baked, opened and checked.
#pragma once

#include <cstdint>
#include <string>

#include "tests/folder.h"

namespace welkin::stress {

/// Results of one sky. An evaluation is one direction at one instant: the model's shape and dome, and the runtime's
/// dome, irradiance, discs and stars.
struct Outcome {
  std::string fault;      ///< empty: none
  std::string gradients;  ///< text of the gradients drawn instead of the sky file's
  std::uint64_t evaluations = 0;
  bool refused = false;     ///< by the loader
  double bake_error = 0.0;  ///< largest error of a key over c0; 0 if none was measured
  double dome_error = 0.0;  ///< of the runtime's dome against the model's, over its bound
  bool step_measured = false;
};

/// How much is checked.
struct Effort {
  int instants = 10;
  int directions = 100;
};

/// Checks the sky of a seed and an index. `folder` holds its files.
Outcome lookAt(std::uint64_t seed, std::uint64_t index, const Effort& effort, const tests::Folder& folder);

/// The text of the sky file of a seed and an index.
std::string skyFileOf(std::uint64_t seed, std::uint64_t index);

}  // namespace welkin::stress
