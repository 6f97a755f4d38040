// SPDX-License-Identifier: Apache-2.0
#include <Eigen/LU>
#include <catch2/catch.hpp>

#include "calibrate/affine_cubic.h"
#include "calibrate/calibration.h"
#include "calibrate/left_out.h"
#include "sky/base/error.h"
#include "synthetic_chart.h"

using namespace welkin;
using namespace welkin::calibrate;
using tests::Camera;

namespace {

const ReferenceChart& chart() {
  static const ReferenceChart kChart = referenceChart(Edition::after_2014);
  return kChart;
}

std::vector<Pair> pairsThrough(const Eigen::Matrix3d& matrix, double exposure = 1.0) {
  std::vector<Pair> pairs;
  for (const Colour& wanted : chart()) pairs.push_back({exposure * (matrix * wanted), wanted});
  return pairs;
}

double largestError(const std::vector<Pair>& pairs, const Model& model) {
  double most = 0.0;
  for (const Pair& p : pairs) most = std::max(most, (model(p.measured) - p.wanted).cwiseAbs().maxCoeff());
  return most;
}

Model fitted(const char* name, const std::vector<Pair>& pairs) {
  const ModelKind* kind = modelNamed(name);
  auto numbers = kind->fit(pairs);
  REQUIRE(numbers);
  CHECK(numbers->size() == kind->count);
  return {kind, *numbers};
}

std::string refusalOf(const Patches& patches) {
  try {
    calibratePatches("photo.png", patches, chart(), "auto");
  } catch (const base::Error& e) {
    CHECK(e.status() == base::ExitStatus::content);
    return e.what();
  }
  return "";
}

}  // namespace

TEST_CASE("Models, TheChartItselfIsUnchanged") {
  std::vector<Pair> same = pairsThrough(Eigen::Matrix3d::Identity());
  for (Pair& p : same) p.measured = p.wanted = p.wanted.cwiseMax(0.0);  // no camera sees cyan's red below 0
  constexpr double kStopsThere = 1e-6;                                  // of models that are fitted step by step
  for (const ModelKind& kind : models()) {
    INFO(kind.name);
    CHECK(largestError(same, fitted(kind.name, same)) < kStopsThere);
  }
}

TEST_CASE("Models, MatrixAndRootsUndoAMatrixExactly") {
  const std::vector<Pair> pairs = pairsThrough(tests::leakyMatrix());
  for (const char* name : {"3x3", "root-polynomial"}) CHECK(largestError(pairs, fitted(name, pairs)) < 1e-9);
}

TEST_CASE("Models, ARefitAfterAChangeOfExposureGivesTheSameColours") {
  const std::vector<Pair> bright = pairsThrough(tests::leakyMatrix()), dark = pairsThrough(tests::leakyMatrix(), 0.25);
  for (const char* name : {"aca", "3x3", "root-polynomial"}) {
    const Model a = fitted(name, bright), b = fitted(name, dark);
    INFO(name);
    for (std::size_t i = 0; i < kPatches; ++i) CHECK((a(bright[i].measured) - b(dark[i].measured)).norm() < 1e-9);
  }
}

TEST_CASE("AffineCubic, UndoesAnAffineMapOfXyY") {
  // The last stage's inverse, moderate so that all colours stay colours.
  std::vector<Pair> pairs;
  for (const Colour& wanted : chart()) {
    Colour xyY = xyYOfXyz(xyzOfRgb(wanted));
    xyY = Colour(0.9 * xyY.x() + 0.02, 0.05 * xyY.x() + 0.9 * xyY.y(), 0.7 * xyY.z());
    pairs.push_back({rgbOfXyz(xyzOfXyY(xyY)), wanted});
  }
  // Gains of the channels come first and leave what is affine in xyY only nearly so.
  CHECK(summaryOf(differences(pairs, fitted("aca", pairs))).mean < 0.5);
  CHECK(summaryOf(differencesBefore(pairs)).mean > 5.0);
}

TEST_CASE("AffineCubic, IsFiniteAndPhysicalFarFromTheChart") {
  const std::vector<Pair> pairs = pairsThrough(tests::leakyMatrix());
  const Model model = fitted("aca", pairs);
  for (double r = 0.0; r <= 4.0; r += 0.5)
    for (double g = 0.0; g <= 4.0; g += 0.5)
      for (double b = 0.0; b <= 4.0; b += 0.5) {
        const Colour result = model({r, g, b});
        const Colour xyY = xyYOfXyz(xyzOfRgb(result));
        CHECK(result.allFinite());
        CHECK(xyY.z() >= -1e-12);
        CHECK(result.cwiseAbs().maxCoeff() < 1e4);
      }
}

TEST_CASE("LeftOut, ARowLeftOutIsNotWhatTheFitSaw") {
  const std::vector<Pair> pairs = pairsThrough(tests::leakyMatrix());
  std::vector<Pair> wrong = pairs;
  for (std::size_t i = 18; i < 24; ++i) wrong[i].wanted *= 0.5;
  std::vector<std::size_t> row;
  for (std::size_t i = 0; i < kPatches; ++i) row.push_back(i / kColumns);
  const auto out = differencesLeftOut(wrong, row, *modelNamed("3x3"));
  REQUIRE(out);
  // Without the wrong row the fit is exact: its error is all the halving of light.
  for (std::size_t i = 18; i < 24; ++i)
    CHECK((*out)[i] == Approx(ciede2000(labOfRgb(pairs[i].wanted), labOfRgb(wrong[i].wanted))).margin(1e-6));
}

TEST_CASE("Calibration, ChoosesTheModelOfTheLeastErrorLeftOut") {
  Camera camera;
  camera.matrix = tests::leakyMatrix();
  const Calibration exact = calibratePatches("photo.png", tests::seenPatches(chart(), camera), chart(), "auto");
  CHECK(summaryOf(exact.errors().left_out).mean < 0.1);
  CHECK(exact.rss_srgb < 1e-3);
  CHECK(exact.used.size() == kPatches);
  for (const ModelErrors& tried : exact.tried)
    CHECK(summaryOf(tried.left_out).mean >= summaryOf(exact.errors().left_out).mean);
}

TEST_CASE("Calibration, DegenerateChartsAreRefusedWithTheReason") {
  Patches same;
  for (Patch& p : same) p.mean = Colour(0.3, 0.2, 0.1);
  CHECK(refusalOf(same) == "photo.png: the chart's patches do not differ in colour: they determine no calibration");

  Patches grey = tests::seenPatches(chart(), {});
  for (Patch& p : grey) p.mean = Colour::Constant(p.mean.y());
  CHECK(refusalOf(grey) == refusalOf(same));

  Patches dead = tests::seenPatches(chart(), {});
  for (Patch& p : dead) p.mean.z() = 0.0;
  CHECK(refusalOf(dead) == "photo.png: the chart has no light in blue: every patch is 0 there");

  Patches bright = tests::seenPatches(chart(), {});
  for (std::size_t i = 0; i < 7; ++i) bright[3 * i].clipped = 0.5;
  CHECK(refusalOf(bright) ==
        "photo.png: 7 of 24 patches are overexposed and 0 are partly in shadow or covered; at least "
        "18 good ones are needed");
}
