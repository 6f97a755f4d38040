// SPDX-License-Identifier: Apache-2.0
// The error of a model on charts that it was not fitted to, in the same photograph and in others.
#include "calibrate/other_chart.h"

#include <catch2/catch.hpp>

#include "calibrate/batch.h"
#include "calibrate/left_out.h"
#include "calibrate/report.h"
#include "synthetic_chart.h"
#include "tests/folder.h"

using namespace welkin;
using namespace welkin::calibrate;
using tests::Camera;
using tests::laterChart;
using tests::Scene;
using tests::writeCoded;

namespace {

Camera leaky(double light) {
  Camera camera;
  camera.matrix = light * tests::leakyMatrix();
  return camera;
}

Batch matrixBatch(const std::filesystem::path& folder) {
  Batch batch;
  batch.photo.reference = laterChart();
  batch.photo.model = "3x3";
  batch.photo.encoding = Encoding::srgb;
  batch.folder = folder;
  return batch;
}

/// CIEDE2000 of all patches as a camera of `light` times the light shows them to a model of light 1 that is exact.
double meanInLight(double light) {
  std::vector<double> all;
  for (const Colour& wanted : laterChart()) all.push_back(ciede2000(labOfRgb(light * wanted), labOfRgb(wanted)));
  return summaryOf(all).mean;
}

/// Half a code of 255 is 0.2 of L*, and the matrix's inverse makes it up to 2.5 times as much.
constexpr double kQuantised = 0.5;

}  // namespace

TEST_CASE("OtherChart, ItsErrorIsThatOfTheLightItStandsIn") {
  const tests::Folder folder;
  for (const double light : {1.0, 0.8}) {
    INFO(light);
    const tests::TwoCharts two = photographTwo(laterChart(), leaky(1.0), leaky(light));
    writeCoded(folder / "two.png", two.image);
    PhotoOptions options = matrixBatch(folder.path()).photo;
    options.corners = two.left.corners;
    const CalibratedPhoto by_hand = calibratePhoto(folder / "two.png", options);
    CHECK(by_hand.others.empty());
    options.corners.reset();
    const CalibratedPhoto photo = calibratePhoto(folder / "two.png", options);
    REQUIRE(photo.others.size() == 1);
    const bool fitted_left = photo.charts[0].place.corners()[0].x() < 320.0;
    const ChartError& other = photo.others[0];
    CHECK((other.chart.place.corners()[0].x() < 320.0) != fitted_left);
    REQUIRE(other.after.size() == kPatches);
    CHECK(summaryOf(other.after).mean == Approx(meanInLight(fitted_left ? light : 1.0 / light)).margin(kQuantised));
    CHECK(other.before == differencesBefore(pairsOf(other.chart.patches, laterChart(), photo.calibration.used)));

    const nlohmann::ordered_json charts = summaryJson(photo)["charts"];
    REQUIRE(charts.size() == 2);
    CHECK_FALSE(charts[0].contains("de2000"));
    CHECK(charts[1]["de2000"]["after"]["mean"] == summaryOf(other.after).mean);
    CHECK(charts[1]["de2000"]["before"]["worst"] == summaryOf(other.before).worst);
    CHECK(charts[1]["corners"][0][0] == other.chart.place.corners()[0].x());
  }
}

TEST_CASE("OtherChart, AProfileStatesItsErrorOnAPhotographsOwnChart") {
  const tests::Folder folder;
  writeCoded(folder / "chart.png", photograph(laterChart(), {}, leaky(1.0)));
  Scene moved;
  moved.corners = {Point(150.0, 110.0), Point(510.0, 85.0), Point(540.0, 390.0), Point(120.0, 350.0)};
  writeCoded(folder / "same.png", photograph(laterChart(), moved, leaky(1.0)));
  writeCoded(folder / "darker.png", photograph(laterChart(), moved, leaky(0.7)));
  ReferenceChart grey;
  grey.fill(Colour::Constant(0.02));
  writeCoded(folder / "wall.png", photograph(grey, {}, leaky(1.0)));
  std::filesystem::create_directory(folder / "out");
  Batch batch = matrixBatch(folder / "out");
  batch.profile = profileOf(calibratePhoto(folder / "chart.png", batch.photo));
  const auto report = [&](const char* photo) { return make(singleJob(folder / photo, batch), batch, false).report; };
  const auto mean = [&](const char* photo) -> double {
    const auto charts = report(photo)["charts"];
    REQUIRE(charts.size() == 1);
    CHECK(charts[0]["de2000"]["after"]["mean"] < charts[0]["de2000"]["before"]["mean"]);
    return charts[0]["de2000"]["after"]["mean"];
  };
  CHECK(mean("same.png") < kQuantised);
  CHECK(mean("darker.png") == Approx(meanInLight(0.7)).margin(kQuantised));
  CHECK(report("wall.png")["charts"] == nlohmann::ordered_json::array());
  CHECK_FALSE(report("same.png").contains("fitted_here"));
  CHECK(report("chart.png")["fitted_here"] == true);
  const Profile read = readProfile(folder.write("profile.json", profileJson(*batch.profile).dump()));
  CHECK(read.photo == batch.profile->photo);
}
