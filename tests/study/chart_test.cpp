// SPDX-License-Identifier: Apache-2.0
// Pictures of charts: whole, legible in their pixels, the same every time.
#include "study/chart.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <regex>

#include "sky/base/error.h"

namespace welkin::study {
namespace {

Chart sample() {
  Chart chart = {.title = "Bytes against error",
                 .x = {"bytes", Quantity::bytes, Scale::log},
                 .y = {"worst error", Quantity::share, Scale::log},
                 .series = {},
                 .levels = {{0.1, "10 %"}, {0.03, "3 %"}, {0.01, "1 %"}, {0.003, "0.3 %"}}};
  for (int bands = 2; bands <= 5; ++bands) {
    Series series = {std::to_string(bands) + " bands", SeriesStyle::line, {}};
    for (const double keys : {12.0, 48.0, 288.0}) {
      series.points.push_back({keys * bands * bands * 12.0, 1.0 / keys + 1.0 / std::pow(3.0, bands), ""});
    }
    chart.series.push_back(series);
  }
  chart.series.push_back(
      {"Pareto front", SeriesStyle::front, {{576.0, 0.19, "2 bands"}, {50000.0, 0.0076, "5 bands"}}});
  return chart;
}

unsigned bigEndianAt(const std::string& bytes, std::size_t at) {
  unsigned value = 0;
  for (std::size_t i = at; i < at + 4; ++i) value = value << 8U | static_cast<unsigned char>(bytes[i]);
  return value;
}

TEST_CASE("Chart, SameBytesEveryTime") {
  const ChartPictures first = drawChart(sample());
  const ChartPictures second = drawChart(sample());
  CHECK((first.svg == second.svg));  // in brackets: a failure does not print the pictures
  CHECK((first.png == second.png));
  Chart other = sample();
  other.series[0].points[0].y *= 1.5;
  CHECK((drawChart(other).svg != first.svg));
}

TEST_CASE("Chart, SizeAndKind") {
  const ChartPictures pictures = drawChart(sample());
  CHECK(pictures.png.substr(1, 3) == "PNG");
  CHECK(bigEndianAt(pictures.png, 16) == kChartWidth);
  CHECK(bigEndianAt(pictures.png, 20) == kChartHeight);
  CHECK(std::regex_search(pictures.svg.substr(0, 400), std::regex("width=\"960px\" height=\"600px\"")));
}

TEST_CASE("Chart, NamesNoDayAndNoProgram") {
  const ChartPictures pictures = drawChart(sample());
  for (const char* word : {"tIME", "tEXt", "iTXt", "zTXt"}) CHECK_FALSE(pictures.png.find(word) != std::string::npos);
  CHECK_FALSE(std::regex_search(pictures.svg, std::regex("20[0-9][0-9]-[0-9][0-9]|[Cc]airo|<metadata")));
}

TEST_CASE("Chart, BudgetsAreHorizontalLines") {
  const std::string svg = drawChart(sample()).svg;
  const std::regex dashed("stroke-dasharray:5,4[^>]*d=\"([^\"]*)\"");
  const std::regex horizontal("M [0-9.]+ ([0-9.]+) L [0-9.]+ ([0-9.]+) ");
  int count = 0;
  for (std::sregex_iterator path(svg.begin(), svg.end(), dashed); path != std::sregex_iterator(); ++path, ++count) {
    const std::string corners = (*path)[1];
    std::smatch match;
    REQUIRE(std::regex_match(corners, match, horizontal));  // two corners: words before it leave no third
    CHECK(match[1] == match[2]);
  }
  CHECK(count == 4);
}

TEST_CASE("Chart, NothingIsCut") {
  Chart wordy = sample();
  wordy.title = std::string(200, 'W');
  wordy.x.title = std::string(150, 'W');
  wordy.y.title = std::string(150, 'W');
  wordy.series[0].name = "a name of many words that has to be broken into lines to fit beside the frame at all";
  wordy.series[4].points[1].label = "a label that is long, of a point in the lower right corner";
  wordy.levels.push_back({0.0029, "and a level with words"});
  Chart many = sample();
  while (many.series.size() < kMostSeries) many.series.push_back(wordy.series[0]);
  for (const Chart& chart : {sample(), wordy, many}) {
    const ChartPictures pictures = drawChart(chart);
    CHECK(pictures.ink_x.low >= 0.0);
    CHECK(pictures.ink_y.low >= 0.0);
    CHECK(pictures.ink_x.high <= kChartWidth);
    CHECK(pictures.ink_y.high <= kChartHeight);
  }
}

TEST_CASE("Chart, RefusesWhatItCannotShow") {
  Chart chart = sample();
  chart.series[1].points[0].y = std::nan("");
  CHECK_THROWS_WITH(drawChart(chart), Catch::Contains("'worst error'"));
  chart.series[1].points[0].y = -0.1;
  CHECK_THROWS_AS(drawChart(chart), base::Error);
  chart = sample();
  chart.series.resize(kMostSeries + 1, chart.series[0]);
  CHECK_THROWS_AS(drawChart(chart), base::Error);
  chart = sample();
  chart.series.clear();
  CHECK_THROWS_AS(drawChart(chart), base::Error);
}

}  // namespace
}  // namespace welkin::study
