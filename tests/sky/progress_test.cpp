// SPDX-License-Identifier: Apache-2.0
#include "sky/base/progress.h"

#include <catch2/catch.hpp>
#include <utility>
#include <vector>

#include "sky/base/error.h"

namespace welkin::tests {

using base::Progress;

TEST_CASE("Progress, StagesAreToldFromBeginningToEnd") {
  std::vector<std::string> told;
  const Progress all([&](const Progress::Stage& stage, Progress::Event event) {
    const char* events[] = {"began", "went on", "ended"};
    told.push_back(stage.name() + " " + events[static_cast<int>(event)] + " " + std::to_string(stage.done()) + "/" +
                   std::to_string(stage.total()));
    if (stage.name() == "inner") CHECK(stage.around()->name() == "outer");
    return true;
  });
  {
    const Progress outer = all.stage("outer", 2);
    outer.step();
    {
      const Progress inner = outer.stage("inner", 0);
      const Progress copy = inner;
      copy.step(5);
      inner.check();
      CHECK(inner.done() == 5);
    }
    outer.step();
    CHECK(outer.done() == 2);
  }
  CHECK(all.done() == 0);
  CHECK(told == std::vector<std::string>{" began 0/0", "outer began 0/2", "outer went on 1/2", "inner began 0/0",
                                         "inner went on 5/0", "inner went on 5/0", "inner ended 5/0",
                                         "outer went on 2/2", "outer ended 2/2"});
}

TEST_CASE("Progress, AnAnswerOfFalseStopsTheWork") {
  const Progress all([](const Progress::Stage& stage, Progress::Event) { return stage.done() < 3; });
  const Progress work = all.stage("work", 10);
  work.step(2);
  try {
    work.step();
    FAIL("went on");
  } catch (const base::Error& e) {
    CHECK(e.status() == base::ExitStatus::interrupted);
    CHECK(std::string(e.what()) == "interrupted; finished files are kept");
  }
}

TEST_CASE("Progress, NobodyNeedListen") {
  const Progress none;
  none.step();
  none.stage("work", 3).check();
  CHECK(none.done() == 0);
}

}  // namespace welkin::tests
