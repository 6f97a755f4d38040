// SPDX-License-Identifier: Apache-2.0
// Pictures of a ColorChecker through a known camera.
#pragma once

#include <cstdint>
#include <filesystem>

#include "calibrate/chart_place.h"
#include "calibrate/patches.h"
#include "calibrate/reference_chart.h"
#include "sky/image/image.h"

namespace welkin::tests {

/// The chart's colours as sold since November 2014.
inline const calibrate::ReferenceChart& laterChart() {
  static const calibrate::ReferenceChart kChart = calibrate::referenceChart(calibrate::Edition::after_2014);
  return kChart;
}

/// From albedo to linear light that a picture holds, in this order.
struct Camera {
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Identity();
  double exponent = 1.0;  ///< of a curve that the picture's encoding does not undo
  double vignette = 0.0;  ///< part of the light that the picture's corners lose
  double gradient = 0.0;  ///< part of the light that the chart loses from its left to its right
  double noise = 0.0;     ///< standard deviation in encoded sRGB
  bool quantised = true;  ///< to 8 bits of encoded sRGB
};

struct Scene {
  int width = 640, height = 480;
  calibrate::Corners corners = {calibrate::Point(120.0, 100.0), calibrate::Point(520.0, 100.0),
                                calibrate::Point(520.0, 370.0), calibrate::Point(120.0, 370.0)};
  std::uint64_t seed = 1;
};

/// The albedo of a point of the chart's plane, in units of ChartPlace; black between patches and on a rim of 0.7, a
/// wall of grey elsewhere.
calibrate::Colour chartAlbedo(const calibrate::ReferenceChart& reference, double x, double y);

/// The picture, linear as a reader gives it.
image::Image photograph(const calibrate::ReferenceChart& reference, const Scene& scene, const Camera& camera);

/// A picture 640 wide with a chart in each half, through one camera each.
struct TwoCharts {
  Scene left, right;
  image::Image image;
};
TwoCharts photographTwo(const calibrate::ReferenceChart& reference, const Camera& left, const Camera& right);

/// Writes a PNG of 8 bits in sRGB.
void writeCoded(const std::filesystem::path& path, const image::Image& image);

/// The patches without a picture: every mean is the camera's colour.
calibrate::Patches seenPatches(const calibrate::ReferenceChart& reference, const Camera& camera);

/// A matrix as cameras have it: channels leak into each other, and its white is warm.
Eigen::Matrix3d leakyMatrix();

}  // namespace welkin::tests
