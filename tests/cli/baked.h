// SPDX-License-Identifier: Apache-2.0
// Runs bakes of the tool and reads their reports.
#pragma once

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "run_tool.h"
#include "sky_text.h"

namespace welkin::tests {

/// A day with two dusks, a night, and shades of grey.
inline const std::string kDay = "luminance = \"cie-12\"\nnormalise = \"sun\"";
inline const std::string kDaySun = "path = [[0, 0, -40], [6, 90, 0], [12, 180, 55], [18, 270, 0]]";

/// Runs `welkin bake FILE -o FOLDER`, silent except for its final output.
inline Run runBake(const std::string& sky, const std::string& folder, const std::vector<std::string>& more = {}) {
  std::vector<std::string> arguments = {"bake", sky, "-o", folder, "--progress", "none"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return runTool(arguments);
}

/// The report of a bake that must succeed.
inline nlohmann::json bakeReport(const std::string& sky, const std::string& folder,
                                 const std::vector<std::string>& more = {}) {
  const Run run = runBake(sky, folder, more);
  INFO(run.err);
  REQUIRE(run.status == 0);
  return nlohmann::json::parse(readBytes(folder + "/report.json"));
}

/// The JSON printed by a command that must succeed.
inline nlohmann::json printedJson(const std::vector<std::string>& arguments) {
  const Run run = runTool(arguments);
  INFO(run.err);
  REQUIRE(run.status == 0);
  return nlohmann::json::parse(run.out);
}

}  // namespace welkin::tests
