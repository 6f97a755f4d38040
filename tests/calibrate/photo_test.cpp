// SPDX-License-Identifier: Apache-2.0
// Photographs from file to albedo. The last test needs photographs: it runs if WELKIN_DATA names a folder with them.
#include "calibrate/photo.h"

#include <tbb/global_control.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "calibrate/report.h"
#include "sh/deterministic.h"
#include "sky/base/atomic_file.h"
#include "sky/base/error.h"
#include "synthetic_chart.h"
#include "tests/folder.h"

using namespace welkin;
using namespace welkin::calibrate;
using tests::Camera;
using tests::Scene;

namespace {

PhotoOptions laterEdition() {
  PhotoOptions options;
  options.reference = referenceChart(Edition::after_2014);
  return options;
}

void writePng(const std::filesystem::path& path, const image::Image& image, bool linear_codes) {
  std::vector<std::uint8_t> code;
  for (const float v : image.rgb)
    code.push_back(
        static_cast<std::uint8_t>(std::lround(255.0 * (linear_codes ? double{v} : det::srgbEncode(double{v})))));
  base::writeFile(path, image::encodePng(image.width, image.height, code));
}

std::string whyRefused(const std::filesystem::path& path, const PhotoOptions& options) {
  try {
    calibratePhoto(path, options);
  } catch (const base::Error& e) {
    CHECK(e.status() == base::ExitStatus::content);
    const std::string what = e.what();
    CHECK(what.starts_with(path.string()));
    return what;
  }
  return "";
}

Camera phone() {
  Camera camera;
  camera.matrix = tests::leakyMatrix();
  camera.noise = 1.5 / 255.0;
  return camera;
}

}  // namespace

TEST_CASE("Photo, FromFileToAlbedoForAnyThreads") {
  const tests::Folder folder;
  const PhotoOptions options = laterEdition();
  const Scene scene;
  writePng(folder / "chart.png", photograph(options.reference, scene, phone()), false);
  const auto calibrated = [&](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    const CalibratedPhoto photo = calibratePhoto(folder / "chart.png", options);
    return std::pair(albedoOf(photo.image, photo.calibration.model).rgb, reportJson(photo, options.reference).dump());
  };
  const auto one = calibrated(1), four = calibrated(4);
  CHECK(one.first == four.first);
  CHECK(one.second == four.second);

  const CalibratedPhoto photo = calibratePhoto(folder / "chart.png", options);
  REQUIRE(photo.charts.size() == 1);
  CHECK(!photo.linear_codes);
  CHECK(photo.charts[0].confidence > 0.97);
  CHECK(photo.warnings.empty());
  // Neutral 5, in the middle of its patch, is an albedo of 0.19. Noise of a texel is 1.5 codes, 3 % there; times 3.
  const image::Image albedo = albedoOf(photo.image, photo.calibration.model);
  const Point at = photo.charts[0].place.pixelOf(21, 0.5, 0.5);
  const auto texel = static_cast<std::size_t>(at.y()) * 640 + static_cast<std::size_t>(at.x());
  for (std::size_t c = 0; c < 3; ++c)
    CHECK(double{albedo.rgb[3 * texel + c]} == Approx(options.reference[21][static_cast<int>(c)]).epsilon(0.1));
}

TEST_CASE("Photo, LinearCodesAreKnownByTheErrorLeftOut") {
  const tests::Folder folder;
  PhotoOptions options = laterEdition();
  Camera camera = phone();
  camera.quantised = false;
  camera.noise = 0.0;
  writePng(folder / "raw.png", photograph(options.reference, {}, camera), true);
  const CalibratedPhoto chosen = calibratePhoto(folder / "raw.png", options);
  CHECK(chosen.linear_codes);
  CHECK(summaryOf(chosen.calibration.errors().left_out).mean < 1.5);
  options.encoding = Encoding::srgb;
  const CalibratedPhoto wrong = calibratePhoto(folder / "raw.png", options);
  CHECK(!wrong.linear_codes);
  CHECK(summaryOf(wrong.calibration.errors().left_out).mean > summaryOf(chosen.calibration.errors().left_out).mean);
}

TEST_CASE("Photo, CornersByHandAndRefusals") {
  const tests::Folder folder;
  PhotoOptions options = laterEdition();
  const Scene scene;
  writePng(folder / "chart.png", photograph(options.reference, scene, phone()), false);
  options.corners = scene.corners;
  const CalibratedPhoto photo = calibratePhoto(folder / "chart.png", options);
  CHECK(photo.charts[0].place.corners() == scene.corners);
  options.corners = Corners{Point(10.0, 10.0), Point(90.0, 10.0), Point(90.0, 80.0), Point(10.0, 80.0)};
  CHECK(whyRefused(folder / "chart.png", options).find("the chart at --corners: ") != std::string::npos);
  options.corners.reset();

  ReferenceChart wall;
  wall.fill(Colour::Constant(0.02));
  writePng(folder / "wall.png", photograph(wall, scene, phone()), false);
  CHECK(whyRefused(folder / "wall.png", options) != "");
}

TEST_CASE("Report, HasTheFormThatTheCommandPromises") {
  const tests::Folder folder;
  const PhotoOptions options = laterEdition();
  writePng(folder / "chart.png", photograph(options.reference, {}, phone()), false);
  const CalibratedPhoto photo = calibratePhoto(folder / "chart.png", options);
  const nlohmann::ordered_json json = summaryJson(photo);
  std::vector<std::string> keys;
  for (const auto& [key, value] : json.items()) keys.push_back(key);
  CHECK(keys == std::vector<std::string>{"charts", "model", "rss", "de2000"});
  CHECK(json["charts"].size() == 1);
  CHECK(json["charts"][0]["corners"].size() == 4);
  CHECK(json["charts"][0]["corners"][3].size() == 2);
  for (const char* stage : {"before", "fit", "left_out"}) {
    const auto& s = json["de2000"][stage];
    CHECK(s.size() == 3);
    CHECK(s["mean"].get<double>() <= s["p95"].get<double>());
    CHECK(s["p95"].get<double>() <= s["worst"].get<double>());
  }
  CHECK(reportJson(photo, options.reference)["patches"].size() == kPatches);
}

TEST_CASE("Photo, RealChartsAreFoundAndOthersRefused") {
  const char* data = std::getenv("WELKIN_DATA");
  if (data == nullptr) {
    WARN("skipped: WELKIN_DATA names no folder with calibration/");
    return;
  }
  const std::filesystem::path folder = std::filesystem::path(data) / "calibration";
  const std::vector<std::byte> bytes = base::readFile(folder / "ground_truth.json");
  const auto truth = nlohmann::json::parse(reinterpret_cast<const char*>(bytes.data()),
                                           reinterpret_cast<const char*>(bytes.data()) + bytes.size());
  REQUIRE(truth.size() >= 7);
  constexpr double kQuarterOfPatch = 0.25;  // the middle half of a patch then lies within it
  for (const auto& [name, expected] : truth.items()) {
    INFO(name);
    if (!expected.contains("box_darkskin_bluishgreen_black_white")) {
      CHECK(whyRefused(folder / name, laterEdition()) != "");
      continue;
    }
    const CalibratedPhoto photo = calibratePhoto(folder / name, laterEdition());
    const auto& box = expected["box_darkskin_bluishgreen_black_white"];
    const ChartPlace& place = photo.charts[0].place;
    for (std::size_t i = 0; i < 4; ++i) {
      const Point corner(box[i][0].get<double>(), box[i][1].get<double>());
      CHECK((place.corners()[i] - corner).norm() < kQuarterOfPatch * place.shortestSide());
    }
    const ModelErrors& errors = photo.calibration.errors();
    CHECK(summaryOf(errors.left_out).mean < summaryOf(photo.calibration.before).mean);
  }
}

TEST_CASE("Photo, FullCodesCountWhereAProfileTakesThemPastWhite") {
  image::Image image;
  image.width = 2;
  image.height = 1;
  const double full = clippingLevel(image, false);
  image.rgb = {0.5F, 0.5F, 0.5F, 1.2249F, -0.042F, -0.0196F};  // the second is full red of Display P3
  CHECK(clippingLevel(image, false) == full);
  CHECK(full < 1.0);
  image.rgb[3] = 7.0F;  // a picture of light, whose numbers have no end
  CHECK(clippingLevel(image, false) == std::numeric_limits<double>::infinity());
}
