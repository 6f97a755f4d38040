// SPDX-License-Identifier: Apache-2.0
// Files left by init, bake, plan and validate: the same bytes for any number of threads and any folder.
#include <unistd.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "run_tool.h"
#include "sky_text.h"

using namespace welkin::tests;
using nlohmann::json;
namespace fs = std::filesystem;

namespace {

const std::string kSmallBake = "bands = 3\nkeys = 6\ncubemap_size = 8\ncubemap_times = [0, 7.25, 12]";

/// Runs `welkin init` and replaces the bake section by a small one.
std::string startingSky(const Folder& folder) {
  REQUIRE(runTool({"init", folder / "level"}).status == 0);
  const std::string text = readBytes(folder / "level/sky.toml");
  return folder.write("level/sky.toml", text.substr(0, text.find("[bake]")) + "[bake]\n" + kSmallBake + "\n");
}

void bake(const std::string& sky, const std::string& folder,
          const std::vector<std::string>& more = {"--certify", "none"}) {
  std::vector<std::string> arguments = {"bake", sky, "-o", folder};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const Run run = runTool(arguments);
  INFO(run.err);
  REQUIRE(run.status == 0);
  REQUIRE(run.out.empty());  // Stdout is for results, and a bake prints none.
}

}  // namespace

TEST_CASE("Init, WritesASkyThatValidatesAndOverwritesNothing") {
  const Folder folder;
  const Run first = runTool({"init", folder / "new/level"});
  REQUIRE(first.status == 0);
  REQUIRE(first.out == folder / "new/level/sky.toml\n");
  REQUIRE(filesUnder(folder / "new/level") ==
          std::vector<std::string>{"gradient_anti.png", "gradient_sun.png", "sky.toml", "stars.png"});
  REQUIRE(runTool({"validate", folder / "new/level/sky.toml"}).out == folder / "new/level/sky.toml: ok\n");
  folder.write("new/level/sky.toml", "mine");
  const Run second = runTool({"init", folder / "new/level"});
  REQUIRE(second.status == 2);
  REQUIRE(second.said(folder / "new/level/sky.toml"));
  REQUIRE(readBytes(folder / "new/level/sky.toml") == "mine");
}

TEST_CASE("Bake, SameBytesForAnyThreadsAndFolder") {
  const Folder folder;
  const std::string sky = startingSky(folder);
  bake(sky, folder / "one", {"--threads", "1"});
  bake(sky, folder / "another/place", {"--threads", "2"});
  const auto names = filesUnder(folder / "one");
  REQUIRE(names.size() == 3 * 2 + 4);  // EXR cubes and latlongs; sky.welkin, record, report, timing
  REQUIRE(filesUnder(folder / "another/place") == names);
  for (const std::string& name : names) {
    INFO(name);
    if (name == "timing.json") continue;
    const std::string bytes = readBytes(folder.path() / "one" / name);
    REQUIRE_FALSE(bytes.empty());
    REQUIRE(bytes == readBytes(folder.path() / "another/place" / name));
  }
}

TEST_CASE("Bake, ReportDescribesTheOutputsWithoutTimesHostsAndPaths") {
  const Folder folder;
  bake(startingSky(folder), folder / "out", {});
  const std::string text = readBytes(folder / "out/report.json");
  char host[256] = {};
  REQUIRE(gethostname(host, sizeof host - 1) == 0);
  for (const std::string& leak :
       {folder.path().string(), std::string("/level"), std::string(host), std::string("_s\"")})
    REQUIRE((leak.empty() || text.find(leak) == std::string::npos));
  const json report = json::parse(text);
  REQUIRE(report["inputs"].size() == 4);
  REQUIRE(report["inputs"][0]["name"] == "sky.toml");
  REQUIRE(report["settings"]["bake"]["cubemap_size"] == 8);
  REQUIRE(report["table"]["bands"] == 3);
  REQUIRE(report["table"]["keys"] == 6);
  REQUIRE(report["cubemaps"]["time_h"] == json({0.0, 7.25, 12.0}));
  REQUIRE(report["outputs"].size() == 7);
  for (const json& output : report["outputs"]) {
    INFO(output.dump());
    REQUIRE(fs::file_size(folder.path() / "out" / output["file"].get<std::string>()) == output["bytes"]);
  }
}

TEST_CASE("Bake, UnchangedOutputsKeepTheirDate") {
  const Folder folder;
  const std::string sky = startingSky(folder);
  bake(sky, folder / "out");
  const auto long_ago = fs::file_time_type::clock::now() - std::chrono::hours(48);
  for (const auto& name : filesUnder(folder / "out")) fs::last_write_time(folder.path() / "out" / name, long_ago);
  const auto stored = fs::last_write_time(folder / "out/sky.welkin");
  bake(sky, folder / "out", {"--threads", "1", "--certify", "none"});
  for (const auto& name : filesUnder(folder / "out")) {
    INFO(name);
    if (name != "timing.json") REQUIRE(fs::last_write_time(folder.path() / "out" / name) == stored);
  }
}

TEST_CASE("Bake, RemovesItsStaleCubemapsAndNothingElse") {
  const Folder folder;
  const auto text = [](const std::string& times) {
    return skyText(kUniform, kStillSun, "keys = 1\ncubemap_size = 2\ncubemap_times = " + times);
  };
  bake(folder.write("sky.toml", text("[0, 12]")), folder / "out");
  folder.write("out/cubemaps/mine.exr", "mine");
  folder.write("out/cubemaps/sky_010000000.exr.tmp", "of a bake that was killed");
  bake(folder.write("sky.toml", text("[6, 23.99999999]")), folder / "out");
  REQUIRE(filesUnder(folder / "out/cubemaps") ==
          std::vector<std::string>{"mine.exr", "sky_060000000.exr", "sky_060000000_latlong.exr", "sky_235959999.exr",
                                   "sky_235959999_latlong.exr"});
}

TEST_CASE("Bake, DepfileIsAMakeRuleOfTheInputs") {
  const Folder folder;
  const std::string sky = startingSky(folder);
  bake(sky, folder / "my out", {"--depfile", folder / "sky.d"});
  const std::string level = folder / "level/";
  REQUIRE(readBytes(folder / "sky.d") == folder / "my\\ out/sky.welkin: " + level + "sky.toml " + level +
                                             "gradient_sun.png " + level + "gradient_anti.png " + level +
                                             "stars.png\n");
}

TEST_CASE("Bake, ProgressIsLinesOfJsonOrNothing") {
  const Folder folder;
  const std::string sky = startingSky(folder);
  const Run run = runTool({"bake", sky, "-o", folder / "out", "--progress", "json"});
  REQUIRE(run.status == 0);
  std::istringstream lines(run.err);
  std::vector<std::string> finished;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("welkin: ")) continue;  // the certificate
    const json progress = json::parse(line);
    REQUIRE(progress["elapsed_s"].get<double>() >= 0.0);
    if (progress["done"] == 0)
      REQUIRE(progress["left_s"].is_null());
    else
      REQUIRE(progress["left_s"].get<double>() >= 0.0);
    if (progress["done"] == progress["total"]) finished.push_back(progress["progress"]);
  }
  REQUIRE(finished == std::vector<std::string>{"table", "certificate", "cubemaps", "cubemaps' error", "images"});
  const std::vector<std::string> silent = {"bake",       sky,    "-o",        folder / "out",
                                           "--progress", "none", "--certify", "none"};
  REQUIRE(runTool(silent).err.empty());
}

TEST_CASE("Bake, ReportGoesWhereItIsToldEvenToADevice") {
  const Folder folder;
  const std::string sky = folder.write("sky.toml", skyText(kUniform));
  bake(sky, folder / "out", {"--report", folder / "other.json"});
  REQUIRE_FALSE(fs::exists(folder / "out/report.json"));
  REQUIRE(json::parse(readBytes(folder / "other.json"))["format_version"] == 2);
  bake(sky, folder / "out", {"--report", "/dev/null"});
  REQUIRE(fs::is_character_file("/dev/null"));
}

TEST_CASE("Bake, FileNamesMayHoldAnyBytes") {
  const Folder folder;
  const std::string odd = "s k\"y\xff\n#$.toml";
  bake(folder.write(odd, skyText(kUniform)), folder / "out", {"--depfile", folder / "d"});
  REQUIRE(json::parse(readBytes(folder / "out/report.json"))["inputs"].size() == 1);
  REQUIRE(runTool({"plan", folder / odd, "--json"}).status == 0);
}

TEST_CASE("Plan, CountsTheBytesThatABakeWrites") {
  const Folder folder;
  const std::string sky = folder.write("sky.toml", skyText(kUniform, kStillSun, kSmallBake));
  const Run run = runTool({"plan", sky, "--json"});
  REQUIRE(run.status == 0);
  const json plan = json::parse(run.out);
  REQUIRE(plan["inputs"] == json({"sky.toml"}));
  REQUIRE(plan["table"]["coefficients"] == 9);
  REQUIRE(plan["table"]["bytes"] == 6 * (8 + 6 * 4));  // a double and six floats of a grey sky without ground a key
  REQUIRE(plan["gradients"]["bytes"] == 2 * 12);
  REQUIRE(plan["cubemaps"]["bytes"] == 3 * 6 * 8 * 8 * 8);
  REQUIRE(plan["moon"] == false);
  bake(sky, folder / "out");
  const auto real = static_cast<double>(fs::file_size(folder / "out/sky.welkin"));
  REQUIRE(real >= plan["bytes"].get<double>());
  REQUIRE(real <= plan["bytes"].get<double>() + 3000.0);  // the header, settings, curves and FlatBuffers' own tables
}

TEST_CASE("Bake, CubemapsAreOfTheFormatThatIsAsked") {
  const Folder folder;
  for (const auto& [name, texel] : {std::pair("rgba16f", 8), {"rgb9e5", 4}, {"b10g11r11", 4}}) {
    const std::string sky = folder.write(
        "sky.toml", skyText(kUniform, kStillSun, kSmallBake + "\ncubemap_format = \"" + std::string(name) + "\""));
    INFO(name);
    const json plan = json::parse(runTool({"plan", sky, "--json"}).out);
    REQUIRE(plan["cubemaps"]["format"] == name);
    REQUIRE(plan["cubemaps"]["bytes"] == 3 * 6 * 8 * 8 * texel);
    REQUIRE(runTool({"plan", sky}).out.find(name) != std::string::npos);
    bake(sky, folder / name);
    REQUIRE(json::parse(readBytes(folder.path() / name / "report.json"))["cubemaps"]["format"] == name);
    REQUIRE(runTool({"inspect", folder / name}).out.find(std::string("3 cubemaps of 8 ") + name) != std::string::npos);
    const json file = json::parse(runTool({"inspect", folder / name, "--json"}).out);
    REQUIRE(file["sky"]["cubemaps"].size() == 3);
    for (const json& cubemap : file["sky"]["cubemaps"]) {
      REQUIRE(cubemap["format"] == name);
      REQUIRE(cubemap["bytes"] == 6 * 8 * 8 * texel);
    }
    const auto real = static_cast<double>(fs::file_size(folder.path() / name / "sky.welkin"));
    REQUIRE(real >= plan["bytes"].get<double>());
    REQUIRE(real <= plan["bytes"].get<double>() + 3000.0);
  }
  // EXR files hold half floats, whatever the format.
  for (const char* name : {"rgb9e5", "b10g11r11"})
    REQUIRE(readBytes(folder.path() / name / "cubemaps/sky_071500000.exr") ==
            readBytes(folder.path() / "rgba16f/cubemaps/sky_071500000.exr"));
}

TEST_CASE("Bake, GradientsOfSharedExponentsTakeAThird") {
  const Folder folder;
  const std::string sky = startingSky(folder);
  bake(sky, folder / "floats");
  const auto planned = [&] {
    return json::parse(runTool({"plan", sky, "--json"}).out)["gradients"]["bytes"].get<std::size_t>();
  };
  const std::size_t floats = planned();
  folder.write("level/sky.toml", readBytes(sky) + "gradient_format = \"rgb9e5\"\n");
  REQUIRE(planned() * 3 == floats);
  bake(sky, folder / "shared");
  const auto saved = fs::file_size(folder / "floats/sky.welkin") - fs::file_size(folder / "shared/sky.welkin");
  REQUIRE(saved <= floats - planned());
  REQUIRE(saved + 100 > floats - planned());  // the settings name the format
  REQUIRE(runTool({"validate", folder / "shared"}).status == 0);
}

TEST_CASE("Validate, NamesEveryGoodFileAndStopsAtTheFirstBad") {
  const Folder folder;
  const std::string sky = folder.write("sky.toml", skyText(kUniform));
  bake(sky, folder / "out");
  const Run good = runTool({"validate", sky, folder / "out", folder / "out/sky.welkin"});
  REQUIRE(good.status == 0);
  const std::string file = folder / "out/sky.welkin: ok\n";
  REQUIRE(good.out == sky + ": ok\n" + file + file);
  const Run bad = runTool({"validate", sky, folder.write("bad.welkin", "text"), folder / "out"});
  REQUIRE(bad.status == 3);
  REQUIRE(bad.said("bad.welkin"));
  REQUIRE(bad.out == sky + ": ok\n");
}
