// SPDX-License-Identifier: Apache-2.0
// Where labels go beside the points of a chart, so that they hide neither each other nor, where it can be, the points.
#pragma once

#include <optional>
#include <vector>

namespace welkin::study {

/// A rectangle in pixels, y down.
struct Box {
  double left;
  double top;
  double right;
  double bottom;
};

/// Area that two boxes share, in square pixels.
double sharedArea(const Box& a, const Box& b);

/// A label of `width` x `height` pixels that belongs to the point (x, y).
struct LabelRequest {
  double x;
  double y;
  double width;
  double height;
};

/// What a label should rather not cover: the higher the weight, the less. Markers have 1.
struct Obstacle {
  Box box;
  double weight;
};

/// A label in its place, and where on its edge a line to its point ends.
struct PlacedLabel {
  Box box;
  double lead_x;
  double lead_y;
};

/// Places the labels one after the other, each within `frame`, at the least cost in covered obstacles, in what a line
/// to its point would cross, and in distance, among the positions around the point. A label for which every position
/// would overlap one placed before, or lead through it, is left out.
std::vector<std::optional<PlacedLabel>> placeLabels(const std::vector<LabelRequest>& requests,
                                                    const std::vector<Obstacle>& obstacles, const Box& frame);

}  // namespace welkin::study
