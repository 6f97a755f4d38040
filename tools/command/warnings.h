// SPDX-License-Identifier: Apache-2.0
// Warnings: a list in reports, lines on stderr.
#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>

#include "sky/bake/sky_file.h"

namespace welkin::command {

/// [{"id", "count", "message"}, ...] of a sky file.
inline nlohmann::ordered_json warningsJson(const bake::SkyFile& file) {
  auto list = nlohmann::ordered_json::array();
  for (const model::Warning& w : file.warnings)
    list.push_back({{"id", w.id}, {"count", w.count}, {"message", w.message}});
  return list;
}

inline void printWarnings(const nlohmann::ordered_json& list) {
  for (const auto& warning : list)
    std::fputs(fmt::format("welkin: warning: {}\n", warning["message"].get<std::string>()).c_str(), stderr);
}

}  // namespace welkin::command
