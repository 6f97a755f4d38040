// SPDX-License-Identifier: Apache-2.0
// Undo and redo of changes of the light.
#include "view/history.h"

#include <catch2/catch.hpp>

using namespace welkin::view;

namespace {

Undoable skyOf(double factor) {
  Undoable step;
  step.changes.sky = factor;
  return step;
}

}  // namespace

TEST_CASE("History, StepsGoBackAndForth") {
  History history;
  CHECK(!history.undo(skyOf(1.0)));
  CHECK(!history.redo(skyOf(1.0)));
  history.record(skyOf(1.0), false);
  history.record(skyOf(2.0), false);
  CHECK(history.undo(skyOf(3.0)) == skyOf(2.0));
  CHECK(history.undo(skyOf(2.0)) == skyOf(1.0));
  CHECK(!history.undo(skyOf(1.0)));
  CHECK(history.redo(skyOf(1.0)) == skyOf(2.0));
  CHECK((history.undoCount() == 1 && history.redoCount() == 1));
  history.record(skyOf(2.0), false);  // a new change ends what could be redone
  CHECK((history.undoCount() == 2 && history.redoCount() == 0));
}

TEST_CASE("History, JoinedChangesAreOneStep") {
  History history;
  history.record(skyOf(1.0), true);  // there is none to join
  CHECK(history.undoCount() == 1);
  history.record(skyOf(1.5), true);
  history.record(skyOf(2.0), true);
  CHECK(history.undoCount() == 1);
  CHECK(history.undo(skyOf(2.5)) == skyOf(1.0));
  CHECK(history.redo(skyOf(1.0)) == skyOf(2.5));
}

TEST_CASE("History, OldStepsAreForgotten") {
  History history;
  for (int i = 0; i < 1200; ++i) history.record(skyOf(i), false);
  CHECK(history.undoCount() == 1000);
  CHECK(history.undo(skyOf(1200.0)) == skyOf(1199.0));
}
