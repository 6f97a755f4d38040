// SPDX-License-Identifier: Apache-2.0
// Several bakes into one folder at once: one whole result, or "in use by" with status 2.
#include <signal.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <memory>
#include <random>
#include <thread>

#include "level_text.h"
#include "sky/base/folder_lock.h"
#include "two_bakes.h"

using namespace welkin::tests;
namespace fs = std::filesystem;

namespace {

constexpr int kRounds = 12;

/// Waits for a bake that may have met another one. Returns whether it baked.
bool baked(Tool& tool) {
  const Run run = tool.wait();
  INFO(run.err);
  REQUIRE((run.status == 0 || (run.status == 2 && run.said(": in use by "))));
  return run.status == 0;
}

/// Starts a bake of each sky at once and returns how many of them baked.
int bakeAtOnce(const TwoBakes& bakes, const std::vector<std::string>& skies) {
  std::vector<std::unique_ptr<Tool>> tools;
  for (const std::string& sky : skies) tools.push_back(std::make_unique<Tool>(bakes.command(sky)));
  int count = 0;
  for (const auto& tool : tools) count += baked(*tool);
  return count;
}

/// Requires the folder to be a bake of one of the two skies.
void requireIsOne(const TwoBakes& bakes) {
  const bool old = readBytes(bakes.out() / "sky.welkin") == readBytes(bakes.file("old/sky.welkin"));
  bakes.requireIs(old ? "old" : "new");
}

}  // namespace

TEST_CASE("ManyBakes, ThreeOfOneSkyLeaveItsBake") {
  TwoBakes bakes(8);
  for (int round = 0; round < kRounds; ++round) {
    bakes.putNothing();
    REQUIRE(bakeAtOnce(bakes, {"new", "new", "new"}) >= 1);
    bakes.requireIs("new");
  }
}

TEST_CASE("ManyBakes, OfTwoSkiesLeaveOneOfThem") {
  TwoBakes bakes(8);
  for (int round = 0; round < kRounds; ++round) {
    round % 2 == 0 ? bakes.putNothing() : bakes.putOld();
    REQUIRE(bakeAtOnce(bakes, {"new", "old", "new"}) >= 1);
    requireIsOne(bakes);
  }
}

TEST_CASE("ManyBakes, AKilledOneHarmsNoOther") {
  TwoBakes bakes(16);
  const double whole_s = runTool(bakes.command("new")).seconds;
  std::mt19937 random(1);
  for (int round = 0; round < kRounds; ++round) {
    bakes.putOld();
    Tool killed(bakes.command("new"));
    Tool other(bakes.command("old"));
    const double wait_s = whole_s * static_cast<double>(random() % 1000) / 1000.0;
    std::this_thread::sleep_for(std::chrono::duration<double>(wait_s));
    killed.send(SIGKILL);
    INFO("killed after " << wait_s << " of " << whole_s << " s");
    killed.wait();
    baked(other);
    bakes.requireWhole(true);
    const std::string sky = round % 2 == 0 ? "old" : "new";
    REQUIRE(runTool(bakes.command(sky)).status == 0);  // nothing locks the folder
    bakes.requireIs(sky);
  }
}

TEST_CASE("ManyBakes, AFolderInUseIsNamedAndLeftAlone") {
  const SmallLevel level;
  level.bake("out");
  const auto requireInUse = [&](const std::vector<std::string>& words) {
    const Run run = runTool(words);
    INFO(words[0] << ": " << run.err);
    REQUIRE(run.status == 2);
    REQUIRE(run.err.starts_with("welkin: " + level / "out: in use by process " + std::to_string(::getpid()) + " on "));
    REQUIRE(std::count(run.err.begin(), run.err.end(), '\n') == 1);
  };
  const welkin::base::FolderLock lock(level / "out");
  requireInUse(level.command("out"));
  requireInUse(level.command("out", {"--shard", "1/2"}));
  requireInUse(level.command("out", {"--sectors", "0_0"}));
  requireInUse({"bake", level / "sky.toml", "-o", level / "out", "--progress", "none"});
  requireInUse({"merge", level / "out"});
  REQUIRE(runTool({"validate", level / "out"}).status == 0);  // a reader needs no lock while all agrees
  fs::remove(level / "out/sectors/sector_0_0.welkin");
  requireInUse({"validate", level / "out"});
}

TEST_CASE("ManyBakes, ShardsWorkAtTheSameTimeAndEachOnce") {
  const SmallLevel level;
  level.bake("whole");
  fs::create_directories(level / "out");
  {
    const welkin::base::FolderLock lock(level / "out", 1);
    Tool first(level.command("out", {"--shard", "0/3"}));
    Tool last(level.command("out", {"--shard", "2/3"}));
    REQUIRE(first.wait().status == 0);
    REQUIRE(last.wait().status == 0);
    const Run same = runTool(level.command("out", {"--shard", "1/3"}));
    REQUIRE(same.status == 2);
    REQUIRE(same.said("in use by"));
    REQUIRE(runTool({"merge", level / "out"}).said("in use by"));
  }
  REQUIRE(runTool(level.command("out", {"--shard", "1/3"})).status == 0);
  for (const char* left : {"level.1-of-3.welkin.tmp", "report.json.tmp", "sectors/sector_0_0.welkin.1.tmp"})
    std::ofstream(level / (std::string("out/") + left)) << "of a killed bake";
  REQUIRE(runTool({"merge", level / "out"}).status == 0);
  for (const std::string& name : filesUnder(level / "out")) {
    INFO(name);
    REQUIRE_FALSE((name.ends_with(".tmp") || name.ends_with(".lock")));
  }
  for (const std::string name : {"level.welkin", "sky.welkin", "sectors/sector_0_0.welkin"})
    REQUIRE(readBytes(level / ("out/" + name)) == readBytes(level / ("whole/" + name)));
}

TEST_CASE("ManyBakes, WithoutLocksOneBakeWorks") {
  TwoBakes bakes(4);
  Setting setting;
  setting.environment = {{"LD_PRELOAD", WELKIN_FAILING_DISK}, {"WELKIN_DISK_NO_LOCKS", "1"}};
  for (const char* sky : {"old", "new"}) {
    REQUIRE(runTool(bakes.command(sky), setting).status == 0);
    bakes.requireIs(sky);
  }
}

TEST_CASE("ManyBakes, PlantedLinksOverwriteNothing") {
  TwoBakes bakes(4);
  const std::string victim = bakes.file("victim");
  std::ofstream(victim) << "precious";
  for (const char* name : {"sky.welkin.tmp", "sky.json.tmp", "report.json.tmp", "timing.json.tmp"}) {
    fs::create_directories(bakes.out());
    fs::create_symlink(victim, bakes.out() / name);
  }
  REQUIRE(runTool(bakes.command("new")).status == 0);
  bakes.requireIs("new");
  fs::create_symlink(victim, bakes.out() / ".welkin.lock");
  const Run run = runTool(bakes.command("old"));
  REQUIRE(run.status == 2);
  REQUIRE(run.said(".welkin.lock: cannot lock"));
  REQUIRE(readBytes(victim) == "precious");
}

TEST_CASE("ManyBakes, ASectorThatIsRemovedInTheMeantimeIsAnError") {
  const SmallLevel level(16384);
  const std::string gone = level / "out/sectors/sector_-1_0.welkin";
  Tool tool(level.command("out"));
  while (!fs::exists(gone)) REQUIRE_FALSE(tool.endsWithin(0.001));
  fs::remove(gone);
  const Run run = tool.wait();
  INFO(run.err);
  REQUIRE(run.status == 2);
  REQUIRE(run.said(gone + ": something else has removed"));
  REQUIRE_FALSE(fs::exists(level / "out/level.welkin"));
  REQUIRE(level.bake("out") == 1);
}
