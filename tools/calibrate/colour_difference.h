// SPDX-License-Identifier: Apache-2.0
// CIEDE2000, and its summary over patches.
#pragma once

#include <vector>

#include "calibrate/colour_space.h"

namespace welkin::calibrate {

/// The colour difference CIEDE2000 of two colours in CIE L*a*b*, with all three weights 1 (G. Sharma, W. Wu and E. N.
/// Dalal, "The CIEDE2000 color-difference formula", Color Research and Application 30, 2005, equations 2 to 22).
double ciede2000(const Colour& lab, const Colour& other);

/// Of the differences of all patches.
struct DifferenceSummary {
  double mean = 0.0;
  double p95 = 0.0;  ///< the smallest value that 95 % of the patches do not exceed
  double worst = 0.0;
};

/// Of at least one difference.
DifferenceSummary summaryOf(std::vector<double> differences);

}  // namespace welkin::calibrate
