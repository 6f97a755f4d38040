// SPDX-License-Identifier: Apache-2.0
#include "study/label_layout.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>

namespace welkin::study {
namespace {

constexpr double kGap = 3.0;             // between labels, in pixels
constexpr double kCostOfDistance = 1.5;  // square pixels of a covered marker that a pixel of distance is worth
constexpr int kAttempts = 8;             // at leaving no label out
constexpr double kLeadStep = 4.0;        // pixels
constexpr double kLeadWeight = 2.0;      // of a line to a point as an obstacle for later labels

struct Side {
  double x;  // -1, 0, 1: to the left of the point, centred, to the right
  double y;  // -1: above
};
constexpr std::array<Side, 8> kSides = {{{1, -1}, {1, 0}, {0, -1}, {1, 1}, {-1, 1}, {0, 1}, {-1, 0}, {-1, -1}}};
constexpr std::array<double, 7> kDistances = {10.0, 15.0, 22.0, 32.0, 46.0, 64.0, 90.0};

Box boxAt(const LabelRequest& request, const Side& side, double distance) {
  const bool corner = side.x != 0.0 && side.y != 0.0;
  const double reach = corner ? distance * 0.7 : distance;
  const double x = request.x + side.x * (reach + request.width / 2.0);
  const double y = request.y + side.y * (reach + request.height / 2.0);
  return {x - request.width / 2.0, y - request.height / 2.0, x + request.width / 2.0, y + request.height / 2.0};
}

bool within(const Box& inner, const Box& outer) {
  return inner.left >= outer.left && inner.top >= outer.top && inner.right <= outer.right &&
         inner.bottom <= outer.bottom;
}

// The line from the point to its label as small boxes, without the surroundings of the point itself.
std::vector<Box> leadOf(const LabelRequest& request, const PlacedLabel& label) {
  const double x = label.lead_x - request.x;
  const double y = label.lead_y - request.y;
  const double length = std::hypot(x, y);
  std::vector<Box> parts;
  for (double along = kDistances.front(); along < length; along += kLeadStep) {
    const double px = request.x + x * along / length;
    const double py = request.y + y * along / length;
    parts.push_back({px - kLeadStep / 2.0, py - kLeadStep / 2.0, px + kLeadStep / 2.0, py + kLeadStep / 2.0});
  }
  return parts;
}

using Placed = std::vector<std::optional<PlacedLabel>>;

// The place of one label at the least cost, if it has one that keeps off the others.
std::optional<PlacedLabel> bestPlace(const LabelRequest& request, const Placed& placed,
                                     const std::vector<Obstacle>& obstacles, const Box& frame) {
  std::optional<PlacedLabel> best;
  double least = std::numeric_limits<double>::infinity();
  for (const double distance : kDistances) {
    for (const Side& side : kSides) {
      const Box box = boxAt(request, side, distance);
      const PlacedLabel label = {box, std::clamp(request.x, box.left, box.right),
                                 std::clamp(request.y, box.top, box.bottom)};
      std::vector<Box> covered = leadOf(request, label);
      covered.push_back({box.left - kGap, box.top - kGap, box.right + kGap, box.bottom + kGap});
      const auto collides = [&](const std::optional<PlacedLabel>& other) {
        return other &&
               std::ranges::any_of(covered, [&](const Box& part) { return sharedArea(part, other->box) > 0.0; });
      };
      if (!within(box, frame) || std::ranges::any_of(placed, collides)) continue;
      covered.back() = box;
      double cost = kCostOfDistance * distance;
      for (const Obstacle& obstacle : obstacles) {
        for (const Box& part : covered) cost += obstacle.weight * sharedArea(part, obstacle.box);
      }
      if (cost < least) {
        least = cost;
        best = label;
      }
    }
  }
  return best;
}

Placed placedInOrder(const std::vector<LabelRequest>& requests, const std::vector<std::size_t>& order,
                     std::vector<Obstacle> obstacles, const Box& frame) {
  Placed placed(requests.size());
  for (const std::size_t i : order) {
    placed[i] = bestPlace(requests[i], placed, obstacles, frame);
    if (!placed[i]) continue;
    for (const Box& part : leadOf(requests[i], *placed[i])) obstacles.push_back({part, kLeadWeight});
  }
  return placed;
}

}  // namespace

double sharedArea(const Box& a, const Box& b) {
  const double width = std::min(a.right, b.right) - std::max(a.left, b.left);
  const double height = std::min(a.bottom, b.bottom) - std::max(a.top, b.top);
  return width > 0.0 && height > 0.0 ? width * height : 0.0;
}

std::vector<std::optional<PlacedLabel>> placeLabels(const std::vector<LabelRequest>& requests,
                                                    const std::vector<Obstacle>& obstacles, const Box& frame) {
  std::vector<std::size_t> order(requests.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  Placed best;
  std::ptrdiff_t fewest_left_out = std::numeric_limits<std::ptrdiff_t>::max();
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    Placed placed = placedInOrder(requests, order, obstacles, frame);
    const std::ptrdiff_t left_out = std::ranges::count_if(placed, [](const auto& label) { return !label; });
    std::stable_partition(order.begin(), order.end(), [&](std::size_t i) { return !placed[i]; });  // first next time
    if (left_out < fewest_left_out) {
      fewest_left_out = left_out;
      best = std::move(placed);
    }
    if (fewest_left_out == 0) break;
  }
  return best;
}

}  // namespace welkin::study
