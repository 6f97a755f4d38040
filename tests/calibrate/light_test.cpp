// SPDX-License-Identifier: Apache-2.0
// Uneven light over a chart, and TIFF of albedo.
#include <catch2/catch.hpp>
#include <cmath>

#include "calibrate/albedo_file.h"
#include "calibrate/judge.h"
#include "calibrate/uneven_light.h"
#include "synthetic_chart.h"
#include "tests/folder.h"

using namespace welkin;
using namespace welkin::calibrate;

namespace {

std::vector<std::size_t> allPatches() {
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < kPatches; ++i) all.push_back(i);
  return all;
}

Patches underGradient(const LightGradient& light, double exponent) {
  tests::Camera camera;
  camera.matrix = tests::leakyMatrix();
  Patches patches = tests::seenPatches(referenceChart(Edition::after_2014), {});
  const ReferenceChart reference = referenceChart(Edition::after_2014);
  for (std::size_t i = 0; i < kPatches; ++i)
    patches[i].mean = (light.at(i) * (camera.matrix * reference[i])).cwiseMax(0.0).array().pow(exponent).matrix();
  return patches;
}

}  // namespace

TEST_CASE("UnevenLight, IsFoundThroughACameraInBothDirections") {
  const ReferenceChart reference = referenceChart(Edition::after_2014);
  constexpr double kFound = 0.02;  // 2 % of light: cyan, which the camera clips, draws the fit a little
  for (const LightGradient& light : {LightGradient{0.0, 0.0}, LightGradient{0.3, 0.0}, LightGradient{-0.2, 0.4},
                                     LightGradient{0.1, -0.35}, LightGradient{-0.6, -0.6}}) {
    CAPTURE(light.along, light.down);
    const LightGradient found = gradientOf(underGradient(light, 1.0), reference, allPatches());
    CHECK(found.along == Approx(light.along).margin(kFound));
    CHECK(found.down == Approx(light.down).margin(kFound));
  }
}

TEST_CASE("UnevenLight, TakenOutLeavesTheColoursOfEvenLight") {
  const LightGradient light{-0.25, 0.35};
  const Patches even = underGradient({}, 1.0), flat = withoutGradient(underGradient(light, 1.0), light);
  for (std::size_t i = 0; i < kPatches; ++i) CHECK((even[i].mean - flat[i].mean).norm() < 1e-12);
  // Black's middle lies half a patch and the rim from the lower right corner.
  CHECK(std::log(light.at(23)) == Approx(-0.25 * (15.25 / 16.75 - 0.5) + 0.35 * (9.75 / 11.25 - 0.5)));
}

TEST_CASE("UnevenLight, LowersTheErrorLeftOutOfAPhotograph") {
  const ReferenceChart reference = referenceChart(Edition::after_2014);
  tests::Camera camera;
  camera.matrix = tests::leakyMatrix();
  camera.gradient = 0.4;
  camera.noise = 1.0 / 255.0;
  const tests::Scene scene;
  const image::Image image = photograph(reference, scene, camera);
  const Patches patches = judge(image, scene.corners, reference, clippingLevel(image, false), false).patches;
  const Calibration before = calibratePatches("photo", patches, reference, "auto");
  const LightGradient light = gradientOf(patches, reference, before.used);
  // The camera's gradient is linear in place, and the found one exponential: they differ by less than 0.05 in between.
  CHECK(std::exp(light.along) == Approx(0.6).margin(0.05));
  CHECK(std::exp(light.down) == Approx(1.0).margin(0.03));
  const Calibration after = calibratePatches("photo", withoutGradient(patches, light), reference, "auto");
  CHECK(summaryOf(after.errors().left_out).mean < 0.5 * summaryOf(before.errors().left_out).mean);
}

TEST_CASE("AlbedoFile, TiffAndPngHoldTheSameCodesOfSixteenBits") {
  const tests::Folder folder;
  image::Image albedo;
  albedo.width = 3;
  albedo.height = 2;
  albedo.rgb = {0.0F, 0.001F, 0.01F, 0.1F, 0.2F, 0.3F,  0.4F, 0.5F,  0.6F,
                0.7F, 0.8F,   0.9F,  1.0F, 1.5F, 0.02F, 0.5F, 0.25F, 0.125F};
  writeAlbedo(folder / "a.tif", albedo);
  writeAlbedo(folder / "a.png", albedo);
  const image::Image tiff = image::readImage(std::filesystem::path(folder / "a.tif"));
  const image::Image png = image::readImage(std::filesystem::path(folder / "a.png"));
  CHECK_FALSE(tiff.converted);
  REQUIRE(tiff.rgb.size() == albedo.rgb.size());
  CHECK(tiff.width == 3);
  constexpr double kHalfCode = 0.5 / 65535 * 2.3;  // half a code where the curve is steepest
  constexpr double kDecoders = 1e-7;               // both readers decode the curve, one by a table
  for (std::size_t i = 0; i < albedo.rgb.size(); ++i) {
    CHECK(double{tiff.rgb[i]} == Approx(double{png.rgb[i]}).margin(kDecoders));
    CHECK(double{tiff.rgb[i]} == Approx(std::min(1.0, double{albedo.rgb[i]})).margin(kHalfCode));
  }
}
