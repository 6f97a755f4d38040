// SPDX-License-Identifier: Apache-2.0
// welkin render from the shell. tests/vulkan checks the pictures.
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "level_text.h"
#include "run_tool.h"
#include "sky_text.h"

using namespace welkin::tests;
namespace fs = std::filesystem;
using nlohmann::json;

namespace {

const Setting kNoDevice = {
    {{"VK_ICD_FILENAMES", "/nonexistent"}, {"VK_DRIVER_FILES", "/nonexistent"}}, "", "", 0, 60.0};

std::string bakedFolder(const Folder& folder) {
  const std::string sky = folder.write("sky.toml", skyText(kUniform, kStillSun, "keys = 2\ncubemap_size = 4"));
  REQUIRE(runTool({"bake", sky, "-o", folder / "out"}).status == 0);
  return folder / "out";
}

}  // namespace

TEST_CASE("Render, WritesAPngOfTheSizeAskedFor") {
  if (!fs::exists(WELKIN_TEST_ICD)) {
    WARN("no " WELKIN_TEST_ICD);
    return;
  }
  const Folder folder;
  const Setting lavapipe = {{{"VK_ICD_FILENAMES", WELKIN_TEST_ICD}}, "", "", 0, 120.0};
  const Run run = runTool({"render", bakedFolder(folder), "--time", "-12", "--exposure", "-2", "--yaw", "-20",
                           "--pitch", "-5", "--view", "horizon", "--size", "48x32", "-o", folder / "a.png"},
                          lavapipe);
  INFO(run.err);
  REQUIRE(run.status == 0);
  const std::string png = readBytes(folder / "a.png");
  REQUIRE(png.size() > 33);
  REQUIRE(png.substr(1, 3) == "PNG");
  REQUIRE(png.substr(16, 8) == std::string("\0\0\0\x30\0\0\0\x20", 8));  // IHDR: width and height
}

TEST_CASE("Render, WithoutADeviceIsARefusalOfTheSystem") {
  const Folder folder;
  const Run run = runTool({"render", bakedFolder(folder), "--time", "12", "-o", folder / "a.png"}, kNoDevice);
  INFO(run.err);
  REQUIRE(run.status == 2);
  REQUIRE(run.said("Vulkan"));
  REQUIRE_FALSE(fs::exists(folder / "a.png"));
}

TEST_CASE("Render, LevelErrorsHaveTheirStatus") {
  const Folder folder;
  const std::string sky = bakedFolder(folder);
  const auto check = [&](const std::vector<std::string>& more, int status, const std::string& says) {
    std::vector<std::string> arguments = {"render", sky, "--time", "12", "-o", folder / "a.png"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Run run = runTool(arguments, kNoDevice);
    INFO(run.err);
    CHECK(run.status == status);
    CHECK(run.said(says));
  };
  const std::string level = "[level]\nsky = \"sky.toml\"\n[[geometry]]\nfile = \"a.gltf\"\n";
  const std::string path = folder.write("level.toml", level);
  check({"--level", path}, 2, "a.gltf");  // The file is missing.
  folder.write("a.gltf", "{\"asset\": {\"version\": \"2.0\"}, \"extensionsRequired\": [\"KHR_draco\"]}");
  check({"--level", path}, 3, "KHR_draco");
  folder.write("a.gltf", "{\"asset\": {\"ver");
  check({"--level", path}, 3, "a.gltf");
  folder.write("a.gltf", "{\"asset\": {\"version\": \"2.0\"}}");
  check({"--level", path, "--camera=-1,2,3"}, 3, "nothing to draw");
  check({"--level", folder.write("b.toml", level + "colour = 1\n")}, 3, "geometry[0].colour");
  check({"--level", folder / "none.toml"}, 2, "none.toml");
  check({"--level", path, "--camera", "1,2"}, 1, "--camera");
  check({"--level", path, "--view", "dome"}, 1, "--level");
  check({"--level", path, "--sky-light", "both"}, 1, "--sky-light");
  check({"--level", path, "--occlusion", "baked"}, 1, "--occlusion: 'baked' is none of contact, screen, none");
  check({"--occlusion", "none"}, 1, "--occlusion: only a level");
  check({"--view", "level"}, 1, "--level");
  check({"--no-tint", "--sky", "cubemap"}, 1, "--no-tint");
  check({"--no-reflections"}, 1, "--no-reflections: only a level has materials");
  check({"--level", path, "--component", "occlusion", "--occlusion", "none"}, 1, "--component occlusion: --occlusion");
  check({"--component", "occlusion"}, 1, "--component: only a level");
  check({"--reference"}, 1, "only a level is traced; give --level");
  check({"--level", path, "--reference", "--difference"}, 1, "give one of them");
  check({"--light", "0,0,0,1,1,1"}, 1, "--light: only a level has lamps");
  check({"--level", path, "--light", "0,0,0,1,1"}, 1, "is not a light");
  check({"--level", path, "--json"}, 1, "--json: only --reference");
  check({"--level", path, "--reference", "--component", "occlusion"}, 1, "--component occlusion: the path tracer");
  check({"--level", path, "--compare"}, 1, "is not the folder of a baked level");
  check({"--level", path, "--compare", "--sky-light", "flat"}, 1, "leave --sky-light out");
  check({"--level", path, "--reference", "--paths", "0"}, 1, "--paths");
}

TEST_CASE("Render, ProbesErrorsHaveTheirStatus") {
  const SmallLevel level;
  level.bake("out");
  const auto check = [&](const std::string& probes, int status, const std::string& says) {
    const Run run = runTool({"render", level / "out", "--level", level / "level.toml", "--probes", probes, "--time",
                             "12", "-o", level / "a.png"},
                            kNoDevice);
    INFO(run.err);
    CHECK(run.status == status);
    CHECK(run.said(says));
  };
  check(level / "out", 2, "Vulkan");  // All is well except for the device.
  check(level / "none", 2, level / "none/sectors");
  fs::create_directories(level.path() / "empty/sectors");
  check(level / "empty", 2, "holds no sector");
  const std::string sector = level / "out/sectors/sector_0_0.welkin";
  fs::copy_file(sector, level / "empty/sectors/sector_1_0.welkin");
  check(level / "empty", 3, "holds the sector 0_0");
  fs::resize_file(sector, fs::file_size(sector) - 9);
  check(level / "out", 3, "sector_0_0.welkin");
  const Run run = runTool(
      {"render", level / "out", "--view", "dome", "--probes", level / "out", "--time", "12", "-o", level / "a.png"},
      kNoDevice);
  CHECK(run.status == 1);
  CHECK(run.said("--probes"));
}

TEST_CASE("Render, ProbesAreInThePicture") {
  if (!fs::exists(WELKIN_TEST_ICD)) {
    WARN("no " WELKIN_TEST_ICD);
    return;
  }
  const SmallLevel level;
  level.bake("out");
  const Setting lavapipe = {{{"VK_ICD_FILENAMES", WELKIN_TEST_ICD}}, "", "", 0, 120.0};
  const auto draw = [&](const std::string& name, const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"render",   level / "out", "--level", level / "level.toml", "--time",
                                          "10",       "--size",      "64x48",   "--exposure",         "0",
                                          "--camera", "30,3,40",     "-o",      level / name};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Run run = runTool(arguments, lavapipe);
    INFO(run.err);
    REQUIRE(run.status == 0);
    return readBytes(level / name);
  };
  const std::string without = draw("a.png", {});
  const std::string with = draw("b.png", {"--probes", level / "out"});
  REQUIRE(with != without);
  REQUIRE(draw("c.png", {"--probes", level / "out"}) == with);
  level.writeLevel("rays = 64", "add = []\n[scale]\nsky = 0\nsun_bounce = 0");
  REQUIRE(draw("d.png", {"--probes", level / "out"}) != with);  // black
}

TEST_CASE("Render, ABakedLevelFindsItsLevelFile") {
  const SmallLevel level;
  level.bake("out");
  const auto draw = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"render", level / "out", "--time", "12", "-o", level / "a.png"});
    return runTool(more, kNoDevice);
  };
  const std::string other = "is not as it was when " + (level / "out") + " was baked, or is another level";
  const Run same = draw({});
  INFO(same.err);
  CHECK(same.status == 2);  // All is well except for the device.
  CHECK(same.said("Vulkan"));
  CHECK_FALSE(same.said(other));

  fs::create_directory(level / "moved");
  for (const char* name : {"level.toml", "level.gltf", "sky.toml"})
    if (fs::exists(level / name)) fs::copy_file(level / name, level / "moved/" + name);
  std::ofstream(level / "moved/level.toml", std::ios::app) << "\n# Another one.\n";
  CHECK(draw({"--level", level / "moved/level.toml"}).said((level / "moved/level.toml") + " " + other));

  fs::rename(level / "level.toml", level / "renamed.toml");
  const Run none = draw({});
  INFO(none.err);
  CHECK(none.status == 2);
  CHECK(none.said("its level.toml is not there"));
  CHECK(none.said("--level names the file"));
  CHECK_FALSE(draw({"--level", level / "renamed.toml"}).said(other));
  CHECK(draw({"--view", "dome"}).said("Vulkan"));  // needs no level.toml

  std::ofstream(level / "out/timing.json") << "{\"level\": \"../renamed.toml\"}";
  CHECK(draw({}).said("Vulkan"));
  std::ofstream(level / "out/timing.json") << "{\"level\": 3}";
  CHECK(draw({}).said("its level.toml is not there"));
}

TEST_CASE("Render, ThePathTracersPictureIsThatOfOpenGround") {
  if (!fs::exists(WELKIN_TEST_ICD)) {
    WARN("no " WELKIN_TEST_ICD);
    return;
  }
  const SmallLevel level(1024);
  std::ofstream(level / "sky.toml") << skyText(kUniform, "path = [[0, 200, 40]]\nilluminance = 2.0");
  level.bake("out");
  const Setting lavapipe = {{{"VK_ICD_FILENAMES", WELKIN_TEST_ICD}}, "", "", 0, 240.0};
  const auto draw = [&](const std::string& name, const std::vector<std::string>& more) {
    // Over open ground, far from the hut.
    std::vector<std::string> arguments = {"render",     level / "out", "--level", level / "level.toml",
                                          "--time",     "9",           "--size",  "32x24",
                                          "--camera",   "20,3,32",     "--yaw",   "270",
                                          "--pitch",    "-10",         "--paths", "32",
                                          "--progress", "none",        "-o",      level / name,
                                          "--json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Run run = runTool(arguments, lavapipe);
    INFO(run.err);
    REQUIRE(run.status == 0);
    return json::parse(run.out)["pictures"][0];
  };
  const json one = draw("a.png", {"--reference", "--threads", "1"});
  CHECK(draw("b.png", {"--reference", "--threads", "4"}) == one);
  CHECK(readBytes(level / "a.png") == readBytes(level / "b.png"));
  CHECK(one["paths"] == 32);
  CHECK(one["time_h"] == 9.0);
  CHECK(one["error"]["probes"]["pixels"] > 300);
  CHECK(double{one["error"]["nothing"]["mean"]} == Approx(-1.0).epsilon(1e-6));
  CHECK_FALSE(one.contains("frame_to_query"));  // a query has no sun
  // A uniform sky over flat ground is what probes can hold: see SampleLevel.
  CHECK(double{one["error"]["probes"]["rms"]} < 0.06);
  const json compared = draw("c.png", {"--compare"});
  CHECK(compared["error"]["probes"] == one["error"]["probes"]);
  CHECK(compared["error"]["flat"].contains("worst"));
  CHECK(compared["mean_irradiance"] == one["mean_irradiance"]);
  const json ambient = draw("d.png", {"--difference", "--component", "ambient"});
  CHECK(double{ambient["mean_irradiance"]} < double{one["mean_irradiance"]});
  CHECK(double{ambient["error"]["query"]["rms"]} < 0.06);
  // On open ground the volume's halfs and the filter's 8 bits are all that parts the two.
  CHECK(std::abs(double{ambient["frame_to_query"]["worst"]}) < 0.01);
  const json sky = draw("e.png", {"--difference", "--component", "sky"});
  const json sun = draw("f.png", {"--difference", "--component", "sun-bounce"});
  CHECK(double{sky["mean_irradiance"]} + double{sun["mean_irradiance"]} ==
        Approx(double{ambient["mean_irradiance"]}).epsilon(1e-4));
  CHECK(draw("g.png", {"--reference", "--sky-light", "sh"})["error"].contains("sh"));
}

TEST_CASE("Render, LampsAndOcclusionAreInThePicture") {
  if (!fs::exists(WELKIN_TEST_ICD)) {
    WARN("no " WELKIN_TEST_ICD);
    return;
  }
  const SmallLevel level;
  level.writeLevel("rays = 64\nlocal_lights = true");
  level.bake("out");
  const Setting lavapipe = {{{"VK_ICD_FILENAMES", WELKIN_TEST_ICD}}, "", "", 0, 240.0};
  const auto draw = [&](const std::string& name, const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"render",     level / "out", "--level", level / "level.toml",
                                          "--time",     "10",          "--size",  "32x24",
                                          "--exposure", "0",           "-o",      level / name};
    // Towards the hut.
    arguments.insert(arguments.end(), {"--camera", "160,3,38", "--yaw", "50", "--progress", "none"});
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Run run = runTool(arguments, lavapipe);
    INFO(run.err);
    REQUIRE(run.status == 0);
    return run.out;
  };
  draw("a.png", {});
  draw("b.png", {"--component", "occlusion"});
  CHECK(readBytes(level / "a.png") != readBytes(level / "b.png"));
  const auto local = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"--difference", "--component", "local", "--paths", "8", "--json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return json::parse(draw("c.png", arguments))["pictures"][0];
  };
  const json dark = local({});
  CHECK(dark["mean_irradiance"] == 0.0);
  const json lit = local({"--light", "166,2,36,50,50,50"});
  CHECK(lit["mean_irradiance"] > 0.0);
  CHECK(lit["error"]["query"]["mean"] > -1.0);  // it reaches the probes, too
  const json behind = local({"--light", "172.5,0.5,40,50,50,50"});
  CHECK(behind["mean_irradiance"] != lit["mean_irradiance"]);
}

TEST_CASE("Render, CubemapsThatAreNotThere") {
  const Folder folder;
  const std::string file = folder.write("sky.toml", skyText(kUniform, kStillSun, "keys = 1\ncubemap_size = 0\n"));
  REQUIRE(runTool({"bake", file, "-o", folder / "out", "--progress", "none"}).status == 0);
  for (const bool level : {false, true}) {
    std::vector<std::string> arguments = {"render", folder / "out",   "--time", "12",
                                          "-o",     folder / "a.png", "--sky",  "cubemap"};
    if (level) arguments.insert(arguments.end(), {"--level", std::string(WELKIN_ISLAND) + "/level.toml"});
    const Run run = runTool(arguments);
    INFO(run.err);
    CHECK(run.status == 3);
    CHECK(run.said("no cubemaps"));
  }
}
