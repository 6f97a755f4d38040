// SPDX-License-Identifier: Apache-2.0
// The warnings of a sky file as a list for reports.
#pragma once

#include <nlohmann/json.hpp>

#include "sky/bake/sky_file.h"

namespace welkin::bake {

/// [{"id", "count", "message"}, ...] of a sky file.
inline nlohmann::ordered_json warningsJson(const SkyFile& file) {
  auto list = nlohmann::ordered_json::array();
  for (const model::Warning& w : file.warnings)
    list.push_back({{"id", w.id}, {"count", w.count}, {"message", w.message}});
  return list;
}

}  // namespace welkin::bake
