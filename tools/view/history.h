// SPDX-License-Identifier: Apache-2.0
// Undo and redo of changes of the light and of edits of level.toml. Time, camera and what is picked are not part of it.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "view/state.h"

namespace welkin::view {

/// What undo leads back to.
struct Undoable {
  Changes changes;
  std::shared_ptr<const std::string> level;  ///< text of level.toml; null where nobody edits
  friend bool operator==(const Undoable&, const Undoable&) = default;
};

class History {
 public:
  /// Keeps what was before a change. A `joined` change belongs to the step before it, if there is one.
  void record(const Undoable& before, bool joined);
  /// What to go back or forth to; `now` is kept for the other way. Nothing at the end.
  std::optional<Undoable> undo(const Undoable& now);
  std::optional<Undoable> redo(const Undoable& now);

  std::size_t undoCount() const { return past_.size(); }
  std::size_t redoCount() const { return future_.size(); }

 private:
  std::vector<Undoable> past_, future_;  ///< the nearest last
};

}  // namespace welkin::view
