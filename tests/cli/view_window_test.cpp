// SPDX-License-Identifier: Apache-2.0
// welkin view in a window, with a mouse and keys.
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "level_text.h"
#include "x_display.h"

using namespace welkin::tests;
using nlohmann::json;

namespace {

constexpr double kDeadline_s = 240.0;  // lavapipe on a machine that others share

std::vector<std::string> viewOf(const SmallLevel& level, const std::string& script, const std::string& state) {
  std::ofstream(level / "script.txt", std::ios::binary) << script;
  return {"view",     level / "out",        "--validate", "--size",     "960x540",
          "--script", level / "script.txt", "--state",    level / state};
}

}  // namespace

TEST_CASE("ViewWindow, MouseAndKeysDoWhatTheScriptDoes") {
  const XDisplay display;
  if (!display.isOpen() || !std::filesystem::exists(WELKIN_TEST_ICD)) {
    WARN("skipped: no Xvfb, or no " WELKIN_TEST_ICD);
    return;
  }
  const SmallLevel level;
  level.bake("out");
  const std::string start = "time 9.25\ntruth 64\ncamera 160 4 52 20 -10\n";
  const Setting windowed = {
      {{"VK_ICD_FILENAMES", WELKIN_TEST_ICD}, {"DISPLAY", display.name()}, {"XDG_CONFIG_HOME", level / "config"}},
      "",
      "",
      0,
      kDeadline_s};
  // The screenshot of F12 cannot be written there, for a folder has its name.
  std::filesystem::create_directory(level / "welkin_view.png");
  const std::filesystem::path here = std::filesystem::current_path();
  std::filesystem::current_path(level.path());
  Tool tool(viewOf(level, start, "window.json"), windowed);
  std::filesystem::current_path(here);
  REQUIRE(display.showsWindowWithin(0.5 * kDeadline_s));
  display.moveTo(480, 300);
  display.click(1);  // picks
  display.type("p");
  display.type("b");
  display.type("F12");
  display.button(3, true);  // looks 40 pixels to the right and 20 down
  for (int i = 1; i <= 4; ++i) display.moveTo(480 + 10 * i, 300 + 5 * i);
  display.button(3, false);
  display.key("Control_L", true);
  display.key("q", true);
  display.key("q", false);
  display.key("Control_L", false);
  const Run run = tool.wait();
  INFO(run.err);
  REQUIRE(run.status == 0);
  CHECK(run.said("pictures a second: "));
  const json kept = json::parse(readBytes(level / "config/welkin/view.json"));
  CHECK((kept["width"] == 960 && kept["bounds"] == true && kept["truth_paths"] == 64));
  json window = json::parse(readBytes(level / "window.json"));

  std::vector<std::string> headless =
      viewOf(level, start + "click 480 300\nprobes irradiance\nbounds on\ncamera 160 4 52 28 -14\n", "script.json");
  headless.emplace_back("--headless");
  const Run scripted = runTool(headless, {{{"VK_ICD_FILENAMES", WELKIN_TEST_ICD}}, "", "", 0, kDeadline_s});
  INFO(scripted.err);
  REQUIRE(scripted.status == 0);
  json script = json::parse(readBytes(level / "script.json"));
  REQUIRE(!script["pick"].is_null());
  for (const char* angle : {"yaw_deg", "pitch_deg"})
    CHECK(double{window["camera"][angle]} == Approx(double{script["camera"][angle]}));
  window.erase("camera");
  script.erase("camera");
  CHECK(window == script);
}

TEST_CASE("ViewWindow, WithoutADisplayIsOneSentence") {
  const SmallLevel level;
  level.bake("out");
  const Run run =
      runTool({"view", level / "out"},
              {{{"DISPLAY", ""}, {"WAYLAND_DISPLAY", ""}, {"VK_ICD_FILENAMES", WELKIN_TEST_ICD}}, "", "", 0, 60.0});
  INFO(run.err);
  CHECK(run.status == 2);
  CHECK(run.said("welkin: no window: "));
  CHECK(run.said("--headless with --script works without one"));
  CHECK(std::count(run.err.begin(), run.err.end(), '\n') == 1);
}
