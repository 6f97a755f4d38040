// SPDX-License-Identifier: Apache-2.0
// welkin view without a window: its numbers are those of sample, reference and inspect.
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <random>
#include <string>

#include "level_text.h"

using namespace welkin::tests;
using nlohmann::json;

namespace {

const Setting kLavapipe = {{{"VK_ICD_FILENAMES", WELKIN_TEST_ICD}}, "", "", 0, 240.0};

bool noLavapipe() {
  if (std::filesystem::exists(WELKIN_TEST_ICD)) return false;
  WARN("skipped: no " WELKIN_TEST_ICD);
  return true;
}

json printed(const std::vector<std::string>& arguments) {
  const Run run = runTool(arguments);
  INFO(run.err);
  REQUIRE(run.status == 0);
  return json::parse(run.out);
}

void write(const std::string& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

/// Runs a script on a level in its folder "out".
Run viewed(const SmallLevel& level, const std::string& script, const std::vector<std::string>& more = {},
           const Setting& setting = kLavapipe) {
  write(level / "script.txt", script);
  std::vector<std::string> arguments = {"view",   level / "out", "--headless", "--validate",
                                        "--size", "160x90",      "--script",   level / "script.txt"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return runTool(arguments, setting);
}

json stateOf(const SmallLevel& level, const std::string& script) {
  const Run run = viewed(level, script, {"--state", level / "state.json"});
  INFO(run.err);
  REQUIRE(run.status == 0);
  return json::parse(readBytes(level / "state.json"));
}

}  // namespace

TEST_CASE("View, SaysWhatSampleReferenceAndInspectSay") {
  if (noLavapipe()) return;
  const SmallLevel level;
  level.bake("out");
  const json state = stateOf(level, "time 9.25\ntruth 4096\npoint 168.5 0 30.5 0 3 0\n");
  const json& pick = state["pick"];
  const std::vector<std::string> place = {"--time",   "9.25",  "--position", "168.5,0,30.5",
                                          "--normal", "0,1,0", "--json"};
  std::vector<std::string> sample = {"sample", level / "out"},
                           reference = {"reference", level / "level.toml", "--samples", "4096", "--progress", "none"};
  sample.insert(sample.end(), place.begin(), place.end());
  reference.insert(reference.end(), place.begin(), place.end());
  CHECK(pick["light"] == printed(sample));
  const json truth = printed(reference);
  for (const char* key : {"irradiance", "standard_error", "components", "samples"}) {
    INFO(key);
    CHECK(pick["truth"][key] == truth[key]);
  }
  double share = 0.0;
  REQUIRE(pick["cells"].size() == 8);
  for (const json& cell : pick["cells"]) {
    share += double{cell["share"]};
    CHECK((cell["part"] == "lights") == (double{cell["share"]} > 0.0));
  }
  CHECK(share == Approx(1.0));
  const json index = printed({"inspect", level / "out/level.welkin", "--json"})["level"];
  REQUIRE(state["cost"]["sectors"].size() == index["sectors"].size());
  std::size_t bytes = 0;
  for (const json& sector : index["sectors"]) bytes += std::size_t{sector["bytes"]};
  CHECK(state["cost"]["bytes"] == bytes);
  const json sky = printed({"sample", level / "out", "--time", "9.25", "--json"});
  CHECK(state["sky"]["intensity"] == sky["intensity"]);
  CHECK(state["sun"]["illuminance"] == sky["sun"]["illuminance"]);
  // The path goes from 30 degrees below the horizon at 0 h to it at 6 h, and down again at 18 h.
  REQUIRE((state["sunrise_h"].size() == 1 && state["sunset_h"].size() == 1));
  CHECK(double{state["sunrise_h"][0]} == Approx(6.0).margin(0.01));
  CHECK(double{state["sunset_h"][0]} == Approx(18.0).margin(0.01));
}

TEST_CASE("View, ProbesAreThoseOfTheSector") {
  if (noLavapipe()) return;
  const SmallLevel level;
  level.bake("out");
  const json sector = printed({"inspect", level / "out/sectors/sector_0_0.welkin", "--json"})["sector"]["probes"];
  REQUIRE(!sector.empty());
  const json& wanted = sector[0]["position"];
  const double x = wanted[0], y = wanted[1], z = wanted[2];
  // From the south, 5 m away, straight at the sphere.
  const json state = stateOf(level, "time 12\nprobes visibility\ncamera " + std::to_string(x) + " " +
                                        std::to_string(y) + " " + std::to_string(z + 5.0) + " 0 0\nclick 80 45\n");
  REQUIRE(state["pick"].is_null());
  REQUIRE(state["probe"]["sector"] == "0_0");
  CHECK(state["probe"]["number"] == 0);
  CHECK(state["probe"]["position"] == wanted);
  CHECK(double{state["probe"]["visibility"]} > 0.5);
  CHECK(double{state["probe"]["visibility"]} < 1.3);  // the ground reflects as well
}

TEST_CASE("View, ChangesCompareAndUndo") {
  if (noLavapipe()) return;
  const SmallLevel level;
  level.bake("out");
  const std::string at = "time 9\ncamera 160 1.7 40 120 -5\n";
  const json same = stateOf(level, at + "compare baked baked difference\nscreenshot " + level / "a.png" + "\n");
  CHECK(same["compare"]["error"]["rms"] == 0.0);
  CHECK(std::size_t{same["compare"]["error"]["pixels"]} > 1000);
  CHECK(readBytes(level / "a.png").substr(16, 8) == std::string("\0\0\0\xa0\0\0\0\x5a", 8));
  const json flat = stateOf(level, at + "compare baked flat wipe 0.25\n");
  CHECK(double{flat["compare"]["error"]["rms"]} > 0.01);
  const json traced = stateOf(level, at + "paths 8\ncompare baked reference side\n");
  CHECK(double{traced["compare"]["error"]["rms"]} < 0.5 * double{flat["compare"]["error"]["rms"]} + 0.2);
  CHECK(double{traced["compare"]["error"]["noise"]} > 0.0);
  const json changed = stateOf(level, "set sky 0.5\nset tint off\nundo\nset saturation 0.25\nundo\nundo\nredo\n");
  CHECK(changed["changes"]["sky"] == 0.5);
  CHECK(changed["changes"]["tint"] == true);
  CHECK(changed["changes"]["saturation"] == 1.0);
  CHECK((changed["undo"] == 1 && changed["redo"] == 1));
  // Undo is of the light alone.
  const json undone =
      stateOf(level, "set sky 0.5\ntime 15\npoint 168.5 0 30.5 0 1 0\ntruth 64\ncamera 1 2 3 40 5\nundo\n");
  CHECK(undone["changes"]["sky"] == 1.0);
  CHECK(undone["time_h"] == 15.0);
  CHECK(undone["camera"]["position"] == json({1.0, 2.0, 3.0}));
  CHECK(!undone["pick"].is_null());
}

TEST_CASE("View, AClickSideBySidePicksWhatIsThere") {
  if (noLavapipe()) return;
  const SmallLevel level;
  level.bake("out");
  const std::string at = "time 9\ntruth 64\ncamera 160 4 52 20 -20\n";
  const json whole = stateOf(level, at + "click 90 60\n");
  REQUIRE(!whole["pick"].is_null());
  for (const char* click : {"click 50 60\n", "click 130 60\n"})
    CHECK(stateOf(level, at + "compare baked flat side\n" + click)["pick"] == whole["pick"]);
}

TEST_CASE("View, TheScaleOfTheLevelIsPartOfTheTruth") {
  if (noLavapipe()) return;
  const SmallLevel level;
  level.writeLevel("rays = 64", "[scale]\nsky = 4\nsun_bounce = 4");
  level.bake("out");
  const json pick = stateOf(level, "time 12\npoint 100 0 30 0 1 0\n")["pick"];
  CHECK(double{pick["expected"][1]} == Approx(4.0 * double{pick["truth"]["irradiance"][1]}));
  INFO(pick["words"]);
  CHECK(pick["verdict"] == "right");
}

TEST_CASE("View, APictureSmallerThanItsPanels") {
  if (noLavapipe()) return;
  const SmallLevel level;
  level.bake("out");
  for (const char* size : {"64x36", "1x1"}) {
    const Run run = runTool(
        {"view", level / "out", "--headless", "--validate", "--size", size, "--screenshot", level / "small.png"},
        kLavapipe);
    INFO(size << "\n" << run.err);
    CHECK(run.status == 0);
    CHECK(std::filesystem::exists(level / "small.png"));
  }
}

TEST_CASE("View, ScriptErrorsNameFileLineAndWord") {
  if (noLavapipe()) return;
  const SmallLevel level;
  level.bake("out");
  const std::pair<const char*, const char*> cases[] = {
      {"tyme 9", "\"tyme\" is not a command; those are time, camera"},
      {"time noon", "the hour is \"noon\", must be a number in 0 to 24"},
      {"set tint maybe", "tint is \"maybe\", must be one of off, on"},
      {"compare baked truth", "the second light is \"truth\", must be one of baked, flat, sky, reference"},
      {"click 161 3", "x is \"161\", must be a number in 0 to 160"},
      {"fly sector 9_9", "the sector is \"9_9\", must be one of the level, such as -1_0"},
      {"fly point", "fly: no point is picked; point or click picks one"},
      {"truth 0", "the number of paths is \"0\", must be a whole number in 1 to"},
      {"point 0 0 0 0 0 0", "the normal is 0 0 0"},
      {"reset all", "\"all\" is one word too many"}};
  for (const auto& [line, said] : cases) {
    const Run run = viewed(level, std::string("time 9\n\n") + line + "\n", {"--state", level / "never.json"});
    INFO(line << "\n" << run.err);
    CHECK(run.status == 3);
    CHECK(run.said("script.txt:3: "));
    CHECK(run.said(said));
    CHECK(!std::filesystem::exists(level / "never.json"));
  }
  const Run none = runTool({"view", level / "out2", "--headless", "--state", level / "never.json"}, kLavapipe);
  CHECK(none.status == 2);
  CHECK(none.said("not the folder of a baked level"));
  const Run idle = runTool({"view", level / "out", "--headless"}, kLavapipe);
  CHECK(idle.status == 1);
  CHECK(idle.said("--headless has nothing to do: give --script, --screenshot or --state"));
}

TEST_CASE("View, WithoutALevelTheIslandIsBakedOnce") {
  if (noLavapipe()) return;
  const Folder folder;
  Setting cached = kLavapipe;
  cached.environment.emplace_back("XDG_CACHE_HOME", folder.path().string());
  const std::vector<std::string> arguments = {"view",  "--headless", "--size",
                                              "64x36", "--state",    folder / "state.json"};
  const Run first = runTool(arguments, cached);
  INFO(first.err);
  REQUIRE(first.status == 0);
  CHECK(first.said("sectors: 16/16"));
  const std::string state = readBytes(folder / "state.json");
  CHECK(json::parse(state)["cost"]["sectors"].size() == 16);
  const Run second = runTool(arguments, cached);
  INFO(second.err);
  REQUIRE(second.status == 0);
  CHECK(!second.said("sectors:"));
  CHECK(readBytes(folder / "state.json") == state);
  cached.environment.back().second = "nowhere";
  cached.environment.emplace_back("HOME", "");
  const Run homeless = runTool(arguments, cached);
  CHECK(homeless.status == 2);
  CHECK(homeless.said("set XDG_CACHE_HOME or HOME"));
}

TEST_CASE("View, RatesAreMeasuredAndLeaveTheStateAsItIs") {
  if (noLavapipe()) return;
  const SmallLevel level;
  level.bake("out");
  const std::string at = "time 9\ncamera 160 4 52 20 -10\n";
  json state = stateOf(level, at + "rates 3\n");
  CHECK(double{state["rates"]["moving"]} > 0.0);
  CHECK(double{state["rates"]["still"]} > 0.0);
  CHECK(state["rates"]["pictures"] == 3);
  CHECK(double{state["rates"]["still_pass_ms"]["light"]} > 0.0);
  CHECK(!state["rates"]["moving_pass_ms"].contains("mirror image"));
  state["rates"] = nullptr;
  CHECK(state == stateOf(level, at));
}

TEST_CASE("View, ASessionOfRandomActions") {
  if (noLavapipe()) return;
  const SmallLevel level;
  level.bake("out");
  std::mt19937 random(1);
  const auto below = [&](unsigned n) { return random() % n; };
  const auto number = [&](double low, double high) {
    return std::to_string(low + (high - low) * static_cast<double>(below(1000)) / 999.0);
  };
  const std::vector<std::string> lights = {"baked", "flat", "sky", "reference"};
  const std::vector<std::string> shades = {"off", "irradiance", "visibility", "local"}, switched = {"off", "on"};
  std::string script = "paths 1\ntruth 64\n";
  const char* asked = std::getenv("WELKIN_VIEW_ACTIONS");  // of a longer session, by hand
  const int count = asked == nullptr ? 250 : std::stoi(asked);
  for (int i = 0; i < count; ++i) {
    const std::string choices[] = {
        "time " + number(0, 24),
        "camera " + number(-64, 192) + " " + number(-2, 20) + " " + number(0, 64) + " " + number(0, 360) + " " +
            number(-89, 89),
        "click " + number(0, 160) + " " + number(0, 90),
        "compare " + lights[below(4)] + " " + lights[below(4)] + (below(2) == 0 ? " difference" : " wipe 0.5"),
        "compare off",
        "light " + lights[below(4)],
        "probes " + shades[below(4)],
        "set sky " + number(0, 16),
        "set occlusion " + switched[below(2)],
        "edit " + switched[below(2)],
        "probe add " + number(0, 128) + " 1.5 " + number(0, 64),
        "set saturation " + number(0, 1),
        "undo",
        "redo",
        "fly sector 1_0",
        "bounds on",
        "exposure " + number(-4, 4),
        "exposure auto",
        "overview"};
    script += choices[below(std::size(choices))] + "\n";
    if (i % 50 == 9) script += "rates 1\n";
    if (i % 10 == 9) script += "screenshot " + level / "a.png" + "\n";
  }
  Setting setting = kLavapipe;
  setting.deadline_s *= 1.0 + count / 250.0;
  const Run run = viewed(level, script, {"--state", level / "state.json"}, setting);
  INFO(run.err << script);
  CHECK(run.status == 0);
  CHECK(!json::parse(readBytes(level / "state.json"))["sky"].is_null());
}
