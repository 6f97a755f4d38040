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
