// SPDX-License-Identifier: Apache-2.0
// What the panels say, in numbers.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "view/session.h"

namespace welkin::view {

nlohmann::ordered_json stateJson(Session& session);

/// Writes it to a file, whole or not at all. Throws Error(file).
void writeState(Session& session, const std::string& path);

}  // namespace welkin::view
