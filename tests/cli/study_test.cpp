// SPDX-License-Identifier: Apache-2.0
// welkin study: a folder of measurements from a sky file, and how it ends on bad ones.
#include <algorithm>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "run_tool.h"
#include "sky_text.h"

using namespace welkin::tests;

TEST_CASE("Study, WritesAFolderAndSaysWhatItFound") {
  const Folder folder;
  const std::string sky =
      folder.write("sky.toml", skyText("luminance = \"cie-12\"", "path = [[0, 0, -30], [12, 180, 50]]"));
  const Run run = runTool({"study", sky, "-o", folder / "out", "--quick", "--progress", "none"});
  INFO(run.err);
  REQUIRE(run.status == 0);
  CHECK(run.out.find("Within 1 % the least is ") != std::string::npos);
  CHECK(run.err.empty());
  const auto budgets = nlohmann::json::parse(readBytes(folder / "out/budgets.json"));
  REQUIRE(budgets["rows"].size() == 3);
  for (const auto& row : budgets["rows"]) CHECK(row["predicted_error"].get<double>() <= row["max_error"].get<double>());
  CHECK(readBytes(folder / "out/conclusion.md").find(run.out.substr(0, run.out.find('\n'))) != std::string::npos);
  CHECK(readBytes(folder / "out/pareto.png").substr(1, 3) == "PNG");
}

TEST_CASE("Study, OfATargetHasWhatItReadsAlone") {
  const Folder folder;
  const std::string path = "path = [[0, 0, -30], [12, 180, 50]]";
  const std::string sky = folder.write("sky.toml", skyText("luminance = \"cie-12\"", path));
  const std::string named = folder.write("named.toml", skyText("luminance = \"cie-12\"", path, "target = \"sh2\""));
  const auto rowsOf = [&](const std::string& file, const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"study", file, "-o", folder / "out", "--quick", "--progress", "none"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Run run = runTool(arguments);
    INFO(run.err);
    REQUIRE(run.status == 0);
    const std::string conclusion = readBytes(folder / "out/conclusion.md");
    for (const char* target : {"unity", "sh2"}) {
      const bool here = file == named ? more.empty() && target == std::string("sh2") : more.back() == target;
      INFO(target << "\n" << conclusion);
      CHECK((conclusion.find(std::string("as target \"") + target + '"') != std::string::npos) == here);
      CHECK((run.out.find(std::string("Target \"") + target + "\" reads no more than") != std::string::npos) == here);
    }
    return nlohmann::json::parse(readBytes(folder / "out/budgets.json"))["rows"];
  };
  const auto isOfBands = [](const nlohmann::json& row, int most) {
    const std::string name = row["representation"];
    return name.find("modes") == std::string::npos && name.find(" bands") != std::string::npos && name[0] - '0' <= most;
  };
  const auto unity = rowsOf(sky, {"--target", "unity"});
  const auto sh2 = rowsOf(named, {});
  const auto modes = rowsOf(named, {"--target", "modes"});  // the option replaces the file's target
  REQUIRE(unity.size() == 3);
  for (std::size_t i = 0; i < unity.size(); ++i) {
    CHECK(isOfBands(unity[i], 3));
    CHECK(isOfBands(sh2[i], 2));
    CHECK(modes[i]["met"] == "yes");
  }
  CHECK(unity.back()["met"] == "no");  // 1 % needs modes, or more bands
  CHECK(unity.back()["predicted_error"].get<double>() < 0.2);
  CHECK(sh2.back()["predicted_error"] > unity.back()["predicted_error"]);
  const Run refused = runTool({"study", sky, "-o", folder / "none", "--target", "lumen"});
  CHECK(refused.status == 1);
  CHECK(refused.said("--target"));
}

TEST_CASE("Study, WithoutGnuplotHasTablesAndWarnsOnce") {
  const Folder folder;
  const std::string sky = folder.write("sky.toml", skyText(kUniform));
  Setting setting;
  setting.environment = {{"PATH", folder / "empty"}};
  const Run run = runTool({"study", sky, "-o", folder / "out", "--quick", "--progress", "none"}, setting);
  INFO(run.err);
  REQUIRE(run.status == 0);
  const auto files = filesUnder(folder / "out");
  const auto charts = std::ranges::count_if(
      files, [](const std::string& name) { return !name.ends_with(".csv") && !name.ends_with(".json"); });
  CHECK(charts == 1);  // conclusion.md
  CHECK(files.size() > 20);
  CHECK(run.err == "welkin: warning: 8 charts are left out: gnuplot is not installed\n");
}

TEST_CASE("Study, SkiesThatNeverChangeAndBlackOnesAreStudiedToo") {
  const Folder folder;
  for (const std::string& keys : {kUniform, kUniform + "\nintensity = 0"}) {
    const std::string sky = folder.write("sky.toml", skyText(keys));
    const Run run = runTool({"study", sky, "-o", folder / "out", "--quick", "--progress", "none"});
    INFO(keys << "\n" << run.err);
    CHECK(run.status == 0);
    CHECK(run.out.find("nan") == std::string::npos);
  }
}

TEST_CASE("Study, BadInputHasItsStatus") {
  const Folder folder;
  CHECK(runTool({"study"}).status == 1);
  CHECK(runTool({"study", "sky.toml"}).status == 1);
  CHECK(runTool({"study", folder / "none.toml", "-o", folder / "out"}).status == 2);
  const std::string broken = folder.write("broken.toml", "[sky\n");
  CHECK(runTool({"study", broken, "-o", folder / "out"}).status == 3);
  const std::string sky = folder.write("sky.toml", skyText(kUniform));
  const std::string file = folder.write("file", "");
  const Run run = runTool({"study", sky, "-o", file + "/out"});
  INFO(run.err);
  CHECK(run.status == 2);
  CHECK(run.said(file));
}
