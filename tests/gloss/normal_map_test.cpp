// SPDX-License-Identifier: Apache-2.0
// Normal maps: how numbers stand for normals, and the mistakes that are told.
#include "gloss/normal_map.h"

#include <catch2/catch.hpp>
#include <functional>
#include <limits>

#include "bumps.h"
#include "gloss/integrability.h"
#include "sky/base/error.h"
#include "sky/image/exr_write.h"
#include "tests/folder.h"

namespace welkin::tests {
namespace {

using det::Number3;

/// The message of the refusal; it must be one of content.
std::string refusalOf(const image::Image& image, const gloss::NormalMapOptions& options = {}) {
  try {
    gloss::normalMapOf("brick.png", image, options);
  } catch (const base::Error& e) {
    REQUIRE(e.status() == base::ExitStatus::content);
    return e.what();
  }
  return "";
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

bool warned(const gloss::NormalMap& map, const std::string& id) {
  return std::any_of(map.warnings.begin(), map.warnings.end(), [&](const auto& w) { return w.id == id; });
}

image::Image mapped(image::Image image, const std::function<double(double)>& curve) {
  for (float& v : image.rgb) v = static_cast<float>(curve(double{v}));
  return image;
}

/// Largest angle between the map and the bumps, radians.
double worstAngle(const gloss::NormalMap& map, double steepness) {
  double worst = 0.0;
  for (int row = 0; row < map.height; ++row)
    for (int column = 0; column < map.width; ++column) {
      const Number3 n = bumpNormal((column + 0.5) / map.width, 1.0 - (row + 0.5) / map.height, steepness);
      const auto i = 3 * static_cast<std::size_t>(row * map.width + column);
      const Number3 away = Number3(double{map.xyz[i]}, double{map.xyz[i + 1]}, double{map.xyz[i + 2]}) - n;
      worst = std::max(worst, std::sqrt(dot(away, away)));
    }
  return worst;
}

constexpr double kCode = 0.0068;  // sqrt(3) times half a code of 2/255

}  // namespace

TEST_CASE("NormalMap, CodesOfEightBitsAreNormalised") {
  const gloss::NormalMap map = gloss::normalMapOf("a", rounded(bumpCodes(32, 24, 0.5)), {});
  REQUIRE(map.coding == gloss::Coding::codes);
  REQUIRE(map.warnings.empty());
  REQUIRE(worstAngle(map, 0.5) < kCode);
  for (std::size_t i = 0; i < map.xyz.size(); i += 3)
    REQUIRE(std::hypot(map.xyz[i], map.xyz[i + 1], map.xyz[i + 2]) == Approx(1.0F).margin(1e-6));
}

TEST_CASE("NormalMap, FloatsOfUnitLengthAreNormalsAsTheyAre") {
  const gloss::NormalMap map =
      gloss::normalMapOf("a", mapped(bumpCodes(16, 16, 0.5), [](double v) { return 2.0 * v - 1.0; }), {});
  REQUIRE(map.coding == gloss::Coding::plain);
  REQUIRE(worstAngle(map, 0.5) < 1e-6);
  image::Image flat;
  flat.width = flat.height = 1;
  flat.rgb = {0.0F, 0.0F, 1.0F};
  REQUIRE(gloss::normalMapOf("flat", flat, {}).xyz == flat.rgb);
}

TEST_CASE("NormalMap, SrgbEncodedNormalsAreRefusedAndDecodedOnDemand") {
  const image::Image encoded = rounded(mapped(bumpCodes(32, 32, 0.5), det::srgbEncode));
  const std::string said = refusalOf(encoded);
  REQUIRE(contains(said, "brick.png: normals are sRGB-encoded"));
  REQUIRE(contains(said, "--decode-srgb"));
  const gloss::NormalMap map = gloss::normalMapOf("a", encoded, {.decode_srgb = true});
  REQUIRE(worstAngle(map, 0.5) < 3.0 * kCode);  // the decoding is up to 2.3 times as steep as the codes
  image::Image flat;
  flat.width = flat.height = 2;
  for (int i = 0; i < 4; ++i)
    for (const float v : {188.0F, 188.0F, 255.0F}) flat.rgb.push_back(v / 255.0F);
  REQUIRE(contains(refusalOf(flat), "sRGB-encoded"));
}

TEST_CASE("NormalMap, NormalsDecodedFromSrgbByMistakeAreRefused") {
  REQUIRE(contains(refusalOf(rounded(mapped(bumpCodes(32, 32, 0.5), det::srgbDecode))), "were decoded from sRGB"));
}

TEST_CASE("NormalMap, ZOfTwoChannelsIsRebuilt") {
  for (const float blue : {0.0F, 128.0F / 255.0F, 1.0F}) {
    image::Image image = bumpCodes(16, 16, 0.5);
    for (std::size_t i = 2; i < image.rgb.size(); i += 3) image.rgb[i] = blue;
    const gloss::NormalMap map = gloss::normalMapOf("a", image, {});
    REQUIRE(map.coding == gloss::Coding::two_channel);
    REQUIRE(warned(map, "two-channel"));
    REQUIRE(worstAngle(map, 0.5) < 1e-5);
  }
}

TEST_CASE("NormalMap, GreyPicturesAreRefused") {
  image::Image grey = bumpCodes(8, 8, 0.5);
  for (std::size_t i = 0; i < grey.rgb.size(); ++i) grey.rgb[i] = grey.rgb[i / 3 * 3];
  REQUIRE(contains(refusalOf(grey), "brick.png: red, green and blue are equal"));
}

TEST_CASE("NormalMap, NormalsWithoutDirectionAreRefusedOrRepaired") {
  image::Image image = rounded(bumpCodes(16, 8, 0.5));
  for (int c = 0; c < 3; ++c) image.rgb[static_cast<std::size_t>(3 * (16 * 5 + 2) + c)] = 128.0F / 255.0F;
  REQUIRE(contains(refusalOf(image), "1 normals have no direction, the first at column 2, row 5"));
  const gloss::NormalMap map = gloss::normalMapOf("a", image, {.repair = true});
  REQUIRE(warned(map, "zero-normals"));
  REQUIRE(map.xyz[3 * (16 * 5 + 2) + 2] == 1.0F);
}

TEST_CASE("NormalMap, NormalsThatPointInwardAreTold") {
  image::Image image = rounded(bumpCodes(16, 8, 0.5));
  for (int c = 0; c < 3; ++c) image.rgb[static_cast<std::size_t>(c)] = 0.0F;  // black: (-1, -1, -1)
  const gloss::NormalMap map = gloss::normalMapOf("a", image, {});
  REQUIRE(warned(map, "inward-normals"));
  REQUIRE(map.xyz[2] == Approx(-std::sqrt(1.0F / 3.0F)));
  REQUIRE(gloss::normalMapOf("a", image, {.repair = true}).xyz[2] == 1.0F);
}

TEST_CASE("NormalMap, VectorsThatWereAveragedAreTold") {
  const image::Image shortened = mapped(bumpCodes(16, 16, 0.5), [](double v) { return 0.5 + (v - 0.5) * 0.85; });
  const gloss::NormalMap map = gloss::normalMapOf("a", shortened, {});
  REQUIRE(warned(map, "lengths"));
  REQUIRE(map.mean_stored_length == Approx(0.85).margin(1e-5));
  REQUIRE(worstAngle(map, 0.5) < 1e-5);
}

TEST_CASE("NormalMap, FilesSpeakForThemselves") {
  const Folder folder;
  const auto write = [&](const std::string& name, const std::vector<float>& rgb) {
    const auto bytes = image::encodeExr(2, 1, 3, rgb);
    return folder.write(name, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  };
  const std::vector<float> two = {0.6F, 0.0F, 0.8F, 0.0F, -0.8F, 0.6F};
  const gloss::NormalMap map = gloss::readNormalMap(write("brick.exr", two));
  REQUIRE(map.xyz == two);
  REQUIRE(map.warnings.empty());
  REQUIRE(warned(gloss::readNormalMap(write("brick_normal_mip3.exr", two)), "is-a-mip"));
  REQUIRE_FALSE(warned(gloss::readNormalMap(write("brick_normal_mip0.exr", two)), "is-a-mip"));
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()})
    REQUIRE_THROWS_WITH(gloss::readNormalMap(write("bad.exr", {0.0F, 0.0F, 1.0F, 0.0F, bad, 1.0F})),
                        Catch::Contains("bad.exr") && Catch::Contains("column 1, row 0"));
}

TEST_CASE("GreenDirection, OnlyOneIsTheSlopeOfASurface") {
  for (const double steepness : {0.02, 0.3, 2.0})
    for (const gloss::Wrap wrap : {gloss::Wrap::repeat, gloss::Wrap::clamp}) {
      gloss::NormalMap map = gloss::normalMapOf("a", rounded(bumpCodes(64, 48, steepness)), {});
      CAPTURE(steepness);
      REQUIRE(gloss::greenDirectionOf(map, wrap).points_up());
      for (std::size_t i = 1; i < map.xyz.size(); i += 3) map.xyz[i] = -map.xyz[i];
      REQUIRE(gloss::greenDirectionOf(map, wrap).points_down());
    }
  REQUIRE(gloss::greenDirectionOf(bumps(64, 64, 0.1), gloss::Wrap::repeat).correlation > 0.99);
}

TEST_CASE("GreenDirection, MapsThatTellNothingAreNotJudged") {
  const auto undecided = [](const gloss::NormalMap& map) {
    const gloss::GreenDirection green = gloss::greenDirectionOf(map, gloss::Wrap::repeat);
    REQUIRE(std::isfinite(green.correlation));
    REQUIRE(green.certainty >= 0.5);
    return !green.points_up() && !green.points_down();
  };
  REQUIRE(undecided(bumps(32, 32, 0.0)));
  REQUIRE(undecided(bumps(1, 1, 1.0)));
  gloss::NormalMap ridges = bumps(64, 64, 0.0);  // bent along one axis
  gloss::NormalMap noise = ridges;
  std::uint32_t random = 1;
  for (std::size_t i = 0; i < ridges.xyz.size(); i += 3) {
    const float x = std::sin(0.3F * static_cast<float>(i / 3 % 64)) / 2.0F;
    ridges.xyz[i] = x;
    ridges.xyz[i + 2] = std::sqrt(1.0F - x * x);
    for (std::size_t c = 0; c < 2; ++c) {
      random = random * 1664525U + 1013904223U;
      noise.xyz[i + c] = static_cast<float>(random >> 8U) / 0x1p24F - 0.5F;
    }
    noise.xyz[i + 2] = std::sqrt(1.0F - noise.xyz[i] * noise.xyz[i] - noise.xyz[i + 1] * noise.xyz[i + 1]);
  }
  REQUIRE(undecided(ridges));
  REQUIRE(undecided(noise));
}

}  // namespace welkin::tests
