// SPDX-License-Identifier: Apache-2.0
// The picture of a report, texel by texel: its colours, outlines and the height of its bars.
#include "calibrate/chart_picture.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "picture/digits.h"
#include "sh/deterministic.h"
#include "synthetic_chart.h"

using namespace welkin;
using namespace welkin::calibrate;

namespace {

struct Drawn {
  image::Image image;

  explicit Drawn(const std::string& png)
      : image(image::readImage("report.png", std::as_bytes(std::span(png.data(), png.size())), {})) {}

  /// Codes of 8 bits at a place.
  std::array<int, 3> at(double x, double y) const {
    const auto i =
        3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x));
    std::array<int, 3> code;
    for (std::size_t c = 0; c < 3; ++c)
      code[c] = static_cast<int>(std::lround(255.0 * det::srgbEncode(double{image.rgb[i + c]})));
    return code;
  }
};

std::array<int, 3> codesOf(const Colour& rgb) {
  std::array<int, 3> code;
  for (std::size_t c = 0; c < 3; ++c)
    code[c] = static_cast<int>(std::lround(255.0 * det::srgbEncode(std::clamp(rgb[static_cast<int>(c)], 0.0, 1.0))));
  return code;
}

constexpr std::array<int, 3> kWhite = {255, 255, 255};

/// Every patch but the third is used; the k-th used one has the errors 0.1 k, 0.2 k and 0.3 k.
DrawnChart chartOf(const ReferenceChart& reference) {
  DrawnChart chart;
  chart.patches = tests::seenPatches(reference, {tests::leakyMatrix()});
  chart.model = {modelNamed("3x3"), {0.5, 0, 0, 0, 0.25, 0, 0, 0, 1}};
  for (std::size_t i = 0; i < kPatches; ++i) {
    if (i == 2) continue;
    const auto k = static_cast<double>(chart.used.size());
    chart.used.push_back(i);
    chart.after.push_back(0.1 * k);
    chart.left_out.push_back(0.2 * k);
    chart.before.push_back(0.3 * k);
  }
  return chart;
}

}  // namespace

TEST_CASE("ReportPicture, ShowsThePatchesBesideTheWantedOnes") {
  const ReferenceChart reference = referenceChart(Edition::after_2014);
  const tests::Scene scene;
  const image::Image photo = photograph(reference, scene, {});
  const DrawnChart chart = chartOf(reference);
  const Drawn drawn(drawReport(photo, {*ChartPlace::of(scene.corners)}, chart, reference));
  REQUIRE(drawn.image.width == kPictureWidth);
  REQUIRE(drawn.image.height == kPictureHeight);
  for (std::size_t i = 0; i < kPatches; ++i) {
    INFO(patchName(i));
    const Box cell = cellOf(i);
    const double y = cell.y + 0.1 * cell.height;
    CHECK(drawn.at(cell.x + 0.25 * cell.width, y) == codesOf(chart.patches[i].mean));
    CHECK(drawn.at(cell.x + 0.5 * cell.width, y) == codesOf(chart.model(chart.patches[i].mean)));
    CHECK(drawn.at(cell.x + 0.8 * cell.width, y) == codesOf(reference[i]));
    const bool crossed =
        drawn.at(cell.x + 0.5 * cell.width, cell.y + 0.5 * cell.height) != codesOf(chart.model(chart.patches[i].mean));
    CHECK(crossed == (i == 2));
  }
}

TEST_CASE("ReportPicture, OutlinesEveryChartOverThePhotograph") {
  const ReferenceChart reference = referenceChart(Edition::after_2014);
  const auto [left, right, photo] = tests::photographTwo(reference, {}, {});
  const Drawn drawn(drawReport(photo, {*ChartPlace::of(left.corners), *ChartPlace::of(right.corners)},
                               chartOf(reference), reference));
  const Box box = photoBox(photo.width, photo.height);
  CHECK(box.width / box.height == Approx(640.0 / 480.0));
  const double scale = box.width / photo.width;
  const auto shown = [&](double x, double y) { return drawn.at(box.x + scale * x, box.y + scale * y); };
  CHECK(shown(165.0, 320.0) == std::array<int, 3>{0, 114, 178});  // Okabe and Ito's blue on the lower edge
  CHECK(shown(475.0, 320.0) == std::array<int, 3>{213, 94, 0});   // and vermilion
  const ChartPlace place = *ChartPlace::of(left.corners);
  for (const std::size_t i : {0U, 7U, 18U, 23U}) {
    const Point at = place.pixelOf(i, 0.5, 0.5);
    const std::array<int, 3> found = shown(at.x(), at.y()), wanted = codesOf(reference[i]);
    for (std::size_t c = 0; c < 3; ++c) CHECK(std::abs(found[c] - wanted[c]) <= 1);  // read, encoded and scaled
  }
  CHECK(drawn.at(box.x - 3.0, box.y + 3.0) == kWhite);
}

TEST_CASE("ReportPicture, BarsAreAsHighAsTheErrors") {
  const ReferenceChart reference = referenceChart(Edition::after_2014);
  const tests::Scene scene;
  DrawnChart chart = chartOf(reference);
  CHECK(errorRange(chart) == 10.0);  // holds 6.6
  const Drawn drawn(drawReport(photograph(reference, scene, {}), {*ChartPlace::of(scene.corners)}, chart, reference));
  const auto rows = [&](double x, const Box& bar, const std::array<int, 3>& colour) {
    int count = 0;
    for (double y = bar.y; y < bar.y + bar.height; ++y) count += drawn.at(x, y) == colour ? 1 : 0;
    return count;
  };
  constexpr double kEdges = 2.0;  // rows that the bar's top and the dash share with others
  for (const std::size_t k : {5U, 12U, 22U}) {
    INFO(k);
    const Box bar = barOf(chart.used[k]);
    CHECK(rows(bar.x + 0.5 * bar.width, bar, {0, 114, 178}) == Approx(bar.height * 0.01 * k).margin(kEdges));
    CHECK(rows(bar.x + 0.1 * bar.width, bar, {86, 180, 233}) == Approx(bar.height * 0.02 * k).margin(kEdges));
    CHECK(drawn.at(bar.x + 0.1 * bar.width, bar.y + bar.height * (1.0 - 0.03 * k)) == std::array<int, 3>{33, 33, 33});
  }
  CHECK(rows(barOf(2).x + 0.5 * barOf(2).width, barOf(2), {0, 114, 178}) == 0);
  chart.before.back() = 10.5;
  CHECK(errorRange(chart) == 20.0);
}

TEST_CASE("Digits, SegmentsOfEveryNumberDiffer") {
  constexpr std::array<std::size_t, 10> kSegments = {6, 2, 5, 5, 4, 5, 6, 3, 7, 6};
  for (std::size_t i = 0; i < 10; ++i)
    CHECK(picture::linesOf(std::to_string(i), {0.0, 0.0}, 10.0).size() == kSegments[i]);
  const auto seven = picture::linesOf("7", {3.0, 4.0}, 10.0);
  for (const auto& line : seven) {  // the top and the right side
    const bool is_top = line[0].y == 4.0 && line[1].y == 4.0, is_right = line[0].x == 8.0 && line[1].x == 8.0;
    CHECK((is_top || is_right));
  }
  CHECK(picture::widthOf("2.5", 10.0) == Approx(5.0 + 2.5 + 1.0 + 2.5 + 5.0));
  CHECK(picture::widthOf("", 10.0) == 0.0);
}
