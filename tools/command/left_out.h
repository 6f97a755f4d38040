// SPDX-License-Identifier: Apache-2.0
// What a sky does not need, and what leaving it out saves.
#pragma once

#include "command/sky_plan.h"

namespace welkin::command {

/// Against a bake of the same keys and cubemaps with everything in it. Nothing here changes what the file shows.
std::vector<LeftOut> leftOut(const bake::SkyFile& file, const SkyPlan& plan);

}  // namespace welkin::command
