// SPDX-License-Identifier: Apache-2.0
// The certificate for report.json, and the line that a bake says about it.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "sky/cubemap/cubemap_error.h"
#include "sky/table/certificate.h"

namespace welkin::command {

/// `cubemaps`: none when there are no cubemaps.
nlohmann::ordered_json certificateJson(const table::Certificate& certificate,
                                       const std::optional<cubemap::CubemapError>& cubemaps);

/// What certificateJson made, for people, in one line.
std::string certificateText(const nlohmann::ordered_json& certificate);

}  // namespace welkin::command
