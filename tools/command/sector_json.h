// SPDX-License-Identifier: Apache-2.0
// A baked sector, and the index of a level, as JSON.
#pragma once

#include <nlohmann/json.hpp>

#include "probes/sectors/level_index.h"
#include "probes/sectors/sector_file.h"

namespace welkin::command {

/// Sizes of the parts of a sector's file, bytes; they add up to `total`.
nlohmann::ordered_json bytesJson(const sectors::SectorFile& sector, std::size_t total);

/// Everything in a sector, decoded. `total`: size of its file, bytes.
nlohmann::ordered_json sectorJson(const sectors::SectorFile& sector, std::size_t total);

nlohmann::ordered_json indexJson(const sectors::LevelIndex& index);

}  // namespace welkin::command
