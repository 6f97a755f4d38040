// SPDX-License-Identifier: Apache-2.0
// Charts in synthetic photographs: found by OpenCV's detector, judged, measured and calibrated.
#include <Eigen/LU>
#include <catch2/catch.hpp>

#include "calibrate/calibration.h"
#include "calibrate/find_charts.h"
#include "calibrate/judge.h"
#include "synthetic_chart.h"

using namespace welkin;
using namespace welkin::calibrate;
using tests::Camera;
using tests::Scene;

namespace {

const ReferenceChart& wantedChart() {
  static const ReferenceChart kChart = referenceChart(Edition::after_2014);
  return kChart;
}

Judgement found(const image::Image& image) {
  std::vector<Corners> areas;
  for (const Candidate& candidate : findCandidates(image)) areas.push_back(candidate.corners);
  const std::vector<Judgement> charts = judgeAll(image, areas, wantedChart(), clippingLevel(image, false), true);
  REQUIRE(charts.size() == 1);
  return charts[0];
}

/// The farthest corner of the found chart from where it was drawn, in sides of a patch.
double cornerError(const Judgement& verdict, const Scene& scene) {
  REQUIRE(verdict.refusal == "");
  double most = 0.0;
  for (std::size_t i = 0; i < 4; ++i) most = std::max(most, (verdict.place->corners()[i] - scene.corners[i]).norm());
  return most / ChartPlace::of(scene.corners)->shortestSide();
}

Scene turnedBy(std::size_t quarters) {
  Scene scene;
  if (quarters % 2 == 1)
    scene.corners = {Point(180.0, 30.0), Point(460.0, 30.0), Point(460.0, 450.0), Point(180.0, 450.0)};
  Corners turned;
  for (std::size_t i = 0; i < 4; ++i) turned[i] = scene.corners[(i + quarters) % 4];
  scene.corners = turned;
  return scene;
}

/// A quarter of a patch: its middle half then still lies within the patch.
constexpr double kWithinPatch = 0.25;

Camera realCamera() {
  Camera camera;
  camera.matrix = tests::leakyMatrix();
  camera.noise = 2.0 / 255.0;
  camera.vignette = 0.1;
  return camera;
}

}  // namespace

TEST_CASE("FindCharts, AnyWayUp") {
  for (std::size_t quarters = 0; quarters < 4; ++quarters) {
    const Scene scene = turnedBy(quarters);
    INFO(quarters << " quarters");
    CHECK(cornerError(found(photograph(wantedChart(), scene, realCamera())), scene) < kWithinPatch);
  }
}

TEST_CASE("FindCharts, InPerspectiveAndSmall") {
  Scene tilted;
  tilted.corners = {Point(150.0, 110.0), Point(510.0, 85.0), Point(540.0, 390.0), Point(120.0, 350.0)};
  CHECK(cornerError(found(photograph(wantedChart(), tilted, realCamera())), tilted) < kWithinPatch);
  Scene small;
  small.corners = {Point(300.0, 200.0), Point(434.0, 210.0), Point(428.0, 300.0), Point(294.0, 290.0)};
  CHECK(cornerError(found(photograph(wantedChart(), small, realCamera())), small) < kWithinPatch);
}

TEST_CASE("FindCharts, TwoChartsAreTwo") {
  const auto [left, right, both] = tests::photographTwo(wantedChart(), realCamera(), realCamera());
  std::vector<Corners> areas;
  for (const Candidate& candidate : findCandidates(both)) areas.push_back(candidate.corners);
  areas.push_back(left.corners);  // found again, and by hand: still one chart
  std::vector<Judgement> charts = judgeAll(both, areas, wantedChart(), clippingLevel(both, false), true);
  REQUIRE(charts.size() == 2);
  if (charts[0].place->corners()[0].x() > 320.0) std::swap(charts[0], charts[1]);
  CHECK(cornerError(charts[0], left) < kWithinPatch);
  CHECK(cornerError(charts[1], right) < kWithinPatch);
}

TEST_CASE("FindCharts, AWallWithoutAChartHasNone") {
  ReferenceChart grey;
  grey.fill(Colour::Constant(0.02));
  const image::Image image = photograph(grey, {}, realCamera());
  for (const Candidate& c : findCandidates(image))
    CHECK(!judge(image, c.corners, wantedChart(), clippingLevel(image, false), true).refusal.empty());
}

TEST_CASE("Calibration, ACamerasMatrixIsRecovered") {
  const image::Image image = photograph(wantedChart(), {}, realCamera());
  const Judgement verdict = found(image);
  REQUIRE(verdict.place);
  const Calibration calibration = calibratePatches("photo.png", verdict.patches, wantedChart(), "3x3");
  // Noise of 2 codes over 1600 samples leaves 0.05 codes; the vignette's 10 % at the corners, at most 5 % at the
  // chart's, is 1.8 of L* at its largest.
  CHECK(summaryOf(calibration.errors().left_out).mean < 1.0);
  CHECK(summaryOf(calibration.errors().left_out).worst < 2.5);
  CHECK(summaryOf(calibration.before).mean > 10.0);
}

TEST_CASE("Calibration, WithoutVignetteOnlyQuantisationIsLeft") {
  Camera camera;
  camera.matrix = tests::leakyMatrix();
  const image::Image image = photograph(wantedChart(), {}, camera);
  const Judgement verdict = found(image);
  REQUIRE(verdict.place);
  const Calibration calibration = calibratePatches("photo.png", verdict.patches, wantedChart(), "3x3");
  // Half a code of 255 is 0.2 of L*, and the matrix's inverse makes it up to 2.5 times as much. Cyan's red, which is
  // below 0, is clipped by no camera of this matrix.
  CHECK(summaryOf(calibration.errors().fit).mean < 0.5);
  CHECK(summaryOf(calibration.errors().left_out).mean < 0.6);
}
