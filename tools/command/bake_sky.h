// SPDX-License-Identifier: Apache-2.0
// The bake of a sky into a folder: sky.welkin, cubemaps and the record of both; what is up to date stays.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

#include "command/progress.h"
#include "command/sky_record.h"
#include "command/subject.h"

namespace welkin::command {

/// Bakes into `folder` and measures what was baked, unless that is there and up to date or `request` says otherwise.
/// Returns the report, which is the same either way; `timing` gets what each part cost in seconds, and "sky_baked".
/// Throws Error, before anything is written when a budget cannot be met.
nlohmann::ordered_json bakeSky(const Subject& subject, const std::filesystem::path& folder, const SkyRequest& request,
                               ProgressReport::Style style, nlohmann::ordered_json& timing);

}  // namespace welkin::command
