// SPDX-License-Identifier: Apache-2.0
// Kills a command again and again, each time from the same start.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace welkin::tests {

struct KillSweep {
  std::vector<std::string> command;
  std::function<void()> prepare;         ///< makes the start
  std::function<void(int)> requireGood;  ///< what is left after a kill, of the so manyeth run
};

/// Kills at every call that changes the disk, from the first on, until a run has no such call left. That must be past
/// the `least`th.
void killAtEveryCall(const KillSweep& sweep, int least);

/// Kills so many runs, evenly spread over a little more than the time of a whole run.
void killAtAnyTime(const KillSweep& sweep, int kills);

}  // namespace welkin::tests
