// SPDX-License-Identifier: Apache-2.0
// The bake of a sky into a folder: sky.welkin, cubemaps, report and timing.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "certify/certify.h"
#include "sky/sky_file.h"
#include "welkin/progress.h"

namespace welkin::tools {

/// File name of the cubemap of a time, without suffix: sky_HHMMSSmmm, to the nearest millisecond.
std::string cubemapName(double time_h);

/// Bakes into `folder` and measures what was baked. Returns the report; `timing` gets what each part cost in seconds.
/// Throws Error, before anything is written when a budget cannot be met.
nlohmann::ordered_json bakeSky(const sky::SkyFile& file, const std::filesystem::path& folder, Certify certify,
                               ProgressReport::Style style, nlohmann::ordered_json& timing);

}  // namespace welkin::tools
