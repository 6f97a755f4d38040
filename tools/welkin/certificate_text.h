// SPDX-License-Identifier: Apache-2.0
// The certificate for report.json, and the line that a bake says about it.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "sky/certificate.h"
#include "sky/cubemap_error.h"

namespace welkin::tools {

/// `cubemaps`: none when there are no cubemaps.
nlohmann::ordered_json certificateJson(const sky::Certificate& certificate,
                                       const std::optional<sky::CubemapError>& cubemaps);

/// What certificateJson made, for people, in one line.
std::string certificateText(const nlohmann::ordered_json& certificate);

}  // namespace welkin::tools
