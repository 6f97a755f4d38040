// SPDX-License-Identifier: Apache-2.0
// The place of a chart in a picture: the homography from the chart's plane to pixels.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <optional>

namespace welkin::calibrate {

/// A point of a picture in pixels from its upper left corner; the centre of the first pixel is (0.5, 0.5).
using Point = Eigen::Vector2d;

/// The corners of the area of patches, next to dark skin, bluish green, black and white in this order.
using Corners = std::array<Point, 4>;

/// Width, height and parts of the area of patches, in the units of OpenCV's model of the chart: its rim and the gaps
/// between patches are 0.25 wide.
inline constexpr double kChartWidth = 16.75, kChartHeight = 11.25, kPatchSide = 2.5, kPatchStep = 2.75, kRim = 0.25;

class ChartPlace {
 public:
  /// None if the corners are not those of a convex area above 1 square pixel.
  static std::optional<ChartPlace> of(const Corners& corners);

  const Corners& corners() const { return corners_; }

  /// The pixel of a point of the chart, x in [0, kChartWidth] and y in [0, kChartHeight].
  Point pixelOf(double x, double y) const;

  /// The pixel of a point of a patch; u and v run from 0 to 1 over its sides.
  Point pixelOf(std::size_t patch, double u, double v) const;

  /// The shortest side of a patch, in pixels.
  double shortestSide() const;

  /// The same area with the chart turned by quarters of a turn.
  ChartPlace turned(std::size_t quarters) const;

 private:
  ChartPlace(const Corners& corners, const Eigen::Matrix3d& to_pixels) : corners_(corners), to_pixels_(to_pixels) {}

  Corners corners_;
  Eigen::Matrix3d to_pixels_;
};

}  // namespace welkin::calibrate
