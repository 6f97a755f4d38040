// SPDX-License-Identifier: Apache-2.0
// Profiles as files, and folders of photographs.
#include "calibrate/batch.h"

#include <tbb/global_control.h>

#include <catch2/catch.hpp>
#include <cmath>

#include "sky/base/atomic_file.h"
#include "synthetic_chart.h"
#include "tests/folder.h"

using namespace welkin;
using namespace welkin::calibrate;
using tests::writeCoded;

namespace {

image::Image chartThrough(std::uint64_t seed) {
  tests::Camera camera;
  camera.matrix = tests::leakyMatrix();
  camera.noise = 1.0 / 255.0;
  tests::Scene scene;
  scene.seed = seed;
  return photograph(referenceChart(Edition::after_2014), scene, camera);
}

Batch batchInto(const std::filesystem::path& folder) {
  Batch batch;
  batch.photo.reference = referenceChart(Edition::after_2014);
  batch.photo.model = "3x3";
  batch.folder = folder;
  return batch;
}

std::string whyNoProfile(const tests::Folder& folder, const std::string& text) {
  const std::string path = folder.write("profile.json", text);
  try {
    readProfile(path);
  } catch (const base::Error& e) {
    CHECK(e.status() == base::ExitStatus::content);
    const std::string what = e.what();
    REQUIRE(what.starts_with(path + ": "));
    return what.substr(path.size() + 2);
  }
  return "";
}

std::string matrixProfile(const std::string& numbers, const std::string& brightest = "[0.5, 0.25, 1]",
                          const std::string& model = "3x3", const std::string& input = "linear") {
  return R"({"format": "welkin calibration 1", "input": ")" + input + R"(", "model": ")" + model + R"(", "numbers": )" +
         numbers + R"(, "brightest": )" + brightest + "}";
}

}  // namespace

TEST_CASE("Profile, EveryModelIsReadAsItWasWritten") {
  const tests::Folder folder;
  std::vector<Pair> pairs;
  for (const Colour& wanted : referenceChart(Edition::after_2014))
    pairs.push_back({tests::leakyMatrix() * wanted, wanted});
  for (const ModelKind& kind : models()) {
    INFO(kind.name);
    const Profile profile{{&kind, *kind.fit(pairs)}, kind.name[0] == 'a', Colour(0.9, 0.8, 0.7), ""};
    const Profile read = readProfile(folder.write("profile.json", profileJson(profile).dump()));
    CHECK(read.model.kind == &kind);
    CHECK(read.model.numbers == profile.model.numbers);
    CHECK(read.linear_codes == profile.linear_codes);
    CHECK(read.brightest == profile.brightest);
  }
}

TEST_CASE("Profile, BadOnesAreRefusedByKey") {
  const tests::Folder folder;
  const std::string nine = "[1, 0, 0, 0, 1, 0, 0, 0, 1]";
  CHECK(whyNoProfile(folder, matrixProfile(nine)) == "");
  for (const std::string text : {"", "{}", "[]", "{\"format\": 1}", "\"welkin calibration 1\""})
    CHECK(whyNoProfile(folder, text).starts_with("no profile of `welkin calibrate`"));
  CHECK(whyNoProfile(folder, std::string(100, '[')).starts_with("no profile"));
  CHECK(whyNoProfile(folder, matrixProfile("[1, 2]")) == "numbers: 2 numbers; 9 are wanted");
  for (const std::string bad : {"\"1\"", "1e7", "-1e7", "null", "[1]"})
    CHECK(whyNoProfile(folder, matrixProfile("[1, 0, 0, 0, 1, 0, 0, 0, " + bad + "]")) ==
          "numbers: numbers from -1000000 to 1000000 are allowed");
  CHECK(whyNoProfile(folder, matrixProfile(nine, "[1, 0, 1]")) == "brightest: numbers above 0 are allowed");
  CHECK(whyNoProfile(folder, matrixProfile(nine, "[1, 1, 1]", "4x4")).starts_with("model: \"4x4\"; "));
  CHECK(whyNoProfile(folder, matrixProfile(nine, "[1, 1, 1]", "3x3", "raw")).starts_with("input: \"raw\"; "));
  std::string zeros = "[0";  // the curve's scale, by which it divides
  for (std::size_t i = 1; i < modelNamed("curve-affine")->count; ++i) zeros += ", 1";
  CHECK(whyNoProfile(folder, matrixProfile(zeros + "]", "[1, 1, 1]", "curve-affine")).starts_with("numbers: some"));
}

TEST_CASE("Profile, TexelsPastTheChartAreCountedInEveryChannel") {
  const Profile profile{{modelNamed("3x3"), {}}, false, Colour(0.5, 0.25, 0.75), ""};
  image::Image image;
  image.width = 4;
  image.height = 1;
  image.rgb = {0.5F, 0.25F, 0.75F, 0.6F, 0.1F, 0.1F, 0.1F, 0.3F, 0.1F, 0.1F, 0.1F, 0.8F};
  CHECK(partPastChart(image, profile) == 0.75);
}

TEST_CASE("Batch, AFolderIsTheSameForAnyThreadsAndIsResumed") {
  const tests::Folder folder;
  for (const std::uint64_t seed : {1U, 2U, 3U})
    writeCoded(folder / (std::to_string(seed) + ".png"), chartThrough(seed));
  const auto made = [&](std::size_t threads, bool resume) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    const Batch batch = batchInto(folder / ("out" + std::to_string(threads)));
    base::makeFolder(batch.folder);
    return makeAll(jobsIn(folder.path(), batch), batch, resume, {});
  };
  const BatchResult one = made(1, false), four = made(4, false);
  REQUIRE(one.made.size() == 3);
  REQUIRE(one.failed.empty());
  const std::vector<std::string> files = tests::filesUnder(folder / "out1");
  CHECK(files == tests::filesUnder(folder / "out4"));
  CHECK(files.size() == 12);
  for (const std::string& file : files)
    CHECK(tests::readBytes(folder.path() / "out1" / file) == tests::readBytes(folder.path() / "out4" / file));

  const BatchResult again = made(1, true);
  for (const Made& m : again.made) CHECK(m.up_to_date);
  CHECK(again.made[1].report == one.made[1].report);
  tests::flipBit(folder / "out1/2.exr", 400);
  writeCoded(folder / "3.png", chartThrough(4));
  const BatchResult some = made(1, true);
  CHECK(some.made[0].up_to_date);
  CHECK_FALSE(some.made[1].up_to_date);
  CHECK_FALSE(some.made[2].up_to_date);
  CHECK(tests::readBytes(folder / "out1/2.exr") == tests::readBytes(folder / "out4/2.exr"));
}

TEST_CASE("Batch, AProfileMakesOfAPhotographWithoutAChartWhatItMakesOfTheChart") {
  const tests::Folder folder;
  std::filesystem::create_directory(folder / "in");
  writeCoded(folder / "chart.png", chartThrough(1));
  image::Image wall = chartThrough(1);
  wall.width = 64;  // a strip of it, which holds no chart
  wall.height = 64;
  wall.rgb.resize(std::size_t{3} * 64 * 64);
  writeCoded(folder / "in/wall.png", wall);
  Batch batch = batchInto(folder.path());
  const Profile profile = profileOf(calibratePhoto(folder / "chart.png", batch.photo));
  const BatchResult without = makeAll(jobsIn(folder / "in", batch), batch, false, {});
  REQUIRE(without.failed.size() == 1);
  CHECK(without.failed[0].photo == "wall.png");
  CHECK(without.failed[0].error.status() == base::ExitStatus::content);
  CHECK_FALSE(std::filesystem::exists(folder / "wall.exr"));

  batch.profile = profile;
  const BatchResult with = makeAll(jobsIn(folder / "in", batch), batch, false, {});
  REQUIRE(with.failed.empty());
  const image::Image albedo = image::readImage(std::filesystem::path(folder / "wall.exr"));
  const image::Image read = image::readImage(std::filesystem::path(folder / "in/wall.png"));
  const image::Image wanted = albedoOf(read, profile.model);
  constexpr double kHalf = 1.0 / 2048;  // rounding of a half float
  for (std::size_t i = 0; i < wanted.rgb.size(); ++i)
    REQUIRE(double{albedo.rgb[i]} == Approx(double{wanted.rgb[i]}).epsilon(kHalf).margin(1e-7));
}

TEST_CASE("Batch, FoldersThatCannotBeMadeAreRefused") {
  const tests::Folder folder;
  const auto why = [&](const Batch& batch) -> std::string {
    try {
      jobsIn(folder.path(), batch);
    } catch (const base::Error& e) {
      return e.what();
    }
    return "";
  };
  Batch batch = batchInto(folder / "out");
  CHECK(why(batch) == folder.path().string() + ": no pictures: png, jpg, jpeg, tif, tiff and exr are read");
  folder.write("a.png", "x");
  folder.write("b.txt", "x");
  CHECK(why(batch) == "");
  folder.write("a.JPG", "x");
  CHECK(why(batch) == folder / "a.png" + ": another picture has the same name but for its ending");
  std::filesystem::remove(folder / "a.JPG");
  batch.format = "png";
  folder.write("a.report.tif", "x");
  CHECK(why(batch) == folder / "a.report.tif" + ": another picture's files hold a.report.png, too");
  std::filesystem::remove(folder / "a.report.tif");
  CHECK_THROWS_AS(singleJob(folder / "report.jpg", batch), base::Error);
  batch.folder = folder.path();
  CHECK(why(batch).find("is an input and would be overwritten") != std::string::npos);
}
