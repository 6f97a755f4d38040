// SPDX-License-Identifier: Apache-2.0
// Labels of points keep off each other and off what they can.
#include <catch2/catch.hpp>
#include <random>

#include "study/label_layout.h"

namespace welkin::study {
namespace {

constexpr Box kFrame = {0.0, 0.0, 600.0, 400.0};

Box around(double x, double y, double half) {
  return {x - half, y - half, x + half, y + half};
}

TEST_CASE("SharedArea, OfBoxes") {
  CHECK(sharedArea({0, 0, 4, 3}, {1, 1, 9, 9}) == 6.0);
  CHECK(sharedArea({0, 0, 4, 3}, {4, 0, 8, 3}) == 0.0);
  CHECK(sharedArea({0, 0, 4, 3}, {1, 5, 2, 6}) == 0.0);
}

TEST_CASE("PlaceLabels, AlonePutsItAboveToTheRight") {
  const auto placed = placeLabels({{300.0, 200.0, 60.0, 12.0}}, {{around(300.0, 200.0, 5.0), 1.0}}, kFrame);
  REQUIRE(placed[0]);
  CHECK(placed[0]->box.left > 300.0);
  CHECK(placed[0]->box.bottom < 200.0);
}

TEST_CASE("PlaceLabels, GivesWayToWhatIsThere") {
  // To the right everything is taken.
  const auto placed = placeLabels({{300.0, 200.0, 60.0, 12.0}}, {{{306.0, 0.0, 600.0, 400.0}, 1.0}}, kFrame);
  REQUIRE(placed[0]);
  CHECK(placed[0]->box.right <= 306.0);
}

TEST_CASE("PlaceLabels, StaysWithinTheFrame") {
  for (const double x : {1.0, 300.0, 599.0}) {
    for (const double y : {1.0, 200.0, 399.0}) {
      const auto placed = placeLabels({{x, y, 80.0, 12.0}}, {}, kFrame);
      REQUIRE(placed[0]);
      const Box& box = placed[0]->box;
      CHECK((box.left >= 0.0 && box.top >= 0.0 && box.right <= 600.0 && box.bottom <= 400.0));
    }
  }
}

TEST_CASE("PlaceLabels, NeverOverlap") {
  std::mt19937 random(11);
  std::vector<LabelRequest> requests;
  std::vector<Obstacle> obstacles;
  for (int i = 0; i < 40; ++i) {
    const double x = static_cast<double>(random() % 600);
    const double y = static_cast<double>(random() % 400);
    requests.push_back({x, y, 70.0, 13.0});
    obstacles.push_back({around(x, y, 5.0), 1.0});
  }
  const auto placed = placeLabels(requests, obstacles, kFrame);
  int count = 0;
  for (std::size_t i = 0; i < placed.size(); ++i) {
    if (!placed[i]) continue;
    ++count;
    for (std::size_t j = 0; j < i; ++j) {
      if (placed[j]) CHECK(sharedArea(placed[i]->box, placed[j]->box) == 0.0);
    }
  }
  CHECK(count >= 38);
}

TEST_CASE("PlaceLabels, LeavesOutWhatHasNoRoom") {
  const std::vector<LabelRequest> requests(30, {300.0, 200.0, 550.0, 60.0});
  const auto placed = placeLabels(requests, {}, kFrame);
  CHECK(placed.front());
  CHECK_FALSE(placed.back());
}

}  // namespace
}  // namespace welkin::study
