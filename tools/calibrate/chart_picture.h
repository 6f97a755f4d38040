// SPDX-License-Identifier: Apache-2.0
// The picture of a report: where the charts are, their colours, and the error of every patch.
#pragma once

#include <string>
#include <vector>

#include "calibrate/other_chart.h"

namespace welkin::calibrate {

/// Of the chart in the picture. Differences are CIEDE2000, one for each used patch.
struct DrawnChart {
  Patches patches;  ///< as photographed, with what light's gradient was taken out
  Model model;
  std::vector<std::size_t> used;
  std::vector<double> before, after;
  std::vector<double> left_out;  ///< empty where the chart was not fitted
};

/// Bytes of a PNG of kPictureWidth times kPictureHeight pixels. On the left the photograph, with the outline of all
/// charts and a ring at dark skin; the first chart is the drawn one. On the right its patches: as photographed,
/// calibrated and wanted. Below, a bar for each patch: its error left out, in it that of the model, and a dash for that
/// before. Patches that are not used are crossed. Throws Error(internal) if memory runs out.
std::string drawReport(const image::Image& photo, const std::vector<ChartPlace>& charts, const DrawnChart& chart,
                       const ReferenceChart& reference);

inline constexpr int kPictureWidth = 1240, kPictureHeight = 840;

/// A part of the picture in pixels from the upper left.
struct Box {
  double x, y, width, height;
};

/// The photograph, scaled to fit.
Box photoBox(int width, int height);

/// A patch's three colours, each a third of the width.
Box cellOf(std::size_t patch);

/// The place of a patch's bar; its height stands for errorRange().
Box barOf(std::size_t patch);

/// The error at the top of the bars: the least of 1, 2 and 5 times a power of 10 that holds all of the chart's.
double errorRange(const DrawnChart& chart);

}  // namespace welkin::calibrate
