// SPDX-License-Identifier: Apache-2.0
// The bake of a sky into a folder: sky.welkin, cubemaps and the record of both; what is up to date stays.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

#include "sky/bake/sky_record.h"
#include "sky/base/progress.h"

namespace welkin::bake {

/// Bakes into `folder`, which is there and locked, and measures what was baked, unless that is there and up to date or
/// `request` says otherwise. `inputs`: everything that was read, for the report: the sky's, and a level's. Returns the
/// report, which is the same either way; `timing` gets what each part cost in seconds, and "sky_baked". Throws Error,
/// before anything is written when a budget cannot be met.
nlohmann::ordered_json bakeSky(const SkyFile& file, const std::vector<Input>& inputs,
                               const std::filesystem::path& folder, const SkyRequest& request,
                               const base::Progress& progress, nlohmann::ordered_json& timing);

}  // namespace welkin::bake
