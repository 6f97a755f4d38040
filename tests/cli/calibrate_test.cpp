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

TEST_CASE("Calibrate, AProfileServesAFolderOfTheSameLight") {
  const Folder folder;
  writePhoto(folder / "chart.png", chart());
  std::filesystem::create_directory(folder / "in");
  image::Image wall = chart();
  wall.height = 50;  // above the chart
  wall.rgb.resize(std::size_t{3} * 50 * static_cast<std::size_t>(wall.width));
  writePhoto(folder / "in/a.png", wall);
  writePhoto(folder / "in/b.png", wall);
  const std::string in = folder / "in";
  REQUIRE(runTool({"calibrate", folder / "chart.png", "-o", folder / "chart"}).status == 0);
  const Run saved = runTool({"calibrate", in, "-o", folder / "saved", "--apply", folder / "chart/profile.json"});
  CAPTURE(saved.err);
  REQUIRE(saved.status == 0);
  CHECK(saved.out.find("a.png: ") == 0);
  const Run direct =
      runTool({"calibrate", in, "-o", folder / "direct", "--apply", folder / "chart.png", "--threads", "1"});
  REQUIRE(direct.status == 0);
  for (const char* file : {"a.exr", "a.report.json", "b.exr"})
    CHECK(readBytes(folder.path() / "saved" / file) == readBytes(folder.path() / "direct" / file));
  const Run again = runTool({"calibrate", in, "-o", folder / "saved", "--apply", folder / "chart/profile.json"});
  CHECK(again.status == 0);
  CHECK(again.out.find("a.png: ") == 0);
  CHECK(again.out.find("up to date") != std::string::npos);
  CHECK_FALSE(std::filesystem::exists(folder / "saved/a.report.png"));
  const Run own =
      runTool({"calibrate", folder / "chart.png", "-o", folder / "own", "--apply", folder / "chart/profile.json"});
  CHECK(own.out.find("CIEDE2000 on the fit's own chart ") != std::string::npos);
  CHECK(std::filesystem::exists(folder / "own/report.png"));

  const Run without = runTool({"calibrate", in, "-o", folder / "without", "--json"});
  CHECK(without.status == 3);
  CHECK(without.said("2 of 2 photographs failed"));
  const json printed = json::parse(without.out);
  CHECK(printed["photographs"].empty());
  CHECK(printed["failed"][1]["photo"] == "b.png");
  CHECK(runTool({"calibrate", in, "-o", folder / "without", "--corners", "1,1,9,1,9,9,1,9"}).status == 1);
  folder.write("bad.json", "{}");
  const Run bad = runTool({"calibrate", in, "-o", folder / "without", "--apply", folder / "bad.json"});
  CHECK(bad.status == 3);
  CHECK(bad.said("no profile of `welkin calibrate`"));
}

TEST_CASE("Calibrate, CheckNamesTheWorstAlbedoAndEndsByIt") {
  const Folder folder;
  image::Image grey;
  grey.width = 4;
  grey.height = 4;
  grey.rgb.assign(48, 0.3F);
  std::filesystem::create_directory(folder / "albedo");
  writePhoto(folder / "albedo/plaster.png", grey);
  CHECK(runTool({"calibrate", "--check", folder / "albedo"}).status == 0);
  grey.rgb.assign(48, 0.95F);
  writePhoto(folder / "albedo/snow.png", grey);
  const Run run = runTool({"calibrate", "--check", folder / "albedo", "--json"});
  CHECK(run.status == 3);
  CHECK(run.said("snow.png"));
  const json printed = json::parse(run.out);
  CHECK(printed["passed"] == false);
  CHECK(printed["albedo"][0]["name"] == "snow.png");
  CHECK(printed["albedo"][0]["bright"] == 1.0);
  CHECK(printed["albedo"][1]["bright"] == 0.0);
  CHECK(runTool({"calibrate", "--check", folder / "albedo", "--allowed", "100"}).status == 0);
  CHECK(runTool({"calibrate", "--check", folder / "none.png"}).status == 2);
  CHECK(runTool({"calibrate", folder / "albedo/snow.png"}).status == 1);

  // A model's texture passes by itself, and not with the colour that its material multiplies.
  const auto model = [&](const std::string& factor) {
    folder.write("model.obj",
                 "mtllib model.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nusemtl wall\n"
                 "f 1/1 2/2 3/3\n");
    folder.write("model.mtl", "newmtl wall\nKd " + factor + "\nmap_Kd albedo/plaster.png\n");
    return runTool({"calibrate", "--check", folder / "model.obj"});
  };
  const Run white = model("1 1 1");
  CAPTURE(white.err, white.out);
  CHECK(white.status == 0);
  CHECK(white.out.find("plaster.png") != std::string::npos);
  const Run black = model("0.01 0.01 0.01");
  CHECK(black.status == 3);
  CHECK(black.said("plaster.png"));
}
