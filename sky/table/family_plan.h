// SPDX-License-Identifier: Apache-2.0
// Plans the tables of a family: skies that hold their irradiance by the same functions, so that the weights of two of
// them can be blended.
#pragma once

#include <span>
#include <vector>

#include "sky/table/plan.h"

namespace welkin::table {

/// One sky of a family, with its own budget. `bands`, `reconstruction` and `sh_bands` of the request are the same for
/// all; `shared` is of no effect.
struct FamilyMember {
  const DayValues* day = nullptr;
  PlanRequest request;
};

/// The tables with the fewest bytes in all that keep every member's budget. All have the same modes, byte by byte, or
/// the same bands of coefficients. Where there are none, those whose error is the least against its budget; `met` is
/// false for some then. `considered` names the functions that were tried, with their largest error at the keys of any
/// member. By member; the same for any number of threads.
std::vector<DayPlan> planFamily(std::span<const FamilyMember> family, const base::Progress& progress = {});

}  // namespace welkin::table
