// SPDX-License-Identifier: Apache-2.0
// The error of a model on charts that had no part in its fit: others in the photograph, or those of other photographs.
#pragma once

#include <string>
#include <vector>

#include "calibrate/judge.h"
#include "calibrate/model.h"

namespace welkin::calibrate {

struct FoundChart {
  ChartPlace place;
  double confidence;  ///< PatternMatch::likeness
  Patches patches;
};

/// Searches areas that may be charts, until some are. `full` is as in measurePatches().
std::vector<Corners> areasIn(const image::Image& image, const ReferenceChart& reference, double full);

/// All charts of a linear picture, the most likely first; none where none is to be trusted. `linear_codes` is as in
/// clippingLevel().
std::vector<FoundChart> chartsIn(const image::Image& image, bool linear_codes, const ReferenceChart& reference);

/// CIEDE2000 of a chart's usable patches. Light that differs between this chart and that of the fit counts as error.
struct ChartError {
  FoundChart chart;
  std::vector<std::size_t> used;  ///< the usable patches
  std::vector<double> before;     ///< as photographed
  std::vector<double> after;      ///< by the model
};

/// The error on a chart that chartsIn() found, which so has at least kLeastPatches usable patches.
ChartError errorOn(const FoundChart& chart, const Model& model, const ReferenceChart& reference);

}  // namespace welkin::calibrate
