// SPDX-License-Identifier: Apache-2.0
// What a picture shows of a chart's patches: robust means in linear light, and how far each patch can be trusted.
#pragma once

#include <array>

#include "calibrate/chart_place.h"
#include "calibrate/reference_chart.h"
#include "sky/image/image.h"

namespace welkin::calibrate {

/// Light within a patch differs by this part of encoded sRGB's range at most, from quarter to quarter of the patch. It
/// is 10 of 255 codes, about 4 of L*, and so as much as the error of a fit.
inline constexpr double kMostUneven = 0.04;

/// Most samples of a patch that may be at the end of the code's range, as a part. Trimmed means then stay unbiased.
inline constexpr double kMostClipped = 0.05;

struct Patch {
  Colour mean = Colour::Zero();    ///< linear Rec. 709: for each channel the mean of the middle half of its samples
  Colour spread = Colour::Zero();  ///< a normal distribution's standard deviation by the quartiles, linear
  double uneven = 0.0;             ///< largest difference of the quarters' means in a channel, in encoded sRGB
  double clipped = 0.0;            ///< part of the samples with a channel at the end of the range

  bool is_foreign = false;  ///< whether its colour is none that the chart has there

  bool isUneven() const { return uneven > kMostUneven; }
  bool isClipped() const { return clipped > kMostClipped; }
  bool isUsable() const { return !isUneven() && !isClipped() && !is_foreign; }
};

using Patches = std::array<Patch, kPatches>;

/// Samples the middle of every patch, half as wide and high as the patch. `full` is the linear value of the largest
/// code; infinity for pictures of floats, which do not clip. All corners of the place lie within the picture.
Patches measurePatches(const image::Image& image, const ChartPlace& place, double full);

/// The linear value that counts as clipped: that of code 253.5 of 255, or none where a value is above 1.
double clippingLevel(const image::Image& image, bool linear_codes);

}  // namespace welkin::calibrate
