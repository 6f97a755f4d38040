// SPDX-License-Identifier: Apache-2.0
// The lines that a bake says about its report.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace welkin::command {

/// The certificate of a report, for people, in one line.
std::string certificateText(const nlohmann::ordered_json& certificate);

/// The warnings of a report as lines on stderr.
void printWarnings(const nlohmann::ordered_json& list);

}  // namespace welkin::command
