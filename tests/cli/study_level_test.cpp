// SPDX-License-Identifier: Apache-2.0
// welkin study of a level: its rows beside bakes of the same level.
#include <catch2/catch.hpp>

#include "level_text.h"

using namespace welkin::tests;
using nlohmann::json;

TEST_CASE("StudyLevel, RowsHaveTheBytesOfBakesAndTheChartIsDrawn") {
  const SmallLevel level;
  const Run run = runTool({"study", level / "level.toml", "-o", level / "study", "--quick", "--progress", "none"});
  CAPTURE(run.err);
  REQUIRE(run.status == 0);
  const json rows = json::parse(readBytes(level / "study/level.json"))["rows"];
  REQUIRE(rows.size() == 3);
  CHECK(rows[0]["way"] == "distances x 2.8");
  CHECK(rows[1]["way"] == "distances x 1");
  CHECK(rows[2]["way"] == "without fit");
  REQUIRE(level.bake("out") == 4);
  std::size_t bytes = 0, probes = 0;
  const json report = json::parse(readBytes(level / "out/report.json"));
  for (const json& sector : report["sectors"]) {
    bytes += sector["bytes"].get<std::size_t>();
    probes += sector["probes"].get<std::size_t>();
  }
  CHECK(rows[1]["bytes"] == bytes);
  CHECK(rows[1]["probes"] == probes);
  CHECK(rows[0]["probes"] < rows[1]["probes"]);
  for (const json& row : rows)
    for (const char* error : {"surface_total", "surface_sky", "air_total"}) {
      CHECK(row[error].get<double>() > 0.0);
      CHECK(row[error].get<double>() < 1.0);
    }
  CHECK(rows[1]["surface_total"] < rows[2]["surface_total"]);  // the fit is of surfaces
  CHECK(readBytes(level / "study/level.png").substr(1, 3) == "PNG");
  CHECK(readBytes(level / "study/conclusion.md").find("The fit takes the error on surfaces from ") !=
        std::string::npos);
}

TEST_CASE("StudyLevel, ATargetIsOfASkyAlone") {
  const SmallLevel level;
  const Run run = runTool({"study", level / "level.toml", "-o", level / "study", "--target", "unity"});
  CHECK(run.status == 1);
  CHECK(run.said("--target: is of the study of a sky"));
}
