// SPDX-License-Identifier: Apache-2.0
// A sky's plan for report.json and `plan --json`.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>

#include "sky/bake/sky_plan.h"

namespace welkin::bake {

/// Members "table", "cubemaps", "gradients", "left_out" and "warnings". `max_error`: the budget.
nlohmann::ordered_json planJson(const SkyPlan& plan, const std::optional<double>& max_error);

}  // namespace welkin::bake
