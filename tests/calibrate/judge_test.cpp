// SPDX-License-Identifier: Apache-2.0
// What is a chart and what is not, by the pattern of colours.
#include "calibrate/judge.h"

#include <catch2/catch.hpp>
#include <random>

#include "synthetic_chart.h"

using namespace welkin;
using namespace welkin::calibrate;
using tests::Camera;
using tests::Scene;

namespace {

const ReferenceChart& trueChart() {
  static const ReferenceChart kChart = referenceChart(Edition::after_2014);
  return kChart;
}

double likenessOf(const Patches& patches) {
  const auto match = matchPattern(patches, trueChart());
  return match ? match->likeness : 0.0;
}

Judgement judged(const image::Image& image, const Corners& corners, bool turn = true) {
  return judge(image, corners, trueChart(), clippingLevel(image, false), turn);
}

/// Puts a colour on part of the picture.
void cover(image::Image& image, int left, int top, int right, int bottom, const Colour& colour) {
  for (int row = top; row < bottom; ++row)
    for (int column = left; column < right; ++column)
      for (int c = 0; c < 3; ++c)
        image.rgb[static_cast<std::size_t>(3 * (row * image.width + column) + c)] = static_cast<float>(colour[c]);
}

}  // namespace

TEST_CASE("Pattern, OtherPatternsAreNoChart") {
  std::mt19937 random(7);
  const auto drawn = [&random] { return static_cast<double>(random()) * 0x1p-32; };
  double likest = 0.0;
  for (int pattern = 0; pattern < 3000; ++pattern) {
    Patches colours, ramp, shuffled = tests::seenPatches(trueChart(), {});
    for (Patch& p : colours) p.mean = {drawn(), drawn(), drawn()};
    Eigen::Matrix3d slope;
    for (double& v : slope.reshaped()) v = drawn();
    for (std::size_t i = 0; i < kPatches; ++i) {
      const Colour along(0.1, static_cast<double>(i % kColumns) / 5.0, static_cast<double>(i / kColumns) / 3.0);
      ramp[i].mean = slope * along + 0.1 * Colour(drawn(), drawn(), drawn());
      std::swap(shuffled[i].mean, shuffled[i + random() % (kPatches - i)].mean);
    }
    for (const Patches& p : {colours, ramp, shuffled}) likest = std::max(likest, likenessOf(p));
  }
  CHECK(likest < kLeastLikeness - 0.2);
}

TEST_CASE("Pattern, AChartThroughAnyCameraIsOne") {
  Camera camera;
  for (const double exponent : {0.45, 0.8, 1.0, 1.6, 2.2})
    for (const double warm : {0.4, 1.0, 2.5})
      for (const double exposure : {0.05, 0.9}) {
        camera.exponent = exponent;
        camera.matrix = exposure * Eigen::Vector3d(warm, 1.0, 1.0 / warm).asDiagonal() * tests::leakyMatrix();
        INFO("exponent " << exponent << ", warmth " << warm << ", exposure " << exposure);
        CHECK(likenessOf(tests::seenPatches(trueChart(), camera)) > 0.95);
      }
}

TEST_CASE("Judge, NamesTheRightFirstCorner") {
  const Scene scene;
  const image::Image image = photograph(trueChart(), scene, {});
  const Corners& c = scene.corners;
  CHECK(judged(image, c, false).refusal == "");
  CHECK(judged(image, {c[2], c[3], c[0], c[1]}, false).refusal ==
        "its corners begin at another patch than dark skin; the right order begins with the third one");
  const Judgement turned = judged(image, {c[2], c[3], c[0], c[1]}, true);
  REQUIRE(turned.place);
  CHECK(turned.place->corners()[0] == c[0]);
  CHECK(judged(image, {c[1], c[0], c[3], c[2]}).refusal ==
        "it is mirrored, or its corners run against the order dark skin, bluish green, black, white");
  CHECK(judged(image, {c[0], c[2], c[1], c[3]}).refusal ==
        "its corners are not those of a convex area, one after the other around it");
}

TEST_CASE("Judge, ACutChartIsRefused") {
  Scene scene;
  scene.corners = {Point(-30.0, 100.0), Point(370.0, 100.0), Point(370.0, 370.0), Point(-30.0, 370.0)};
  CHECK(judged(photograph(trueChart(), scene, {}), scene.corners).refusal ==
        "the picture cuts it: a corner lies outside");
}

TEST_CASE("Judge, ATinyChartIsRefused") {
  Scene scene;
  scene.corners = {Point(100.0, 100.0), Point(120.0, 100.0), Point(120.0, 113.0), Point(100.0, 113.0)};
  CHECK(judged(photograph(trueChart(), scene, {}), scene.corners).refusal ==
        "its patches are 2.9 pixels wide; at least 4 are needed");
}

TEST_CASE("Judge, OverexposedAndCoveredChartsAreRefused") {
  const Scene scene;
  Camera camera;
  camera.matrix = 4.0 * Eigen::Matrix3d::Identity();
  const Judgement bright = judged(photograph(trueChart(), scene, camera), scene.corners);
  CHECK(!bright.place);
  CHECK(bright.refusal.find("are overexposed") != std::string::npos);

  image::Image covered = photograph(trueChart(), scene, {});
  cover(covered, 110, 90, 340, 380, Colour(0.6, 0.35, 0.25));
  CHECK(judged(covered, scene.corners).refusal != "");
}

TEST_CASE("Judge, AFingerOnOnePatchLeavesItOut") {
  const Scene scene;
  image::Image image = photograph(trueChart(), scene, {});
  cover(image, 120, 100, 155, 170, Colour(0.8, 0.5, 0.4));  // half of dark skin
  const Judgement verdict = judged(image, scene.corners);
  REQUIRE(verdict.place);
  CHECK(verdict.patches[0].isUneven());
  CHECK(!verdict.patches[0].isUsable());
  for (std::size_t i = 1; i < kPatches; ++i) CHECK(!verdict.patches[i].isUneven());
}

TEST_CASE("Judge, ACoveredPatchIsForeign") {
  const Scene scene;
  image::Image image = photograph(trueChart(), scene, {});
  cover(image, 126, 106, 186, 166, Colour(0.05, 0.7, 0.1));  // all of dark skin
  const Judgement verdict = judged(image, scene.corners);
  REQUIRE(verdict.place);
  CHECK(verdict.patches[0].is_foreign);
  for (std::size_t i = 1; i < kPatches; ++i) CHECK(verdict.patches[i].isUsable());
}

TEST_CASE("Judge, AGreyPhotographIsRefused") {
  const Scene scene;
  Camera camera;
  camera.matrix.rowwise() = Eigen::RowVector3d(0.2126, 0.7152, 0.0722);
  CHECK(judged(photograph(trueChart(), scene, camera), scene.corners).refusal == "its patches do not differ in colour");
}
