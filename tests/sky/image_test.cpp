// SPDX-License-Identifier: Apache-2.0
// Images from files: encodings, depths, channels and the order of rows. Damaged files: tests/cli/image_errors_test.cpp.
#include "sky/image/image.h"

#include <OpenImageIO/imageio.h>

#include <catch2/catch.hpp>
#include <cmath>

#include "sh/deterministic.h"
#include "sky/base/error.h"
#include "tests/folder.h"

namespace welkin::tests {
namespace {

using OIIO::TypeDesc;
constexpr double kDecoding = 4e-7;  // relative: the rounding of a float, times the slope of the decoding

/// Writes an image of `value`s between 0 and 1 (or any floats) and reads it back.
image::Image roundTrip(const std::string& name, OIIO::ImageSpec spec, const std::vector<float>& value) {
  const Folder folder;
  auto output = OIIO::ImageOutput::create(name);
  REQUIRE(output);
  spec.attribute("oiio:UnassociatedAlpha", 1);
  REQUIRE(output->open(folder / name, spec));
  REQUIRE(output->write_image(TypeDesc::FLOAT, value.data()));
  REQUIRE(output->close());
  return image::readImage(folder / name);
}

void requireTexel(const image::Image& image, std::size_t texel, double r, double g, double b) {
  REQUIRE(double{image.rgb[3 * texel]} == Approx(r).epsilon(kDecoding).margin(1e-12));
  REQUIRE(double{image.rgb[3 * texel + 1]} == Approx(g).epsilon(kDecoding).margin(1e-12));
  REQUIRE(double{image.rgb[3 * texel + 2]} == Approx(b).epsilon(kDecoding).margin(1e-12));
}

double decoded(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

}  // namespace

TEST_CASE("SrgbToLinear, IsTheStandardsCurve") {
  constexpr double kDigits = 1e-14;
  REQUIRE(det::srgbDecode(0.0) == 0.0);
  REQUIRE(det::srgbDecode(1.0) == Approx(1.0).epsilon(kDigits));
  REQUIRE(det::srgbDecode(0.5) == Approx(0.21404114048223255).epsilon(kDigits));
  REQUIRE(det::srgbDecode(0.04045) == Approx(0.04045 / 12.92).epsilon(kDigits));
  // The two pieces meet within the rounding of the standard's own constants.
  REQUIRE(det::srgbDecode(std::nextafter(0.04045, 1.0)) == Approx(0.04045 / 12.92).epsilon(1e-5));
  for (double x = 0.0; x <= 1.0; x += 1.0 / 255.0) REQUIRE(det::srgbDecode(x) == Approx(decoded(x)).epsilon(kDigits));
}

TEST_CASE("Image, IntegersAreSrgbEncoded") {
  for (const char* name : {"a.png", "a.tif"})
    for (const auto& [type, steps] : {std::pair(TypeDesc(TypeDesc::UINT8), 255), {TypeDesc::UINT16, 65535}}) {
      INFO(name << " with " << steps + 1 << " steps");
      std::vector<float> value;
      for (const int code : {0, 1, steps / 25, steps / 2, steps - 1, steps})
        value.push_back(static_cast<float>(code) / static_cast<float>(steps));
      const image::Image image = roundTrip(name, OIIO::ImageSpec(2, 1, 3, type), value);
      REQUIRE(image.width == 2);
      REQUIRE(image.height == 1);
      const double s = steps;
      requireTexel(image, 0, 0.0, decoded(1 / s), decoded(steps / 25 / s));
      requireTexel(image, 1, decoded(steps / 2 / s), decoded((steps - 1) / s), 1.0);
    }
}

TEST_CASE("Image, FloatsAreLinear") {
  for (const auto& [name, type] : {std::pair<std::string, TypeDesc>("a.exr", TypeDesc::HALF),
                                   {"a.exr", TypeDesc::FLOAT},
                                   {"a.tif", TypeDesc::FLOAT}}) {
    INFO(name);
    const image::Image image =
        roundTrip(name, OIIO::ImageSpec(2, 1, 3, type), {0.0F, 0.5F, 1.0F, 2.0F, 1000.0F, 65504.0F});
    requireTexel(image, 0, 0.0, 0.5, 1.0);
    requireTexel(image, 1, 2.0, 1000.0, 65504.0);
  }
}

TEST_CASE("Image, IntegersThatSayTheyAreLinearAre") {
  OIIO::ImageSpec spec(1, 1, 3, TypeDesc::UINT16);
  spec.attribute("oiio:ColorSpace", "Linear");
  const image::Image image = roundTrip("a.png", spec, {0.0F, 13107.0F / 65535.0F, 1.0F});
  requireTexel(image, 0, 0.0, 0.2, 1.0);
}

TEST_CASE("Image, OneChannelIsGreyAndAlphaIsIgnored") {
  const double grey = decoded(51.0 / 255.0);
  const float g = 0.2F;
  for (const char* name : {"a.png", "a.tif"}) {
    INFO(name);
    requireTexel(roundTrip(name, OIIO::ImageSpec(1, 1, 1, TypeDesc::UINT8), {g}), 0, grey, grey, grey);
    for (const float alpha : {1.0F, 0.6F, 0.0F}) {
      INFO("alpha " << alpha);
      OIIO::ImageSpec two(1, 1, 2, TypeDesc::UINT8);
      two.channelnames = {"Y", "A"};
      two.alpha_channel = 1;
      requireTexel(roundTrip(name, two, {g, alpha}), 0, grey, grey, grey);
      OIIO::ImageSpec four(1, 1, 4, TypeDesc::UINT8);
      four.alpha_channel = 3;
      requireTexel(roundTrip(name, four, {g, 1.0F, 0.0F, alpha}), 0, grey, 1.0, 0.0);
    }
  }
  requireTexel(roundTrip("a.exr", OIIO::ImageSpec(1, 1, 1, TypeDesc::FLOAT), {3.0F}), 0, 3.0, 3.0, 3.0);
}

TEST_CASE("Image, RowsGoFromTheTopAndColumnsFromTheLeft") {
  std::vector<float> value;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column)
      value.insert(value.end(), {static_cast<float>(column), static_cast<float>(row), 1.0F});
  for (const char* name : {"a.exr", "a.tif"}) {
    const image::Image image = roundTrip(name, OIIO::ImageSpec(4, 3, 3, TypeDesc::FLOAT), value);
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 4; ++column)
        requireTexel(image, static_cast<std::size_t>(4 * row + column), column, row, 1.0);
  }
}

TEST_CASE("Image, MoreTexelsThanTheLimitAreRefused") {
  const std::vector<float> row(3 * 16385, 0.0F);
  REQUIRE_THROWS_AS(roundTrip("a.png", OIIO::ImageSpec(16385, 1, 3, TypeDesc::UINT8), row), base::Error);
  const std::vector<float> longest(3 * 16384, 1.0F);
  requireTexel(roundTrip("a.png", OIIO::ImageSpec(16384, 1, 3, TypeDesc::UINT8), longest), 16383, 1.0, 1.0, 1.0);
}

}  // namespace welkin::tests
