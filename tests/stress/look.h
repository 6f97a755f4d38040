// SPDX-License-Identifier: Apache-2.0
// One drawn sky: read, baked, opened and looked at.
#pragma once

#include <cstdint>
#include <string>

#include "tests/folder.h"

namespace welkin::stress {

/// What was seen of a sky. An evaluation is one direction at one instant: the model's shape and dome, the runtime's
/// dome, irradiance, discs and stars.
struct Outcome {
  std::string fault;      ///< empty: none
  std::string gradients;  ///< those drawn in place of the sky file's, in words
  std::uint64_t evaluations = 0;
  bool refused = false;     ///< by the loader: the coefficients drawn make no sky
  double bake_error = 0.0;  ///< of a key, of c0, where it was measured
  double dome_error = 0.0;  ///< of the runtime's dome against the model's, in units of what is allowed
  bool step_measured = false;
};

/// How much is looked at.
struct Effort {
  int instants = 10;
  int directions = 100;
};

/// The sky of a seed and an index. `folder` is for its files.
Outcome lookAt(std::uint64_t seed, std::uint64_t index, const Effort& effort, const tests::Folder& folder);

/// The text of its sky file.
std::string skyFileOf(std::uint64_t seed, std::uint64_t index);

}  // namespace welkin::stress
