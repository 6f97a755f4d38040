// SPDX-License-Identifier: Apache-2.0
// The bake of skies that share their modes, so that a game may blend any two of them.
#pragma once

#include "sky/bake/bake_sky.h"
#include "sky/bake/sky_plan.h"

namespace welkin::bake {

/// Plans the skies of a family, perhaps more than once.
class FamilyPlanner {
 public:
  FamilyPlanner(std::span<const SkyFile> family, const base::Progress& progress);

  /// Every sky for `share` of its budget; without budgets, as the files say. Throws as SkyPlanner::plan.
  std::vector<SkyPlan> plan(double share);
  SkyPlanner& of(std::size_t sky) { return *planner_[sky]; }

 private:
  std::span<const SkyFile> family_;
  base::Progress progress_;
  std::vector<std::unique_ptr<SkyPlanner>> planner_;
};

/// Bakes every sky into `folder` as bakeSky does, by its name, unless all are up to date. `family` has two or more, of
/// names that differ, and fits checkFamily; it is put in the order of the names, by which the bytes do not depend on
/// the order given. Budgets hold for every sky, and for the blend of two the larger of theirs. Returns a report with
/// the members "skies" (by name, as bakeSky's), "blends" (the worst), "inputs" and "warnings". Throws Error.
nlohmann::ordered_json bakeFamily(std::vector<SkyFile> family, const std::vector<Input>& inputs,
                                  const std::filesystem::path& folder, const SkyRequest& request,
                                  const base::Progress& progress, nlohmann::ordered_json& timing);

}  // namespace welkin::bake
