// SPDX-License-Identifier: Apache-2.0
// A bake that is killed: every file is the old or the new one, and the next bake clears up.
#include <signal.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <thread>

#include "two_bakes.h"

using namespace welkin::test;
namespace fs = std::filesystem;

namespace {

/// What is left after a kill; then a bake of either sky, which must leave what it leaves in an empty folder.
void requireRecovers(const TwoBakes& bakes, int turn) {
  bakes.requireWhole(true);
  if (fs::exists(bakes.out() / "sky.welkin")) REQUIRE(runTool({"validate", bakes.out()}).status == 0);
  const std::string sky = turn % 2 == 0 ? "old" : "new";
  REQUIRE(runTool(bakes.command(sky)).status == 0);
  bakes.requireIs(sky);
}

}  // namespace

TEST_CASE("Kill, AtEveryCallThatChangesTheDisk") {
  const bool fresh = GENERATE(false, true);
  TwoBakes bakes(4);
  for (int call = 1;; ++call) {
    fresh ? bakes.putNothing() : bakes.putOld();
    const Run run = runTool(bakes.command("new"), on({"kill", std::to_string(call), ""}));
    INFO("killed at call " << call << (fresh ? " in a new folder: " : ": ") << run.err);
    if (run.status == 0) {
      REQUIRE(call > 5 * 8);
      break;
    }
    REQUIRE(run.status == -SIGKILL);
    requireRecovers(bakes, call);
  }
}

TEST_CASE("Kill, AtAnyTime") {
  constexpr int kKills = 40;
  TwoBakes bakes(32);
  bakes.putOld();
  const double whole_s = runTool(bakes.command("new")).seconds;
  int killed = 0;
  for (int i = 0; i < kKills; ++i) {
    bakes.putOld();
    Tool tool(bakes.command("new"));
    std::this_thread::sleep_for(std::chrono::duration<double>(1.25 * whole_s * i / (kKills - 1)));
    tool.send(SIGKILL);
    const Run run = tool.wait();
    INFO("killed after " << i << "/" << kKills << " of the sweep: " << run.err);
    REQUIRE((run.status == 0 || run.status == -SIGKILL));
    killed += run.status != 0;
    requireRecovers(bakes, i);
  }
  REQUIRE(killed > 0);
}
