// SPDX-License-Identifier: Apache-2.0
// The bake of a level that is killed, interrupted or out of space. Finished sectors stay whole, and the same command
// completes the rest.
#include <signal.h>

#include <catch2/catch.hpp>
#include <cerrno>
#include <cstring>

#include "kill_sweep.h"
#include "level_text.h"
#include "two_bakes.h"

using namespace welkin::tests;
namespace fs = std::filesystem;

namespace {

/// Number of sectors present. Each must be whole.
int wholeSectors(const SmallLevel& level, const std::string& out) {
  int count = 0;
  if (!fs::exists(level.path() / out / "sectors")) return 0;
  for (const auto& name : filesUnder(level.path() / out / "sectors")) {
    if (name.ends_with(".tmp")) continue;
    INFO(name);
    REQUIRE(readBytes(level.path() / out / "sectors" / name) == readBytes(level.path() / "whole" / "sectors" / name));
    ++count;
  }
  return count;
}

/// The same command bakes the missing sectors. The result equals that of an undisturbed bake.
void requireResumes(const SmallLevel& level, const std::string& out) {
  const int there = wholeSectors(level, out);
  const bool has_sky = fs::exists(level.path() / out / "sky.welkin");
  REQUIRE(level.bake(out) == kSectors - there);
  REQUIRE(nlohmann::json::parse(readBytes(level / (out + "/timing.json")))["sky_baked"] == !has_sky);
  for (const auto& name : filesUnder(level.path() / "whole"))
    if (name != "timing.json") {
      INFO(name);
      REQUIRE(readBytes(level.path() / out / name) == readBytes(level.path() / "whole" / name));
    }
  REQUIRE(filesUnder(level.path() / out) == filesUnder(level.path() / "whole"));
}

/// A bake into a new folder.
KillSweep sweepOf(const SmallLevel& level) {
  return {level.command("out"), [&level] { fs::remove_all(level / "out"); },
          [&level](int) { requireResumes(level, "out"); }};
}

}  // namespace

TEST_CASE("LevelKill, AtEveryCallThatChangesTheDisk") {
  const SmallLevel level;
  level.bake("whole");
  killAtEveryCall(sweepOf(level), 6 * (kSectors + 3));
}

TEST_CASE("LevelKill, AtAnyTime") {
  const SmallLevel level(1024);
  level.bake("whole");
  killAtAnyTime(sweepOf(level), 50);
}

TEST_CASE("LevelKill, InterruptKeepsFinishedSectors") {
  const SmallLevel level;
  level.bake("whole");
  level.writeLevel("rays = 262144");
  Setting setting;
  setting.err_path = level / "err";
  auto words = level.command("out");
  *(std::find(words.begin(), words.end(), "none")) = "json";
  Tool tool(words, setting);
  while (!fs::exists(level / "out/sky.welkin")) REQUIRE_FALSE(tool.endsWithin(0.01));
  REQUIRE_FALSE(tool.endsWithin(1.0));
  tool.send(SIGINT);
  REQUIRE(tool.endsWithin(10.0));
  REQUIRE(tool.wait().status == 130);
  REQUIRE(readBytes(level / "err").find("interrupted; finished files are kept") != std::string::npos);
  REQUIRE_FALSE(fs::exists(level / "out/level.welkin"));
}

TEST_CASE("LevelKill, NoRoomIsAnErrorOfTheDisk") {
  const SmallLevel level;
  level.bake("whole");
  for (int call = 1;; ++call) {
    fs::remove_all(level / "out");
    const Run run = runTool(level.command("out"), on({call % 2 == 0 ? "ENOSPC" : "EROFS", std::to_string(call), ""}));
    INFO("at call " << call << ": " << run.err);
    if (run.status == 0) break;
    REQUIRE(run.status == 2);
    REQUIRE(run.said(std::strerror(call % 2 == 0 ? ENOSPC : EROFS)));
    requireResumes(level, "out");
  }
}
