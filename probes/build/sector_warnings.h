// SPDX-License-Identifier: Apache-2.0
// The warnings of a baked sector, for the report.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>

#include "probes/sectors/sector_file.h"

namespace welkin::build {

/// Adds those of a sector to a list. `budget`: the largest error that it may have; none: there is no budget.
void addWarnings(const sectors::SectorFile& file, std::optional<double> budget, nlohmann::ordered_json& warnings);

}  // namespace welkin::build
