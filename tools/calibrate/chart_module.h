// SPDX-License-Identifier: Apache-2.0
// Welkin's use of OpenCV's chart detector (contrib module mcc of OpenCV 4), as a module that is loaded when a
// photograph is searched: OpenCV's libraries and those that they need take longer to load than all other commands.
#pragma once

#include <cstdint>
#include <vector>

#include "calibrate/chart_place.h"

namespace welkin::calibrate {

/// Chart candidates of OpenCV's detector.
struct Candidate {
  Corners corners;    ///< in pixels, as ChartPlace has them
  double cost = 0.0;  ///< of OpenCV's match of colours; smaller is better, and false ones may be small as well
};

struct ChartModule {
  /// Looks for ColorChecker Classic charts in width x height texels of 8 bits, blue first, on one thread. The result
  /// depends on nothing else. Throws Error(internal) with OpenCV's message.
  std::vector<Candidate> (*detect)(int width, int height, const std::uint8_t* bgr);
};

/// Loads the module once. Throws Error(file) when it is not beside the program.
const ChartModule& chartModule();

/// Name of the function that the module exports.
inline constexpr const char* kChartModuleEntry = "welkinChartModule";

}  // namespace welkin::calibrate
