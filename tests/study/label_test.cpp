// SPDX-License-Identifier: Apache-2.0
// Places of labels: off lines, markers and other labels. The oracle walks along the lines in small steps.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "study/chart_label.h"

namespace welkin::study {
namespace {

constexpr Box kFrame{100.0, 60.0, 800.0, 540.0};
constexpr double kWidth = 50.0;
constexpr double kHeight = 14.0;
constexpr double kRadius = 5.0;
constexpr double kFar = 40.0;  // of the label's nearest border from its point: further, and it seems to be another's

bool isWithin(double x, double y, const Box& box) {
  return x >= box.left && x <= box.right && y >= box.bottom && y <= box.top;
}

/// Slow reference of meets(): points along the segment.
bool passesThrough(const Segment& line, const Box& box) {
  constexpr int kSteps = 20000;
  for (int i = 0; i <= kSteps; ++i) {
    const double t = static_cast<double>(i) / kSteps;
    if (isWithin(std::lerp(line.x0, line.x1, t), std::lerp(line.y0, line.y1, t), box)) return true;
  }
  return false;
}

bool overlap(const Box& a, const Box& b) {
  return std::max(a.left, b.left) < std::min(a.right, b.right) && std::max(a.bottom, b.bottom) < std::min(a.top, b.top);
}

Box around(double x, double y) {
  return {x - kRadius, y - kRadius, x + kRadius, y + kRadius};
}

double distance(const Box& box, double x, double y) {
  return std::hypot(std::max({box.left - x, 0.0, x - box.right}), std::max({box.bottom - y, 0.0, y - box.top}));
}

TEST_CASE("Meets, AgreesWithPointsAlongTheSegment") {
  const Box box{10.0, 20.0, 30.0, 28.0};
  int met = 0;
  int missed = 0;
  for (int i = 0; i < 400; ++i) {  // ends on a grid that is off the box's borders and corners
    const Segment line{1.3 + (i % 4) * 11.0, 13.7 + (i / 4 % 5) * 5.0, 2.1 + (i / 20 % 4) * 12.0, 14.3 + i / 80 * 4.7};
    const bool expected = passesThrough(line, box);
    CHECK(meets(line, box) == expected);
    ++(expected ? met : missed);
  }
  CHECK(met > 50);
  CHECK(missed > 50);
}

TEST_CASE("Meets, SegmentsAlongAnAxis") {
  const Box box{10.0, 20.0, 30.0, 28.0};
  CHECK(meets({0.0, 24.0, 40.0, 24.0}, box));
  CHECK_FALSE(meets({0.0, 29.0, 40.0, 29.0}, box));
  CHECK_FALSE(meets({0.0, 24.0, 9.0, 24.0}, box));
  CHECK(meets({15.0, 0.0, 15.0, 40.0}, box));
  CHECK(meets({15.0, 25.0, 15.0, 25.0}, box));  // a point
}

TEST_CASE("LabelRoom, LabelsLieOffTheirLineAtEverySlope") {
  for (int degrees = 0; degrees < 360; degrees += 5) {
    const double angle = degrees * std::numbers::pi / 180.0;
    const double x = 450.0;
    const double y = 300.0;
    const Segment line{x - 200.0 * std::cos(angle), y - 200.0 * std::sin(angle), x + 200.0 * std::cos(angle),
                       y + 200.0 * std::sin(angle)};
    LabelRoom room(kFrame);
    room.addLine(line);
    room.addMarker(x, y, kRadius);
    const LabelPlace place = room.place(x, y, kWidth, kHeight);
    INFO(degrees);
    CHECK_FALSE(passesThrough(line, place.box));
    CHECK_FALSE(overlap(place.box, around(x, y)));
    CHECK(distance(place.box, x, y) < kFar);
    CHECK(place.box.right - place.box.left == Approx(kWidth));
    CHECK(place.box.top - place.box.bottom == Approx(kHeight));
  }
}

TEST_CASE("LabelRoom, LabelsOfOneLineLieOffEachOther") {
  LabelRoom room(kFrame);
  std::vector<Segment> lines;
  for (int i = 0; i < 6; ++i) {  // a zigzag, whose points are nearer than a label is wide
    const double x = 300.0 + 40.0 * i;
    lines.push_back({x, i % 2 == 0 ? 300.0 : 315.0, x + 40.0, i % 2 == 0 ? 315.0 : 300.0});
    room.addLine(lines.back());
    room.addMarker(lines.back().x0, lines.back().y0, kRadius);
  }
  std::vector<Box> labels;
  for (const Segment& line : lines) labels.push_back(room.place(line.x0, line.y0, kWidth, kHeight).box);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    for (const Segment& line : lines) {
      CHECK_FALSE(passesThrough(line, labels[i]));
      CHECK_FALSE(overlap(labels[i], around(line.x0, line.y0)));
    }
    for (std::size_t j = 0; j < i; ++j) CHECK_FALSE(overlap(labels[i], labels[j]));
  }
}

TEST_CASE("LabelRoom, LabelsStayInTheFrame") {
  for (const double x : {kFrame.left, 450.0, kFrame.right})
    for (const double y : {kFrame.bottom, 300.0, kFrame.top}) {
      LabelRoom room(kFrame);
      for (int i = 0; i < 30; ++i) room.addLine({kFrame.left, 60.0 + 16.0 * i, kFrame.right, 60.0 + 16.0 * i});
      const Box box = room.place(x, y, kWidth, kHeight).box;
      INFO(x << ' ' << y);
      CHECK(box.left >= kFrame.left);
      CHECK(box.right <= kFrame.right);
      CHECK(box.bottom >= kFrame.bottom);
      CHECK(box.top <= kFrame.top);
    }
}

TEST_CASE("LabelRoom, WordsBeginOrEndAtTheirPoint") {
  LabelRoom empty(kFrame);
  CHECK(empty.place(450.0, 300.0, kWidth, kHeight).alignment == Alignment::left);
  CHECK(empty.place(kFrame.right, 300.0, kWidth, kHeight).alignment == Alignment::right);
}

}  // namespace
}  // namespace welkin::study
