// SPDX-License-Identifier: Apache-2.0
// Pairs of polarised photographs, against the light that they were made of.
#include "calibrate/polarised.h"

#include <catch2/catch.hpp>

#include "calibrate/batch.h"
#include "sky/base/error.h"
#include "synthetic_chart.h"
#include "tests/folder.h"

using namespace welkin;
using namespace welkin::calibrate;

namespace {

image::Image pictureOf(int width, int height, std::vector<float> rgb) {
  image::Image image;
  image.width = width;
  image.height = height;
  image.rgb = std::move(rgb);
  return image;
}

const std::vector<float> kDiffuse = {0.5F, 0.25F, 0.125F, 0.0F, 0.5F, 0.75F},
                         kSpecular = {0.25F, 0.5F, 0.0F, 4.0F, 2.0F, 1.0F};

image::Image crossed() {
  std::vector<float> rgb;
  for (const float d : kDiffuse) rgb.push_back(0.5F * d);
  return pictureOf(2, 1, rgb);
}

image::Image parallel() {
  std::vector<float> rgb;
  for (std::size_t i = 0; i < kDiffuse.size(); ++i) rgb.push_back(0.5F * kDiffuse[i] + kSpecular[i]);
  return pictureOf(2, 1, rgb);
}

/// Albedo is twice the crossed light, with red and blue exchanged.
Model twice() {
  return {modelNamed("3x3"), {0, 0, 2, 0, 2, 0, 2, 0, 0}};
}

}  // namespace

TEST_CASE("Polarised, SpecularLightIsWhatThePairWasMadeOf") {
  const Specular specular = specularOf(crossed(), parallel(), "p.png", twice());
  CHECK(specular.below == 0.0);
  REQUIRE(specular.image.rgb.size() == 6);
  for (std::size_t i = 0; i < 6; ++i) CHECK(specular.image.rgb[i] == kSpecular[i / 3 * 3 + 2 - i % 3]);  // powers of 2
  const image::Image albedo = albedoOf(crossed(), twice());
  for (std::size_t i = 0; i < 6; ++i) CHECK(albedo.rgb[i] == kDiffuse[i / 3 * 3 + 2 - i % 3]);
}

TEST_CASE("Polarised, AnExchangedPairAndAnotherSizeAreTold") {
  const Specular exchanged = specularOf(parallel(), crossed(), "p.png", twice());
  CHECK(exchanged.below == 1.0);
  for (const float v : exchanged.image.rgb) CHECK(v == 0.0F);
  const auto why = [](int width, int height) -> std::string {
    try {
      specularOf(crossed(), pictureOf(width, height, std::vector<float>(6, 0.5F)), "p.png", twice());
    } catch (const base::Error& e) {
      CHECK(e.status() == base::ExitStatus::content);
      return e.what();
    }
    return "";
  };
  CHECK(why(1, 2) == "p.png: 1 x 2 pixels; the crossed photograph has 2 x 1, and both must be of one size");
  CHECK(why(2, 1) == "");
}

TEST_CASE("Polarised, AChartsSpecularLightComesInUnitsOfItsAlbedo") {
  const tests::Folder folder;
  const ReferenceChart reference = referenceChart(Edition::after_2014);
  constexpr float kGlare = 0.1F;  // of the light of a white diffuse surface, everywhere
  image::Image half = tests::photograph(reference, {}, {});
  for (float& v : half.rgb) v *= 0.5F;
  image::Image along = half;
  for (float& v : along.rgb) v += kGlare;
  tests::writeCoded(folder / "x.png", half);
  tests::writeCoded(folder / "p.png", along);
  Batch batch;
  batch.photo.reference = reference;
  batch.photo.model = "3x3";
  batch.folder = folder / "out";
  batch.parallel = folder / "p.png";
  std::filesystem::create_directory(batch.folder);
  const Made made = make(singleJob(folder / "x.png", batch), batch, false);
  CHECK(made.report["specular"]["file"] == "x.specular.exr");
  CHECK(made.report["specular"]["below"] == 0.0);
  const image::Image specular = image::readImage(std::filesystem::path(folder / "out/x.specular.exr"));
  REQUIRE(specular.width == half.width);
  Colour mean = Colour::Zero();
  for (std::size_t i = 0; i < specular.rgb.size(); ++i) mean[static_cast<int>(i % 3)] += double{specular.rgb[i]};
  mean /= static_cast<double>(specular.rgb.size() / 3);
  // The matrix is linear, so the mean is its colour of half the glare. Codes near the wall's are 0.004 apart, and the
  // rounding of two flat colours, times the matrix's 2, need not cancel.
  const Colour wanted = made.calibrated->calibration.model(Colour::Constant(0.5 * double{kGlare}));
  for (int c = 0; c < 3; ++c) {
    INFO(c);
    CHECK(mean[c] == Approx(wanted[c]).margin(0.008));
    CHECK(wanted[c] == Approx(double{kGlare}).epsilon(0.02));  // the gain is 2 but for cyan, whose red is clipped
  }

  tests::writeCoded(folder / "p.png", pictureOf(64, 1, std::vector<float>(192, 0.5F)));
  batch.folder = folder / "none";
  std::filesystem::create_directory(batch.folder);
  CHECK_THROWS_AS(make(singleJob(folder / "x.png", batch), batch, false), base::Error);
  CHECK(std::filesystem::is_empty(batch.folder));
}
