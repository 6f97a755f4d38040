// SPDX-License-Identifier: Apache-2.0
#include "view/history.h"

namespace welkin::view {
namespace {

constexpr std::size_t kMostUndone = 1000;

std::optional<Undoable> moved(std::vector<Undoable>& from, std::vector<Undoable>& to, const Undoable& now) {
  if (from.empty()) return std::nullopt;
  const Undoable target = from.back();
  from.pop_back();
  to.push_back(now);
  return target;
}

}  // namespace

void History::record(const Undoable& before, bool joined) {
  future_.clear();
  if (joined && !past_.empty()) return;
  past_.push_back(before);
  if (past_.size() > kMostUndone) past_.erase(past_.begin());
}

std::optional<Undoable> History::undo(const Undoable& now) {
  return moved(past_, future_, now);
}

std::optional<Undoable> History::redo(const Undoable& now) {
  return moved(future_, past_, now);
}

}  // namespace welkin::view
