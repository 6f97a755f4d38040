// SPDX-License-Identifier: Apache-2.0
// Lets a caller stop long work.
#pragma once

#include <functional>

namespace welkin::placement {

/// Called every few milliseconds, from any thread. An exception from it ends the work. May be empty.
using Checkpoint = std::function<void()>;

inline void pass(const Checkpoint& checkpoint) {
  if (checkpoint) checkpoint();
}

}  // namespace welkin::placement
