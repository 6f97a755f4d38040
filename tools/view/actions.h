// SPDX-License-Identifier: Apache-2.0
// Everything that a script can do, and all that mouse, keys and panels do: one list.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace welkin::view {

class Session;
class Words;

struct Action {
  const char* name;
  const char* arguments;  ///< for the help
  const char* what;       ///< for the help
  void (*perform)(Session& session, Words& words);
};

std::span<const Action> actions();

/// Performs the command of these words, the first of which is its name. Throws Error(content).
void performAction(Session& session, const std::vector<std::string>& words);

}  // namespace welkin::view
