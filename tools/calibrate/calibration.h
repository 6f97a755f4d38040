// SPDX-License-Identifier: Apache-2.0
// The calibration of one measured chart: the chosen model, and its errors.
#pragma once

#include <string>
#include <vector>

#include "calibrate/colour_difference.h"
#include "calibrate/model.h"
#include "calibrate/patches.h"

namespace welkin::calibrate {

/// Least number of patches that are fit to be used. Fewer leave out whole regions of colour.
inline constexpr std::size_t kLeastPatches = 18;

/// Errors of one model on the used patches, CIEDE2000 patch by patch.
struct ModelErrors {
  const ModelKind* kind = nullptr;
  std::vector<double> fit;       ///< after the fit to all used patches
  std::vector<double> left_out;  ///< after fits without the patch
  std::vector<double> row_out;   ///< after fits without the patch's row of the chart; empty if not determined
};

struct Calibration {
  Model model;
  std::vector<std::size_t> used;   ///< the patches of the fit
  std::vector<double> before;      ///< CIEDE2000 of the used patches as photographed
  std::vector<ModelErrors> tried;  ///< one for each model that the patches determine
  std::size_t chosen = 0;          ///< of `tried`
  double rss_srgb = 0.0;           ///< sum of squares of encoded sRGB, in [0, 1], over used patches and channels
  double rss_xyY = 0.0;            ///< the same of x, y and Y

  const ModelErrors& errors() const { return tried[chosen]; }
};

/// The used patches of a chart as pairs.
std::vector<Pair> pairsOf(const Patches& patches, const ReferenceChart& reference,
                          const std::vector<std::size_t>& used);

/// Fits the named model, or for "auto" the one of the smallest mean CIEDE2000 left out, one patch at a time. Throws
/// Error(content), naming `photo`, if too few patches can be used or they do not determine the model.
Calibration calibratePatches(const std::string& photo, const Patches& patches, const ReferenceChart& reference,
                             std::string_view model);

}  // namespace welkin::calibrate
