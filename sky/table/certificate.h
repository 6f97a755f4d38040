// SPDX-License-Identifier: Apache-2.0
// A bake's statement of its own error.
#pragma once

#include <vector>

#include "sky/base/curve.h"

namespace welkin::table {

using det::Number3;

/// Largest error of each cause, at one instant or over a day, as fractions of the mean irradiance.
struct ErrorParts {
  double quadrature = 0.0;  ///< error of the moments, under the bake's tolerance
  double truncation = 0.0;  ///< error of the bands or modes left out
  double time = 0.0;        ///< error of the interpolation between keys
  double encoding = 0.0;    ///< error of the stored numbers and the modes' map
};

/// The irradiance error of docs/conventions.md: the largest |E - E_ref| of a channel over all normals and instants,
/// divided by the mean of E_ref over the normals.
struct Certificate {
  enum class Method { fast = 1, full = 2 };
  Method method = Method::fast;
  double max_error = 0.0;
  double time_h = 0.0;  ///< time of max_error; normal and channel likewise
  Number3 normal{0.0, 1.0, 0.0};
  int channel = 0;
  double mean_error = 0.0;  ///< mean over normals, channels and instants
  ErrorParts parts;
  std::size_t instants = 0;
  /// The error at every instant that was measured, in the order of time.
  struct At {
    double time_h;
    double error;
  };
  std::vector<At> day;
  /// Estimated error of the reference in sky/model/irradiance.h, in the same measure; max_error may be wrong by this
  /// much. The estimate is 1 to 4 times the error found. It is under 2e-4 for every named model, and hundredths for a
  /// lobe one degree wide.
  double reference_error = 0.0;

  /// Error of the cubemaps; see docs/conventions.md, "Error of the cubemaps". All 0 without cubemaps.
  struct Cubemaps {
    double max_error = 0.0;
    double time_h = 0.0;
    double resolution = 0.0, time = 0.0, encoding = 0.0;  ///< parts
  } cubemaps;
  double dome_error = 0.0;  ///< error of the analytic dome, in the same measure; gradient rounding causes it

  /// Largest error of the blends with the other skies of its family, as max_error; 0 for a sky alone.
  struct Blends {
    double max_error = 0.0;
    double time_h = 0.0;
  } blends;
};

}  // namespace welkin::table
