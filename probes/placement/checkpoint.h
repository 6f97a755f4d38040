// SPDX-License-Identifier: Apache-2.0
// How long work is told to stop.
#pragma once

#include <functional>

namespace welkin::placement {

/// Called every few milliseconds, from any thread; what it throws ends the work. May be empty.
using Checkpoint = std::function<void()>;

inline void pass(const Checkpoint& checkpoint) {
  if (checkpoint) checkpoint();
}

}  // namespace welkin::placement
