// SPDX-License-Identifier: Apache-2.0
// A gradient: the sky's colour over the time of day (columns) and elevation (rows), at one azimuth.
#pragma once

#include <vector>

#include "sky/base/curve.h"

namespace welkin::model {

using det::Number3;

/// Linear Rec. 709, >= 0. Row 0 is the horizon. See shaders/shared/gradient.glsl for the position of a texel.
struct Gradient {
  int width = 1;
  int height = 1;
  std::vector<float> rgb = {1.0F, 1.0F, 1.0F};  ///< row-major

  static Gradient constant(const Number3& colour);
  Number3 texel(int column, int row) const;
  double brightestLuminance() const;
};

/// The colours at one instant from the horizon to the zenith: linear between row centres, clamped outside them.
struct GradientColumn {
  std::vector<Number3> row;

  Number3 at(double elevation_rad) const;
  /// Elevation of the centre of row j, radians.
  double centre(int j) const { return (j + 0.5) / static_cast<double>(row.size()) * det::kHalfPi; }
  /// Whether the colour bends at the centre of row j. Never true for a column of one colour.
  bool bendsAt(int j) const;
};

/// Interpolates the gradient's columns at a finite time.
GradientColumn columnAt(const Gradient& gradient, double time_h);

/// Storage format of a gradient's texels in a file.
enum class GradientFormat {
  rgb32f,  ///< floats: 12 bytes, exact
  rgb9e5   ///< shared exponent: 4 bytes, each component within 2^-9 of the texel's largest
};

/// "rgb32f" or "rgb9e5".
constexpr const char* nameOf(GradientFormat format) {
  return format == GradientFormat::rgb9e5 ? "rgb9e5" : "rgb32f";
}

/// Returns the gradient as it is read back from a file of that format.
Gradient rounded(const Gradient& gradient, GradientFormat format);

/// Divides both gradients by the brightest luminance of either. That luminance becomes 1, so only hue and saturation
/// count and numbers of any range become safe. Two black gradients stay black. Afterwards colours fade below the
/// luminance kGradientDelta.
void normalise(Gradient& a, Gradient& b);

/// 1e-4 of the brightest gradient luminance.
inline constexpr double kGradientDelta = 1e-4;

}  // namespace welkin::model
