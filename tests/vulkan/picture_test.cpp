// SPDX-License-Identifier: Apache-2.0
// Exposure, tone mapping, contact sheets and PNG files.
#include "render/picture.h"

#include <OpenImageIO/imageio.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "shared.h"
#include "sky/base/error.h"

namespace welkin::tests {

namespace {

render::FloatImage uniformImage(float value) {
  render::FloatImage image{16, 16, std::vector<float>(std::size_t{4} * 16 * 16, value)};
  return image;
}

double meanCode(const render::Picture& picture) {
  double sum = 0.0;
  for (const uint8_t v : picture.rgb) sum += v;
  return sum / static_cast<double>(picture.rgb.size());
}

}  // namespace

TEST_CASE("Tone, CurvesMeetTheirClosedForms", "[picture]") {
  CHECK(f64::srgbEncode(0.0) == 0.0);
  CHECK(f64::srgbEncode(1.0) == Approx(1.0).margin(1e-12));
  CHECK(f64::srgbEncode(0.0031308) == Approx(0.0404499).margin(1e-6));
  CHECK(f64::srgbEncode(0.214041) == Approx(0.5).margin(1e-5));
  CHECK(render::filmic(0.0) == 0.0);
  CHECK(render::filmic(1e30) == Approx(1.0));
  for (double x = 0.0; x < 20.0; x += 0.01) CHECK(render::filmic(x + 0.01) >= render::filmic(x));
}

TEST_CASE("Tone, NightStaysDarkerThanDay", "[picture]") {
  const double day = 3.0;
  CHECK(day * render::automaticExposure(day, day) == Approx(0.18));
  double brighter = 1e30;
  for (double luminance = day; luminance > 1e-9; luminance *= 0.5) {
    const double shown = luminance * render::automaticExposure(luminance, day);
    CHECK(shown < brighter);
    brighter = shown;
  }
  CHECK(render::automaticExposure(0.0, 0.0) == 1.0);
  CHECK(std::isfinite(render::automaticExposure(0.0, day)));
  CHECK(render::automaticExposure(5.0, day) * 5.0 == Approx(0.18));
}

TEST_CASE("Tone, LogAverageIgnoresBlack", "[picture]") {
  render::FloatImage images[2] = {uniformImage(4.0F), uniformImage(0.25F)};
  CHECK(render::logAverageLuminance(images) == Approx(1.0));
  for (std::size_t i = 0; i < 64; ++i) images[1].rgba[i] = 0.0F;
  CHECK(render::logAverageLuminance({&images[0], 1}) == Approx(4.0));
  CHECK(render::logAverageLuminance({&images[1], 1}) == Approx(0.25));
  const render::FloatImage black = uniformImage(0.0F);
  CHECK(render::logAverageLuminance({&black, 1}) == 0.0);
}

TEST_CASE("Tone, DitherKeepsTheMean", "[picture]") {
  for (const float value : {0.01F, 0.1F, 0.18F, 0.5F}) {
    const double code = 255.0 * f64::srgbEncode(render::filmic(double{value}));
    CHECK(meanCode(render::tonemap(uniformImage(value), 1.0)) ==
          Approx(code).margin(1.0 / 64.0));  // the matrix has 64 levels
  }
  CHECK(meanCode(render::tonemap(uniformImage(0.0F), 1.0)) == 0.0);
}

TEST_CASE("Picture, ClockLabelRoundsToMinutes", "[picture]") {
  CHECK(render::clockLabel(0.0) == "00:00");
  CHECK(render::clockLabel(6.5) == "06:30");
  CHECK(render::clockLabel(23.9999) == "00:00");
  CHECK(render::clockLabel(13.0 + 59.4 / 60.0) == "13:59");
}

TEST_CASE("Picture, SheetHoldsEveryPicture", "[picture]") {
  const render::Picture red{4, 3, std::vector<uint8_t>(36, 200)};
  const render::Picture blue{4, 2, std::vector<uint8_t>(24, 90)};
  const render::Picture sheet = render::contactSheet({{"06:00", {red, blue}}, {"12:00", {red, blue}}});
  CHECK(sheet.width == 3 * 8 + 2 * 4);
  CHECK(sheet.rgb.size() == std::size_t{3} * sheet.width * sheet.height);
  CHECK(std::count(sheet.rgb.begin(), sheet.rgb.end(), 90) >= 48);
  CHECK(sheet.rgb[std::size_t{3} * ((sheet.height - 9) * sheet.width + 8)] == 90);
  CHECK(sheet.rgb[std::size_t{3} * ((sheet.height - 8 - 2 - 8 - 3) * sheet.width + 8 + 4 + 8 + 3)] == 200);
}

TEST_CASE("Picture, PngComesBackAsWritten", "[picture]") {
  const auto folder = std::filesystem::temp_directory_path() / ("welkin_picture_" + std::to_string(std::rand()));
  std::filesystem::create_directories(folder);
  render::Picture picture{5, 4, {}};
  for (int i = 0; i < 60; ++i) picture.rgb.push_back(static_cast<uint8_t>(4 * i));
  const std::string path = (folder / "a.png").string();
  render::writePng(picture, path);
  const auto input = OIIO::ImageInput::open(path);
  REQUIRE(input);
  std::vector<uint8_t> back(60);
  REQUIRE(input->read_image(0, 0, 0, 3, OIIO::TypeDesc::UINT8, back.data()));
  CHECK(back == picture.rgb);
  CHECK(input->spec().width == 5);
  for (const auto& bad : {folder / "missing" / "a.png", folder}) {
    try {
      render::writePng(picture, bad.string());
      FAIL("written to " << bad);
    } catch (const base::Error& error) {
      CHECK(error.status() == base::ExitStatus::file);
    }
  }
  CHECK(std::distance(std::filesystem::directory_iterator(folder), std::filesystem::directory_iterator()) == 1);
  std::filesystem::remove_all(folder);
}

}  // namespace welkin::tests
