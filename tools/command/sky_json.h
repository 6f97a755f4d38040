// SPDX-License-Identifier: Apache-2.0
// A baked sky as JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <welkin/welkin.hpp>

namespace welkin::command {

/// Everything in a baked sky: members "sky" and "settings".
nlohmann::ordered_json skyJson(const Sky& sky);

/// The settings of a .welkin file. Throws Error(content) if they are not JSON, as in early files that name a picture
/// with a character past U+FFFF.
nlohmann::ordered_json settingsJson(const std::string& text);

}  // namespace welkin::command
