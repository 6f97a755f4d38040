// SPDX-License-Identifier: Apache-2.0
// The warnings of a level and of its baked sectors, for the report.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>

#include "probes/build/level_bake.h"

namespace welkin::build {

/// Adds the warnings of the level as a whole: features of its files that have no effect, hints at its shape
/// (level_hints.h), and that it has no sector.
void addWarnings(const LevelBake& level, nlohmann::ordered_json& warnings);

/// Adds the hint that a level's sectors have no probe at all.
void addProbelessWarning(std::size_t sectors, std::size_t probes, nlohmann::ordered_json& warnings);

/// Adds those of a sector. `budget`: the largest error that it may have; none: there is no budget.
void addWarnings(const sectors::SectorFile& file, std::optional<double> budget, nlohmann::ordered_json& warnings);

}  // namespace welkin::build
