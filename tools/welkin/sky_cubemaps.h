// SPDX-License-Identifier: Apache-2.0
// A planned sky's cubemaps: those of sky.welkin, the same pictures as EXR files, and their error.
#pragma once

#include <vector>

#include "certify/certify.h"
#include "sky/cubemap.h"
#include "sky/cubemap_error.h"
#include "welkin/sky_outputs.h"
#include "welkin/sky_plan.h"

namespace welkin::tools {

/// Those of sky.welkin. `saturated` counts components past their format's largest value. Throws Error(interrupted).
std::vector<sky::Cubemap> renderCubemaps(const sky::SkyFile& file, const SkyPlan& plan, ProgressReport::Style style,
                                         std::size_t& saturated);

/// The same pictures as EXR cubes and latlongs. Throws Error: interrupted; file.
void writeImages(const sky::SkyFile& file, const SkyPlan& plan, SkyOutputs& outputs, ProgressReport::Style style,
                 std::size_t& saturated);

/// The error of the cubemaps as they are in sky.welkin.
sky::CubemapError measureCubemaps(const sky::SkyFile& file, const SkyPlan& plan,
                                  const std::vector<sky::Cubemap>& cubemaps, Certify how, ProgressReport::Style style);

}  // namespace welkin::tools
