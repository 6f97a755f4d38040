// SPDX-License-Identifier: Apache-2.0
// What the report says of a baked sector, and inspect as well.
#pragma once

#include <nlohmann/json.hpp>

#include "probes/sectors/level_index.h"
#include "probes/sectors/sector_file.h"

namespace welkin::build {

/// What its numbers are off by.
nlohmann::ordered_json errorJson(const sectors::SectorFile& sector);

/// The result of its placement, with places in the world.
nlohmann::ordered_json placementJson(const sectors::SectorFile& sector);

/// The hashes of what it was baked from.
nlohmann::ordered_json fromJson(const sectors::BakedFrom& from);

/// Its entry in report.json.
nlohmann::ordered_json reportJson(const sectors::SectorFile& sector, const sectors::SectorEntry& entry);

}  // namespace welkin::build
