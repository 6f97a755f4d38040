// SPDX-License-Identifier: Apache-2.0
// welkin calibrate: its files and JSON on a synthetic chart, and how it ends on bad input.
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "run_tool.h"
#include "sh/deterministic.h"
#include "sky/base/atomic_file.h"
#include "tests/calibrate/synthetic_chart.h"

using namespace welkin;
using namespace welkin::tests;
using nlohmann::json;

namespace {

void writePhoto(const std::filesystem::path& path, const image::Image& image) {
  std::vector<std::uint8_t> code;
  for (const float v : image.rgb)
    code.push_back(static_cast<std::uint8_t>(std::lround(255.0 * det::srgbEncode(double{v}))));
  base::writeFile(path, image::encodePng(image.width, image.height, code));
}

image::Image chart() {
  Camera camera;
  camera.matrix = leakyMatrix();
  return photograph(calibrate::referenceChart(calibrate::Edition::after_2014), {}, camera);
}

}  // namespace

TEST_CASE("Calibrate, WritesAlbedoAndAReportAndPrintsJson") {
  const Folder folder;
  writePhoto(folder / "chart.png", chart());
  const Run run = runTool({"calibrate", folder / "chart.png", "-o", folder / "out", "--json"});
  CAPTURE(run.err);
  REQUIRE(run.status == 0);
  const json printed = json::parse(run.out);
  REQUIRE(printed["charts"].size() == 1);
  REQUIRE(printed["charts"][0]["corners"].size() == 4);
  CHECK(printed["charts"][0]["confidence"].get<double>() > 0.95);
  const Scene scene;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t axis = 0; axis < 2; ++axis)
      CHECK(printed["charts"][0]["corners"][i][axis].get<double>() ==
            Approx(scene.corners[i][static_cast<Eigen::Index>(axis)]).margin(6.0));
  for (const char* which : {"before", "fit", "left_out"})
    for (const char* what : {"mean", "p95", "worst"}) CHECK(printed["de2000"][which][what].get<double>() > 0.0);
  CHECK(printed["de2000"]["left_out"]["mean"] < printed["de2000"]["before"]["mean"]);
  const json report = json::parse(readBytes(folder / "out/report.json"));
  CHECK(report["photo"] == "chart.png");
  CHECK(report["albedo"] == "chart.exr");
  CHECK(report["model"] == printed["model"]);
  CHECK(std::filesystem::exists(folder / "out/chart.exr"));
}

TEST_CASE("Calibrate, NeverWritesOverItsInput") {
  const Folder folder;
  writePhoto(folder / "chart.png", chart());
  const std::string before = readBytes(folder / "chart.png");
  const Run run = runTool({"calibrate", folder / "chart.png", "-o", folder.path().string(), "--format", "png"});
  CHECK(run.status == 1);
  CHECK(run.said("is an input and would be overwritten"));
  CHECK(readBytes(folder / "chart.png") == before);
  CHECK_FALSE(std::filesystem::exists(folder / "report.json"));
}

TEST_CASE("Calibrate, BadInputHasAReason") {
  const Folder folder;
  image::Image grey = chart();
  for (float& v : grey.rgb) v = 0.2F;
  writePhoto(folder / "wall.png", grey);
  const Run wall = runTool({"calibrate", folder / "wall.png", "-o", folder / "out"});
  CHECK(wall.status == 3);
  CHECK(wall.said("wall.png: no ColorChecker Classic was found"));
  image::Image dead = chart();
  for (std::size_t i = 1; i < dead.rgb.size(); i += 3) dead.rgb[i] = 0.0F;
  writePhoto(folder / "dead.png", dead);
  const Run channel =
      runTool({"calibrate", folder / "dead.png", "-o", folder / "out", "--corners", "120,100,520,100,520,370,120,370"});
  CAPTURE(channel.err);
  CHECK(channel.status == 3);
  CHECK(channel.said("its channel g has no light"));
  CHECK(runTool({"calibrate", folder / "none.png", "-o", folder / "out"}).status == 2);
  CHECK(runTool({"calibrate", folder / "dead.png", "-o", folder / "out", "--model", "best"}).status == 1);
  CHECK(runTool({"calibrate", folder / "dead.png", "-o", folder / "out", "--corners", "1,2,3"}).status == 1);
  CHECK_FALSE(std::filesystem::exists(folder / "out/report.json"));
}
