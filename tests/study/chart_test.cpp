// SPDX-License-Identifier: Apache-2.0
// Pictures of charts by gnuplot: whole, the same every time, and left out where there is no gnuplot.
#include "study/chart.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <regex>

#include "sky/base/error.h"
#include "sky/image/image.h"
#include "study/gnuplot.h"
#include "tests/folder.h"

namespace welkin::study {
namespace {

Chart sampleChart() {
  Chart chart = {.title = "Bytes against error",
                 .x = {"bytes", Quantity::bytes, Scale::log},
                 .y = {"worst error", Quantity::share, Scale::log},
                 .series = {},
                 .lines = {{0.1, "10 %"}, {0.03, "3 %"}, {0.01, "1 %"}, {0.003, "0.3 %"}}};
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

ChartPictures draw(const Chart& chart) {
  std::optional<ChartPictures> pictures = drawChart(chart);
  REQUIRE(pictures);
  return *pictures;
}

unsigned bigEndianAt(const std::string& bytes, std::size_t at) {
  unsigned value = 0;
  for (std::size_t i = at; i < at + 4; ++i) value = value << 8U | static_cast<unsigned char>(bytes[i]);
  return value;
}

TEST_CASE("Chart, SameBytesEveryTime") {
  const ChartPictures first = draw(sampleChart());
  const ChartPictures second = draw(sampleChart());
  CHECK((first.svg == second.svg));  // in brackets: a failure does not print the pictures
  CHECK((first.png == second.png));
  Chart other = sampleChart();
  other.series[0].points[0].y *= 1.5;
  CHECK((draw(other).svg != first.svg));
}

TEST_CASE("Chart, SizeAndKind") {
  const ChartPictures pictures = draw(sampleChart());
  CHECK(pictures.png.substr(1, 3) == "PNG");
  CHECK(bigEndianAt(pictures.png, 16) == kChartWidth);
  CHECK(bigEndianAt(pictures.png, 20) == kChartHeight);
  CHECK(std::regex_search(pictures.svg.substr(0, 400), std::regex("width=\"960\" height=\"600\"")));
}

TEST_CASE("Chart, NamesNoDay") {
  const ChartPictures pictures = draw(sampleChart());
  for (const char* word : {"tIME", "tEXt", "iTXt", "zTXt"}) CHECK_FALSE(pictures.png.find(word) != std::string::npos);
  CHECK_FALSE(std::regex_search(pictures.svg, std::regex("20[0-9][0-9]-[0-9][0-9]|<metadata")));
}

TEST_CASE("Chart, ShowsEveryWordOnce") {
  Chart chart = sampleChart();
  chart.series[0].name = "it's `date`, a \\ and a name of many words that is broken into lines";
  const std::string svg = draw(chart).svg;
  for (const char* word : {"Bytes against error", "worst error", ">bytes<", "3 bands", "Pareto front", "0.3 %", "10 KB",
                           "`date`", "into lines"}) {
    INFO(word);
    CHECK(svg.find(word) != std::string::npos);
  }
  for (const ReferenceLine& line : chart.lines) CHECK(svg.find(line.label) != std::string::npos);
}

struct Pixel {
  double x, y;
};

/// Where the SVG puts the first thing whose element begins after a translation and matches `element`.
Pixel placeOf(const std::string& svg, const std::string& before, const std::string& element) {
  std::smatch match;
  const std::string place = "translate\\(([0-9.]+),([0-9.]+)\\)";
  REQUIRE(std::regex_search(svg, match, std::regex(before + place + element)));
  return {std::stod(match[1]), std::stod(match[2])};
}

TEST_CASE("Chart, LabelsLieBesideTheirPointsAndOffTheLine") {
  constexpr double kNearest = 5.0;  // pixels, the marker's radius
  constexpr double kFurthest = 30.0;
  for (const bool rising : {false, true}) {
    Chart chart{"A line", {"x"}, {"y"}, {{"line", SeriesStyle::line, {{0.0, 1.0}, {1.0, 2.0, "label"}, {2.0, 3.0}}}}};
    if (!rising) std::swap(chart.series[0].points[0].y, chart.series[0].points[2].y);
    const std::string svg = draw(chart).svg;
    const Pixel label = placeOf(svg, "<g transform=\"", "\"[^>]*>\\s*<text>label<");
    const Pixel first = placeOf(svg, "gpPt6' transform='", "");
    std::string rest = svg;
    Pixel second = first;
    while (second.x == first.x) {
      rest = rest.substr(rest.find("gpPt6' transform='") + 1);
      second = placeOf(rest, "gpPt6' transform='", "");
    }
    INFO(rising << ": " << label.x << ' ' << label.y << " at " << second.x << ' ' << second.y);
    const double x = label.x - second.x;
    const double y = second.y - label.y;  // upwards
    CHECK(std::hypot(x, y) > kNearest);
    CHECK(std::hypot(x, y) < kFurthest);
    CHECK(x > 0.0);
    CHECK((y > 0.0) == !rising);  // above a line that falls, and below one that rises
  }
}

constexpr float kWhite = 0.999F;  // of 8 bits the last step is 0.009 in linear light

/// Whether the outermost pixels are white, as they are where nothing is cut.
bool isWhiteAround(const std::string& png) {
  const tests::Folder folder;
  const image::Image image = image::readImage(folder.write("chart.png", png));
  const auto isWhite = [&](int column, int row) {
    const std::size_t at = 3 * (static_cast<std::size_t>(row) * kChartWidth + static_cast<std::size_t>(column));
    return std::min({image.rgb[at], image.rgb[at + 1], image.rgb[at + 2]}) > kWhite;
  };
  for (int x = 0; x < kChartWidth; ++x)
    if (!isWhite(x, 0) || !isWhite(x, kChartHeight - 1)) return false;
  for (int y = 0; y < kChartHeight; ++y)
    if (!isWhite(0, y) || !isWhite(kChartWidth - 1, y)) return false;
  return true;
}

TEST_CASE("Chart, NothingIsCut") {
  Chart wordy = sampleChart();
  for (int i = 0; i < 20; ++i)
    for (std::string* title : {&wordy.title, &wordy.x.title, &wordy.y.title}) *title += ", and words";
  wordy.series[0].name = "a name of many words that has to be broken into lines to fit beside the frame at all";
  wordy.series[4].points[1].label = "a label that is long, of a point in the lower right corner";
  wordy.lines.push_back({0.0029, "and a line with words"});
  Chart many = sampleChart();
  while (many.series.size() < kMostSeries) many.series.push_back(wordy.series[1]);
  for (const Chart& chart : {sampleChart(), wordy, many}) {
    INFO(chart.title << ": " << chart.series.size());
    CHECK(isWhiteAround(draw(chart).png));
  }
}

TEST_CASE("Chart, RefusesWhatItCannotShow") {
  Chart chart = sampleChart();
  chart.series[1].points[0].y = std::nan("");
  CHECK_THROWS_WITH(drawChart(chart), Catch::Contains("'worst error'"));
  chart.series[1].points[0].y = -0.1;
  CHECK_THROWS_AS(drawChart(chart), base::Error);
  chart = sampleChart();
  chart.series.resize(kMostSeries + 1, chart.series[0]);
  CHECK_THROWS_AS(drawChart(chart), base::Error);
  chart = sampleChart();
  chart.series.clear();
  CHECK_THROWS_AS(drawChart(chart), base::Error);
}

/// Another PATH while it lives.
class SearchPath {
 public:
  explicit SearchPath(const std::string& path) : before_(std::getenv("PATH")) { ::setenv("PATH", path.c_str(), 1); }
  ~SearchPath() { ::setenv("PATH", before_.c_str(), 1); }

 private:
  std::string before_;
};

/// A program of the shell that stands for gnuplot.
std::string programIn(const tests::Folder& folder, const std::string& text) {
  const std::string file = folder.write("gnuplot", "#!/bin/sh\n" + text);
  std::filesystem::permissions(file, std::filesystem::perms::owner_all);
  return std::filesystem::path(file).parent_path().string();
}

TEST_CASE("Chart, IsLeftOutWithoutGnuplot") {
  const tests::Folder folder;
  const SearchPath path(folder / "empty");
  CHECK_FALSE(drawChart(sampleChart()));
}

TEST_CASE("Chart, AFailingGnuplotIsOneError") {
  CHECK_THROWS_WITH(runGnuplot("plot nonsense\n"),
                    Catch::Contains("gnuplot: status 1: ") && Catch::Contains("nonsense"));
  const tests::Folder folder;
  {
    const SearchPath path(programIn(folder, "kill -9 $$\n"));
    CHECK_THROWS_WITH(runGnuplot(""), "gnuplot: ended by signal 9");
  }
  {
    const SearchPath path(programIn(folder, "echo '<svg>'\n"));  // as on a full disk
    CHECK_THROWS_WITH(drawChart(sampleChart()), Catch::Contains("'Bytes against error' is cut"));
  }
}

}  // namespace
}  // namespace welkin::study
