// SPDX-License-Identifier: Apache-2.0
// Lines for people about a bake's report.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace welkin::command {

/// The certificate of a report in one line.
std::string certificateText(const nlohmann::ordered_json& certificate);

/// Prints the warnings of a report to stderr, one per line.
void printWarnings(const nlohmann::ordered_json& list);

}  // namespace welkin::command
