// SPDX-License-Identifier: Apache-2.0
#include "study/chart_label.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace welkin::study {
namespace {

// Gaps between a point and its label, in pixels: of a label straight beside, above or below it, and of one at a corner.
constexpr double kBeside = 9.0;
constexpr double kAtCorner = 6.0;
constexpr std::array<double, 2> kRings = {0.0, 8.0};  // added to both gaps
constexpr std::size_t kOutside = 1000;                // obstacles that leaving the frame counts for

/// Where a label lies from its point: -1, 0 or 1 along each axis.
struct Side {
  int x, y;
};

// The most readable first.
constexpr std::array<Side, 8> kSides = {{{1, 1}, {1, -1}, {-1, -1}, {-1, 1}, {1, 0}, {0, 1}, {0, -1}, {-1, 0}}};

/// Ends of a length on one side of `at`.
std::pair<double, double> extent(double at, int side, double gap, double length) {
  if (side == 0) return {at - length / 2.0, at + length / 2.0};
  return side > 0 ? std::pair(at + gap, at + gap + length) : std::pair(at - gap - length, at - gap);
}

bool overlap(const Box& a, const Box& b) {
  return a.left < b.right && b.left < a.right && a.bottom < b.top && b.bottom < a.top;
}

}  // namespace

// Liang and Barsky, "A new concept and method for line clipping", 1984: the part of the segment within both slabs.
bool meets(const Segment& segment, const Box& box) {
  double from = 0.0;
  double to = 1.0;
  const auto clip = [&](double start, double step, double low, double high) {
    if (step == 0.0) return start >= low && start <= high;
    const double at_low = (low - start) / step;
    const double at_high = (high - start) / step;
    from = std::max(from, std::min(at_low, at_high));
    to = std::min(to, std::max(at_low, at_high));
    return from <= to;
  };
  return clip(segment.x0, segment.x1 - segment.x0, box.left, box.right) &&
         clip(segment.y0, segment.y1 - segment.y0, box.bottom, box.top);
}

std::size_t LabelRoom::obstaclesOf(const Box& box) const {
  const bool is_inside =
      box.left >= frame_.left && box.right <= frame_.right && box.bottom >= frame_.bottom && box.top <= frame_.top;
  const auto lines = std::ranges::count_if(lines_, [&](const Segment& line) { return meets(line, box); });
  const auto boxes = std::ranges::count_if(taken_, [&](const Box& other) { return overlap(other, box); });
  return (is_inside ? 0 : kOutside) + static_cast<std::size_t>(lines + boxes);
}

LabelPlace LabelRoom::place(double x, double y, double width, double height) {
  LabelPlace best{};
  std::size_t fewest = std::numeric_limits<std::size_t>::max();
  for (const double ring : kRings)
    for (const Side side : kSides) {
      const double gap = ring + (side.x != 0 && side.y != 0 ? kAtCorner : kBeside);
      const auto [left, right] = extent(x, side.x, gap, width);
      const auto [bottom, top] = extent(y, side.y, gap, height);
      const Box box{left, bottom, right, top};
      const std::size_t obstacles = obstaclesOf(box);
      if (obstacles >= fewest) continue;
      fewest = obstacles;
      best = {box, side.x > 0 ? Alignment::left : side.x < 0 ? Alignment::right : Alignment::centre};
    }
  taken_.push_back(best.box);
  return best;
}

}  // namespace welkin::study
