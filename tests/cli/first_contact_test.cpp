// SPDX-License-Identifier: Apache-2.0
// The first hour with the tool: every command of README's sections "Bake" and "Look" on what `welkin init` writes,
// budgets that can be had, and skies of other kinds.
#include <catch2/catch.hpp>
#include <fstream>
#include <sstream>
#include <string>

#include "baked.h"

using namespace welkin::tests;
using nlohmann::json;
namespace fs = std::filesystem;

namespace {

/// The folder of a fresh `welkin init`.
std::string freshSky(const Folder& folder) {
  REQUIRE(runTool({"init", folder / "my_sky"}).status == 0);
  return folder / "my_sky/sky.toml";
}

/// The words of each command of README's sections "Bake" and "Look", without "$welkin".
std::vector<std::vector<std::string>> readmeCommands() {
  std::ifstream readme(WELKIN_ROOT "/README.md");
  std::vector<std::vector<std::string>> commands;
  bool inside = false;
  for (std::string line; std::getline(readme, line);) {
    if (line.starts_with("## ")) inside = line == "## Bake" || line == "## Look";
    if (!inside || !line.starts_with("    $welkin ")) continue;
    std::istringstream words(line.substr(0, line.find(" #")));
    std::vector<std::string> command;
    for (std::string word; words >> word;) command.push_back(word);
    command.erase(command.begin());
    commands.push_back(std::move(command));
  }
  return commands;
}

/// A path of README in the test's folder, or among the project's files.
std::string placed(const std::string& word, const Folder& folder) {
  if (word.starts_with("examples/")) return WELKIN_ROOT "/" + word;
  if (word.ends_with(".png") && word.find('/') == std::string::npos) return folder / word;
  const std::string first = word.substr(0, word.find('/'));
  for (const char* name : {"my_sky", "out", "study", "island"})
    if (first == name) return folder / word;
  return word;
}

struct OtherSky {
  const char* name;
  std::string sky, sun;
};
const std::string kPictures = "gradient_sun = \"gradient_sun.png\"\ngradient_anti = \"gradient_anti.png\"\n";

std::vector<OtherSky> otherSkies() {
  const std::string north = "latitude_deg = 52\nday_of_year = 100";
  const std::string drawn = "path = [[0, 0, -40], [6, 90, 0], [12, 180, 55], [18, 270, 0]]";
  return {
      {"white, overcast", "luminance = \"cie-1\"\nnormalise = \"zenith\"", north},
      {"colours, even", "luminance = \"cie-5\"\ngradient_sun = [1, 0.6, 0.3]\ngradient_anti = [0.3, 0.5, 1]", north},
      {"pictures, clear", kPictures + "luminance = \"cie-12\"\nnormalise = \"zenith\"", north},
      {"a picture and a colour, turbid",
       "luminance = \"cie-15\"\ngradient_sun = \"gradient_sun.png\"\ngradient_anti = [0.3, 0.5, 1]", north},
      {"polar day", kPictures + "luminance = \"far-cry-3\"\nground_albedo = [0.8, 0.8, 0.9]",
       "latitude_deg = 80\nday_of_year = 172"},
      {"polar night", kPictures + "luminance = \"cie-7\"", "latitude_deg = 80\nday_of_year = 355"},
      {"a drawn path", kPictures + "luminance = \"cie-9\"", drawn},
      {"a drawn path that stands still", "luminance = [-1, -0.24, 18, -3.2, 0.35]", kStillSun},
      {"the sun in the zenith", kPictures + "luminance = \"far-cry-3\"", "latitude_deg = 0\nday_of_year = 80"}};
}

}  // namespace

TEST_CASE("FirstContact, EveryCommandOfTheReadmeRuns") {
  const Folder folder;
  const auto commands = readmeCommands();
  REQUIRE(commands.size() >= 14);
  for (std::vector<std::string> command : commands) {
    std::string line;
    for (std::size_t i = 1; i < command.size(); ++i) line += (command[i] = placed(command[i], folder)) + " ";
    if (command[0] == "study") command.emplace_back("--quick");  // seconds for minutes
    if (command[0] == "render") command.insert(command.end(), {"--size", "64x36"});
    const Run run =
        runTool(command, {.environment = {}, .out_path = {}, .err_path = {}, .largest_file = 0, .deadline_s = 280.0});
    INFO(line << "\n" << run.err);
    REQUIRE(run.status == 0);
  }
}

TEST_CASE("FirstContact, APlainBakeIsPresentable") {
  const Folder folder;
  const json report = bakeReport(freshSky(folder), folder / "out");
  INFO(report["certificate"].dump());
  REQUIRE(report["certificate"]["max_error"] <= 0.03);
  REQUIRE(report["certificate"]["cubemaps"]["max_error"] <= 0.1);
  REQUIRE(report["cubemaps"]["bytes"] <= 64e6);
}

TEST_CASE("FirstContact, BudgetsThatCanBeHadAreMet") {
  const Folder folder;
  const std::string sky = freshSky(folder);
  for (const double budget : {0.02, 0.012, 0.01}) {
    const json report = bakeReport(sky, folder / "out", {"--max-error", std::to_string(budget), "--cubemaps", "none"});
    INFO(report["certificate"].dump());
    REQUIRE(report["certificate"]["max_error"] <= budget);
    REQUIRE(report["certificate"]["max_error"] > 0.5 * budget);  // and spends no more than needed
    REQUIRE(report["cubemaps"]["count"] == 0);
  }
}

TEST_CASE("FirstContact, OtherSkiesArePlannedAndBaked") {
  const Folder folder;
  freshSky(folder);
  for (const OtherSky& other : otherSkies()) {
    INFO(other.name);
    const std::string sky = folder.write("my_sky/other.toml", skyText(other.sky, other.sun, ""));
    const json plan = printedJson({"plan", sky, "--quality", "preview", "--cubemaps", "none", "--json"});
    REQUIRE(plan["table"]["predicted_error"] <= 0.03);
    const json report = bakeReport(sky, folder / "out", {"--quality", "draft", "--cubemaps", "none"});
    INFO(report["certificate"].dump());
    REQUIRE(report["certificate"]["max_error"] <= 0.1);
  }
}

TEST_CASE("FirstContact, ABadErrorNamesItsRemedy") {
  const Folder folder;
  const std::string sky =
      folder.write("sky.toml", skyText(kDay, kDaySun, "bands = 2\nkeys = 2\ncubemap_size = 8\ncubemap_times = 2"));
  const Run bad = runBake(sky, folder / "out");
  INFO(bad.err);
  REQUIRE(bad.status == 0);
  REQUIRE(bad.said("[bake] with max_error = 0.03"));
  REQUIRE(bad.said("--cubemaps 0.1"));
  REQUIRE(bad.err.find('\n') == bad.err.size() - 1);  // in the one line that a bake ends with
  const Run good = runBake(folder.write("sky.toml", skyText(kUniform)), folder / "out");
  REQUIRE(good.status == 0);
  REQUIRE_FALSE(good.said("max_error = 0.03"));
}
