// SPDX-License-Identifier: Apache-2.0
// What the report says of a baked sector, and inspect as well.
#pragma once

#include <nlohmann/json.hpp>

#include "probes/level_index.h"
#include "probes/sector_file.h"

namespace welkin::tools {

/// What its numbers are off by.
nlohmann::ordered_json errorJson(const probes::SectorFile& sector);

nlohmann::ordered_json placementJson(const probes::PlacementCounts& counts);

/// The hashes of what it was baked from.
nlohmann::ordered_json fromJson(const probes::BakedFrom& from);

/// Its entry in report.json.
nlohmann::ordered_json reportJson(const probes::SectorFile& sector, const probes::SectorEntry& entry);

}  // namespace welkin::tools
