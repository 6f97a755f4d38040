// SPDX-License-Identifier: Apache-2.0
// The certificate for report.json.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>

#include "sky/cubemap/cubemap_error.h"
#include "sky/table/certificate.h"

namespace welkin::bake {

/// `cubemaps`: none when there are no cubemaps.
nlohmann::ordered_json certificateJson(const table::Certificate& certificate,
                                       const std::optional<cubemap::CubemapError>& cubemaps);

}  // namespace welkin::bake
