// SPDX-License-Identifier: Apache-2.0
// The folder that a study writes.
#include "study/report.h"

#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "sky/base/error.h"
#include "tests/folder.h"

namespace welkin::study {
namespace {

StudyReport sampleReport() {
  Table table({{"bands", ""}, {"error", "of 1", Quantity::share}});
  table.addRow({2.0, 0.4});
  table.addRow({3.0, 0.12});
  const Chart chart = {.title = "Bands",
                       .x = {"bands"},
                       .y = {"error", Quantity::share, Scale::log},
                       .series = {{"clear sky", SeriesStyle::line, {{2.0, 0.4}, {3.0, 0.12}}}}};
  return {"A study",
          {"Take three bands."},
          {{"bands", chart}},
          {{"bands", "Bands", table}, {"more", "More", table, false}}};
}

TEST_CASE("WriteReport, WritesEveryFile") {
  const tests::Folder folder;
  CHECK(writeReport(sampleReport(), folder / "out") == 0);
  CHECK(tests::filesUnder(folder / "out") == std::vector<std::string>{"bands.csv", "bands.json", "bands.png",
                                                                      "bands.svg", "conclusion.md", "more.csv",
                                                                      "more.json"});
  CHECK(tests::readBytes(folder / "out/bands.csv") == "bands,error (of 1)\r\n2,0.4\r\n3,0.12\r\n");
  CHECK(nlohmann::ordered_json::parse(tests::readBytes(folder / "out/bands.json"))["rows"][1]["error"] == 0.12);
  CHECK(tests::readBytes(folder / "out/conclusion.md") ==
        "# A study\n\nTake three bands.\n\n![Bands](bands.png)\n\n## Bands\n\n| bands | error |\n|---:|---:|\n"
        "| 2 | 40 % |\n| 3 | 12 % |\n\nAll figures: [bands.csv](bands.csv), [bands.json](bands.json)\n\n## More\n\n"
        "All figures: [more.csv](more.csv), [more.json](more.json)\n");
}

TEST_CASE("WriteReport, WithoutGnuplotLeavesOutChartsAndSaysSo") {
  const tests::Folder folder;
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", (folder / "empty").c_str(), 1);
  const std::size_t left_out = writeReport(sampleReport(), folder / "out");
  ::setenv("PATH", path.c_str(), 1);
  CHECK(left_out == 1);
  CHECK(tests::filesUnder(folder / "out") ==
        std::vector<std::string>{"bands.csv", "bands.json", "conclusion.md", "more.csv", "more.json"});
  const std::string conclusion = tests::readBytes(folder / "out/conclusion.md");
  CHECK(conclusion.find("\n1 charts were left out: gnuplot is not installed.\n") != std::string::npos);
  CHECK(conclusion.find(".png") == std::string::npos);
}

TEST_CASE("WriteReport, RefusesBeforeItWrites") {
  const tests::Folder folder;
  for (const char* name : {"", "../out", "a b", "more"}) {
    StudyReport report = sampleReport();
    report.tables[0].name = name;
    CHECK_THROWS_AS(writeReport(report, folder / "out"), base::Error);
  }
  StudyReport report = sampleReport();
  report.charts[0].chart.series.clear();
  CHECK_THROWS_AS(writeReport(report, folder / "out"), base::Error);
  CHECK_FALSE(std::filesystem::exists(folder / "out"));
}

}  // namespace
}  // namespace welkin::study
