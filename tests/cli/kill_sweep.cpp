// SPDX-License-Identifier: Apache-2.0
#include "kill_sweep.h"

#include <signal.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <thread>

#include "two_bakes.h"

namespace welkin::tests {

void killAtEveryCall(const KillSweep& sweep, int least) {
  for (int call = 1;; ++call) {
    sweep.prepare();
    const Run run = runTool(sweep.command, on({"kill", std::to_string(call), ""}));
    INFO("killed at call " << call << ": " << run.err);
    if (run.status == 0) {
      REQUIRE(call > least);
      break;
    }
    REQUIRE(run.status == -SIGKILL);
    sweep.requireGood(call);
  }
}

void killAtAnyTime(const KillSweep& sweep, int kills) {
  constexpr double kLonger = 1.25;
  sweep.prepare();
  const double whole_s = runTool(sweep.command).seconds;
  int killed = 0;
  for (int i = 0; i < kills; ++i) {
    sweep.prepare();
    Tool tool(sweep.command);
    std::this_thread::sleep_for(std::chrono::duration<double>(kLonger * whole_s * i / (kills - 1)));
    tool.send(SIGKILL);
    const Run run = tool.wait();
    INFO("killed after " << i << "/" << kills << " of the sweep: " << run.err);
    REQUIRE((run.status == 0 || run.status == -SIGKILL));
    killed += run.status != 0;
    sweep.requireGood(i);
  }
  REQUIRE(killed > 0);
}

}  // namespace welkin::tests
