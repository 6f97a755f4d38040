// SPDX-License-Identifier: Apache-2.0
// A baked sky as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <welkin/welkin.hpp>

namespace welkin::command {

/// Everything in a baked sky: members "sky" and "settings".
nlohmann::ordered_json skyJson(const Sky& sky);

}  // namespace welkin::command
