// SPDX-License-Identifier: Apache-2.0
// Kills a bake. Every file is then the old or the new one, and the next bake cleans up.
#include <catch2/catch.hpp>

#include "kill_sweep.h"
#include "two_bakes.h"

using namespace welkin::tests;
namespace fs = std::filesystem;

namespace {

/// Checks the folder after a kill. Its files may be of both bakes, which validate of the folder would say. Then a bake
/// of either sky must leave the same files as in an empty folder.
void requireRecovers(const TwoBakes& bakes, int turn) {
  bakes.requireWhole(true);
  const fs::path sky_file = bakes.out() / "sky.welkin";
  if (fs::exists(sky_file)) REQUIRE(runTool({"validate", sky_file}).status == 0);
  const std::string sky = turn % 2 == 0 ? "old" : "new";
  REQUIRE(runTool(bakes.command(sky)).status == 0);
  bakes.requireIs(sky);
}

/// The bake of the new sky, over the old one or in a new folder.
KillSweep sweepOf(TwoBakes& bakes, bool fresh) {
  return {bakes.command("new"), [&bakes, fresh] { fresh ? bakes.putNothing() : bakes.putOld(); },
          [&bakes](int turn) { requireRecovers(bakes, turn); }};
}

}  // namespace

TEST_CASE("Kill, AtEveryCallThatChangesTheDisk") {
  const bool fresh = GENERATE(false, true);
  TwoBakes bakes(4);
  INFO((fresh ? "in a new folder" : "over an old bake"));
  killAtEveryCall(sweepOf(bakes, fresh), 6 * 8);
}

TEST_CASE("Kill, AtAnyTime") {
  TwoBakes bakes(32);
  killAtAnyTime(sweepOf(bakes, false), 40);
}
