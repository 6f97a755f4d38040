// SPDX-License-Identifier: Apache-2.0
// welkin view edits level.toml and bakes it again: what is saved, what is not lost, what a cancelled bake leaves.
#include <catch2/catch.hpp>
#include <csignal>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>

#include "level_text.h"

using namespace welkin::tests;
using nlohmann::json;

namespace {

const Setting kOnLavapipe = {{{"VK_ICD_FILENAMES", WELKIN_TEST_ICD}}, "", "", 0, 240.0};

bool lacksLavapipe() {
  if (std::filesystem::exists(WELKIN_TEST_ICD)) return false;
  WARN("skipped: no " WELKIN_TEST_ICD);
  return true;
}

std::vector<std::string> editing(const SmallLevel& level, const std::string& script) {
  std::ofstream(level / "script.txt", std::ios::binary) << script;
  return {"view",  level / "out", "--headless",         "--validate", "--size",
          "96x54", "--script",    level / "script.txt", "--state",    level / "state.json"};
}

json edited(const SmallLevel& level, const std::string& script) {
  const Run run = runTool(editing(level, script), kOnLavapipe);
  INFO(run.err);
  REQUIRE(run.status == 0);
  return json::parse(readBytes(level / "state.json"));
}

std::map<std::string, std::string> filesOf(const std::string& folder) {
  std::map<std::string, std::string> files;
  for (const auto& name : filesUnder(folder)) files[name] = readBytes(std::filesystem::path(folder) / name);
  return files;
}

}  // namespace

TEST_CASE("ViewEdit, EditsAreSavedWithTheirCommentsAndUndone") {
  if (lacksLavapipe()) return;
  const SmallLevel level;
  level.writeLevel("rays = 64 # few", "# by hand\nadd = [\n  [10, 1, 20], # a\n  [30, 1, 20]  # b\n]");
  level.bake("out");
  const std::string before = readBytes(level / "level.toml");
  const json state =
      edited(level,
             "probe add 5 1.5 6\nprobe move 0 11 1 20\nprobe delete 1\nroom add 0 0 0 4 3 4\nundo\nundo\n"
             "redo\nredo\nsave\n");
  CHECK(state["edit"]["probes"] == json({{11.0, 1.0, 20.0}, {5.0, 1.5, 6.0}}));
  CHECK(state["edit"]["rooms"] == json({{0.0, 0.0, 0.0, 4.0, 3.0, 4.0}}));
  CHECK((state["edit"]["unsaved"] == false && state["edit"]["unbaked"] == true));
  std::string wanted = before;
  const auto replace = [&](const std::string& a, const std::string& b) { wanted.replace(wanted.find(a), a.size(), b); };
  replace("[10, 1, 20], # a\n  [30, 1, 20]  # b\n", "[11.0, 1.0, 20.0], # a\n  # b\n  [5.0, 1.5, 6.0]\n");
  const std::string after = readBytes(level / "level.toml");
  CHECK(after == wanted + "\n[[room]]\nbox = [0.0, 0.0, 0.0, 4.0, 3.0, 4.0]\n");
  CHECK(!std::filesystem::exists(level / "level.toml.unsaved"));
  const json undone = edited(level, "probe add 1 2 3\nroom add 0 0 0 1 1 1\nundo\nundo\n");
  CHECK(undone["edit"]["unsaved"] == false);
  CHECK(readBytes(level / "level.toml") == after);
}

TEST_CASE("ViewEdit, RefusalsSayWhatIsAllowed") {
  if (lacksLavapipe()) return;
  const SmallLevel level;
  level.bake("out");
  const std::pair<const char*, const char*> cases[] = {
      {"probe add 1 2", "a coordinate is missing"},
      {"probe add 1 2 x", "a coordinate is \"x\", must be a number in"},
      {"probe add here", "probe: no point is picked; point or click picks one"},
      {"probe delete 0", "probe: level.toml has no probe by hand; `probe add` adds one"},
      {"room add 1 0 0 1 1 1", "room: the first corner must be below the second on each axis"},
      {"room delete 0", "room: level.toml has no room"},
      {"recover", "recover: no edits of an earlier run are there"},
      {"rebake 9_9", "rebake: the sector is \"9_9\", must be one of the level"}};
  for (const auto& [line, said] : cases) {
    const Run run = runTool(editing(level, std::string(line) + "\n"), kOnLavapipe);
    INFO(line << "\n" << run.err);
    CHECK(run.status == 3);
    CHECK(run.said("script.txt:1: "));
    CHECK(run.said(said));
  }
}

TEST_CASE("ViewEdit, AKilledRunLeavesAJournalThatIsOffered") {
  if (lacksLavapipe()) return;
  const SmallLevel level;
  level.bake("out");
  const std::string before = readBytes(level / "level.toml");
  {
    Tool tool(editing(level, "probe add 1 1.5 3\nstate " + level / "there.json" + "\nrates 10000\n"), kOnLavapipe);
    for (int i = 0; i < 12000 && !std::filesystem::exists(level / "there.json"); ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    REQUIRE(std::filesystem::exists(level / "there.json"));
    tool.send(SIGKILL);
    CHECK(tool.wait().status == -SIGKILL);
  }
  CHECK(readBytes(level / "level.toml") == before);
  REQUIRE(std::filesystem::exists(level / "level.toml.unsaved"));
  CHECK(edited(level, "time 9\n")["edit"]["offers"] == true);
  const Run waits = runTool(editing(level, "probe add 4 1 4\n"), kOnLavapipe);
  CHECK(waits.status == 3);
  CHECK(waits.said("`recover` takes them, `discard` drops them"));
  const json recovered = edited(level, "recover\n");
  CHECK(recovered["edit"]["probes"] == json({{1.0, 1.5, 3.0}}));
  CHECK(edited(level, "recover\nsave\n")["edit"]["offers"] == false);
  CHECK(readBytes(level / "level.toml").find("add = [[1.0, 1.5, 3.0]]\n") != std::string::npos);
  edited(level, "probe delete 0\n");  // ends without `save`: that is kept, too
  CHECK(edited(level, "discard\n")["edit"]["probes"].size() == 1);
  CHECK(!std::filesystem::exists(level / "level.toml.unsaved"));
}

TEST_CASE("ViewEdit, ARebakeIsTheBakeOfTheEditedLevel") {
  if (lacksLavapipe()) return;
  const SmallLevel level;
  level.bake("out");
  const auto old = filesOf(level / "out");
  const json state = edited(level, "time 9.25\ntruth 64\nprobe add 170 1.2 26\nrebake\nwait sector\nstate " +
                                       level / "midway.json" + "\nwait rebake\npoint 168.5 0 30.5 0 1 0\n");
  CHECK(state["rebake"]["state"] == "done");
  CHECK(state["edit"]["unbaked"] == false);
  const auto baked = filesOf(level / "out");
  for (const json& sector : state["rebake"]["sectors"])  // the others keep their bytes
    CHECK(baked.at("sectors/sector_" + sector.get<std::string>() + ".welkin") !=
          old.at("sectors/sector_" + sector.get<std::string>() + ".welkin"));
  std::size_t changed = 0;
  for (const auto& [name, bytes] : baked)
    if (name.starts_with("sectors/") && old.at(name) != bytes) ++changed;
  CHECK(changed == state["rebake"]["sectors"].size());
  CHECK((changed > 0 && changed < std::size_t{kSectors}));
  CHECK(!std::filesystem::exists(level / "out.rebake"));
  level.bake("clean");
  requireSame(level / "out", level / "clean");
  const Run sample =
      runTool({"sample", level / "out", "--time", "9.25", "--position", "168.5,0,30.5", "--normal", "0,1,0", "--json"});
  CHECK(state["pick"]["light"] == json::parse(sample.out));
  CHECK(json::parse(readBytes(level / "midway.json"))["rebake"]["sectors"].size() >= 1);
  const json again = edited(level, "rebake\nwait rebake\n");
  CHECK(again["rebake"]["sectors"].empty());
  CHECK(again["warnings"] == state["warnings"]);
}

TEST_CASE("ViewEdit, ACancelledRebakeLeavesTheOldSectors") {
  if (lacksLavapipe()) return;
  const SmallLevel level;
  level.bake("out");
  const auto old = filesOf(level / "out");
  level.writeLevel("rays = 65536");
  const std::string look = "time 9.25\ntruth 64\npoint 168.5 0 30.5 0 1 0\n";
  const json before = edited(level, look);
  const json state = edited(level, look + "rebake\nwait sector\ncancel\n");
  CHECK(state["rebake"]["state"] == "cancelled");
  CHECK(filesOf(level / "out") == old);
  CHECK(state["pick"] == before["pick"]);
  CHECK(!std::filesystem::exists(level / "out.rebake"));
  level.writeLevel("rays = 63");
  const Run failed = runTool(editing(level, "rebake\nwait rebake\n"), kOnLavapipe);
  CHECK(failed.status == 3);
  CHECK(filesOf(level / "out") == old);
}

TEST_CASE("ViewEdit, AnotherBakeIsCompared") {
  if (lacksLavapipe()) return;
  const SmallLevel level;
  level.bake("out");
  level.bake("same");
  level.writeLevel("rays = 64\nbounces = 0");
  level.bake("dark");
  const std::string at = "time 9\ncamera 160 1.7 40 120 -5\nother ", compare = "\ncompare baked other difference\n";
  CHECK(edited(level, at + level / "same" + compare)["compare"]["error"]["rms"] == 0.0);
  const json dark = edited(level, at + level / "same" + "\nother " + level / "dark" + compare)["compare"];
  CHECK(double{dark["error"]["mean"]} > 0.01);  // light that bounced is missing
  CHECK(dark["second"] == "other");
  const Run none = runTool(editing(level, "light other\n"), kOnLavapipe);
  CHECK(none.status == 3);
  CHECK(none.said("other: no other bake is open; `other FOLDER` opens one"));
  CHECK(runTool(editing(level, "other " + level / "nowhere" + "\n"), kOnLavapipe).status == 2);
}

TEST_CASE("ViewEdit, TheFirstFiveMinutes") {  // of docs/viewer.md
  if (lacksLavapipe()) return;
  const Folder folder;
  std::filesystem::copy(WELKIN_EXAMPLES "/talk/yard", folder.path() / "yard");
  const std::string level = folder / "yard/level.toml", out = folder / "out", script = folder / "script.txt";
  const Run bake = runTool({"bake", level, "-o", out, "--progress", "none", "--certify", "none"});
  INFO(bake.err);
  REQUIRE(bake.status == 0);
  const std::string before = folder / "before.json", after = folder / "after.json";
  std::ofstream(script, std::ios::binary)
      << "time 9\nset direct off\ncamera 20.5 1.9 30.5 52 -14\ncompare baked reference difference\n"
      << "point 25.8 0 26 0 1 0\nstate " << before << "\npoint 20 0 21 0 1 0\nroom corner\npoint 26 0 32 0 1 0\n"
      << "room corner\npoint 25.8 0 26 0 1 0\nprobe add here\nrebake\nwait rebake\nstate " << after << "\n";
  const Run run = runTool({"view", out, "--headless", "--validate", "--size", "240x136", "--script", script, "--state",
                           folder / "end.json"},
                          kOnLavapipe);
  INFO(run.err);
  REQUIRE(run.status == 0);
  const json bad = json::parse(readBytes(before)), good = json::parse(readBytes(after));
  CHECK(bad["pick"]["verdict"] == "too bright");
  CHECK(double{bad["pick"]["error"]} > 0.25);
  CHECK(good["pick"]["verdict"] == "right");
  CHECK(std::abs(double{good["pick"]["error"]}) < 0.15);  // 0.11, and four times the noise of 4096 paths besides
  CHECK(double{good["compare"]["error"]["rms"]} < 1.05 * double{bad["compare"]["error"]["rms"]});
  CHECK(good["edit"]["rooms"] == json({{20.0, 0.0, 21.0, 26.0, 3.0, 32.0}}));
  const Run reference = runTool({"reference", level, "--samples", "4096", "--time", "9", "--position", "25.8,0,26",
                                 "--normal", "0,1,0", "--json", "--progress", "none"});
  CHECK(good["pick"]["truth"]["irradiance"] == json::parse(reference.out)["irradiance"]);
}
