// SPDX-License-Identifier: Apache-2.0
// Places for the labels of a chart's points: beside the point, off every line, marker and other label. Lengths are
// pixels; y grows upwards.
#pragma once

#include <cstddef>
#include <vector>

namespace welkin::study {

struct Box {
  double left, bottom, right, top;
};

struct Segment {
  double x0, y0, x1, y1;
};

/// Whether some part of a segment lies within a box; touching its border counts.
bool meets(const Segment& segment, const Box& box);

enum class Alignment { left, centre, right };  ///< the edge of the box at which its words begin or end

struct LabelPlace {
  Box box;
  Alignment alignment;
};

/// The room for labels within the frame of a chart. First add all lines and markers, then place the labels.
class LabelRoom {
 public:
  explicit LabelRoom(const Box& frame) : frame_(frame) {}

  void addLine(const Segment& line) { lines_.push_back(line); }
  void addMarker(double x, double y, double radius) {
    taken_.push_back({x - radius, y - radius, x + radius, y + radius});
  }

  /// The place of a label of this size beside the point (x, y), within the frame unless the label is wider. It meets
  /// as few lines, markers and earlier labels as any of the places that are tried: eight round the point, then eight
  /// further away. From now on it is taken.
  LabelPlace place(double x, double y, double width, double height);

 private:
  std::size_t obstaclesOf(const Box& box) const;

  Box frame_;
  std::vector<Segment> lines_;
  std::vector<Box> taken_;
};

}  // namespace welkin::study
