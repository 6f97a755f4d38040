// SPDX-License-Identifier: Apache-2.0
// Lines for people about a bake's report.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace welkin::command {

/// The certificate of a report in one line.
std::string certificateText(const nlohmann::ordered_json& certificate);

/// The error of a level on its surfaces and in the air, a report's "surfaces", in one line.
std::string surfacesText(const nlohmann::ordered_json& surfaces);

/// The options that lower a report's errors, where these are large and no budget asked for them; else nothing.
std::string remedyText(const nlohmann::ordered_json& report);

/// Prints the certificate of a report to stderr, one line a sky, and one for the blends of a family.
void printCertificates(const nlohmann::ordered_json& report);

/// Prints a warning to stderr, on one line.
void printWarning(const std::string& message);

/// Prints the warnings of a report to stderr, one per line, but for messages that were told before.
void printWarnings(const nlohmann::ordered_json& list, const std::vector<std::string>& told = {});

}  // namespace welkin::command
