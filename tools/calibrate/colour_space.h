// SPDX-License-Identifier: Apache-2.0
// Colours of a calibration: linear Rec. 709 as the project has it, CIE XYZ, xyY, CIE L*a*b* under D50 and encoded sRGB.
#pragma once

#include <Eigen/Core>

namespace welkin::calibrate {

/// Three coordinates. A function's name says of which space.
using Colour = Eigen::Vector3d;

/// XYZ under D65, where white (1, 1, 1) has Y = 1, of linear Rec. 709 of any sign; and back.
Colour xyzOfRgb(const Colour& rgb);
Colour rgbOfXyz(const Colour& xyz);

/// x, y and Y of XYZ. Where X + Y + Z is not above 0, x and y are the white's, D65.
Colour xyYOfXyz(const Colour& xyz);
/// XYZ of x, y and Y, whose y is above 0.
Colour xyzOfXyY(const Colour& xyY);

/// CIE L*a*b* (CIE 15:2004, 8.2.1) under D50 of linear Rec. 709, adapted from D65 by Bradford's method; and back.
/// Reference values of charts are stated so. Negative light continues the straight part of the curve.
Colour labOfRgb(const Colour& rgb);
Colour rgbOfLab(const Colour& lab);
/// Linear Rec. 709 of x, y and Y under D50.
Colour rgbOfXyYD50(const Colour& xyY);

/// Encoded sRGB (IEC 61966-2-1) of linear Rec. 709, which is clamped to [0, 1] first.
Colour srgbOfRgb(const Colour& rgb);

}  // namespace welkin::calibrate
