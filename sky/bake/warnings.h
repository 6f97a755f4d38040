// SPDX-License-Identifier: Apache-2.0
// Warnings as a list for reports.
#pragma once

#include <nlohmann/json.hpp>

#include "sky/model/path_check.h"

namespace welkin::bake {

/// [{"id", "count", "message"}, ...]
inline nlohmann::ordered_json warningsJson(const std::vector<model::Warning>& warnings) {
  auto list = nlohmann::ordered_json::array();
  for (const model::Warning& w : warnings) list.push_back({{"id", w.id}, {"count", w.count}, {"message", w.message}});
  return list;
}

}  // namespace welkin::bake
