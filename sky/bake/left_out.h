// SPDX-License-Identifier: Apache-2.0
// The parts that a sky does not need, and the bytes that their omission saves.
#pragma once

#include "sky/bake/sky_plan.h"

namespace welkin::bake {

/// Against a bake of the same keys and cubemaps with everything in it. Nothing here changes what the file shows.
std::vector<LeftOut> leftOut(const SkyFile& file, const SkyPlan& plan);

}  // namespace welkin::bake
