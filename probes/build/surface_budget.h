// SPDX-License-Identifier: Apache-2.0
// The budget of a level's error on surfaces and in the air: probes are closer where the error is, until it is kept.
#pragma once

#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <vector>

#include "probes/build/level_bake.h"
#include "sky/bake/sky_file.h"

namespace welkin::build {

/// Factors of the distances between probes that a search tries, widest first.
inline constexpr std::array<double, 7> kSpreads = {2.8, 2.0, 1.4, 1.0, 0.7, 0.5, 0.35};

/// How close the probes of each sector are, and the error that this keeps.
struct SurfaceChoice {
  std::vector<double> spread;                  ///< of kSpreads, in the order of LevelBake::sectors
  double error = 0.0;                          ///< the larger of surfaces and air, as the fast certificate measures it
  bool kept = false;                           ///< the error is within the budget
  std::string of;                              ///< hash of all that it depends on
  std::vector<sectors::SectorFile> file = {};  ///< as the search baked them, likewise; empty if there was none
};

/// Bakes the level with one spread after the other, widest first, until its certificate keeps the budget. Then sectors
/// of little error take wider ones again, as far as the certificate allows. So no single spread of all sectors that
/// keeps the budget has fewer bytes. The level has a budget. Throws Error(usage) where only a part of
/// it is to be baked, and what LevelBake::bake throws.
SurfaceChoice chooseSpreads(const LevelBake& level, const bake::SkyFile& sky, bool part_alone,
                            const base::Progress& progress);

/// The choice for the same level in a folder's report.json; nothing if there is none.
std::optional<SurfaceChoice> earlierChoice(const LevelBake& level, const bake::SkyFile& sky,
                                           const std::filesystem::path& folder);

/// For report.json, under "surface_budget".
nlohmann::ordered_json choiceJson(const LevelBake& level, const SurfaceChoice& choice);

/// Throws Error(content) where the certificate in the report of a level is above its budget.
void requireKept(const std::filesystem::path& file, const LevelBake& level, const nlohmann::ordered_json& report);

}  // namespace welkin::build
