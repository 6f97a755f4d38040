// SPDX-License-Identifier: Apache-2.0
// A planned sky's cubemaps: those of sky.welkin, the same pictures as EXR files, and their error.
#pragma once

#include <vector>

#include "sky/bake/certify.h"
#include "sky/bake/sky_outputs.h"
#include "sky/bake/sky_plan.h"
#include "sky/cubemap/cubemap.h"
#include "sky/cubemap/cubemap_error.h"

namespace welkin::bake {

/// Those of sky.welkin. `saturated` counts components past their format's largest value. Throws Error(interrupted).
std::vector<cubemap::Cubemap> renderCubemaps(const SkyFile& file, const SkyPlan& plan, const base::Progress& progress,
                                             std::size_t& saturated);

/// The same pictures as EXR cubes and latlongs. Throws Error: interrupted; file.
void writeImages(const SkyFile& file, const SkyPlan& plan, SkyOutputs& outputs, const base::Progress& progress,
                 std::size_t& saturated);

/// The error of the cubemaps as they are in sky.welkin.
cubemap::CubemapError measureCubemaps(const SkyFile& file, const SkyPlan& plan,
                                      const std::vector<cubemap::Cubemap>& cubemaps, Certify how,
                                      const base::Progress& progress);

}  // namespace welkin::bake
