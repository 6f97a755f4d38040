// SPDX-License-Identifier: Apache-2.0
#include "view/history.h"

namespace welkin::view {
namespace {

constexpr std::size_t kMostUndone = 1000;

std::optional<Changes> moved(std::vector<Changes>& from, std::vector<Changes>& to, const Changes& now) {
  if (from.empty()) return std::nullopt;
  const Changes target = from.back();
  from.pop_back();
  to.push_back(now);
  return target;
}

}  // namespace

void History::record(const Changes& before, bool joined) {
  future_.clear();
  if (joined && !past_.empty()) return;
  past_.push_back(before);
  if (past_.size() > kMostUndone) past_.erase(past_.begin());
}

std::optional<Changes> History::undo(const Changes& now) {
  return moved(past_, future_, now);
}

std::optional<Changes> History::redo(const Changes& now) {
  return moved(future_, past_, now);
}

}  // namespace welkin::view
