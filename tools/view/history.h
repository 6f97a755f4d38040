// SPDX-License-Identifier: Apache-2.0
// Undo and redo of changes of the light. Time, camera and what is picked are not part of it.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "view/state.h"

namespace welkin::view {

class History {
 public:
  /// Keeps what was before a change. A `joined` change belongs to the step before it, if there is one.
  void record(const Changes& before, bool joined);
  /// What to go back or forth to; `now` is kept for the other way. Nothing at the end.
  std::optional<Changes> undo(const Changes& now);
  std::optional<Changes> redo(const Changes& now);

  std::size_t undoCount() const { return past_.size(); }
  std::size_t redoCount() const { return future_.size(); }

 private:
  std::vector<Changes> past_, future_;  ///< the nearest last
};

}  // namespace welkin::view
