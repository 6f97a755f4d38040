// SPDX-License-Identifier: Apache-2.0
// What a bake says about its own error.
#pragma once

#include "sky/base/curve.h"

namespace welkin::table {

using det::Number3;

/// Largest errors of each cause at one instant or over a day, fractions of the mean irradiance.
struct ErrorParts {
  double quadrature = 0.0;  ///< of the moments, under the bake's tolerance
  double truncation = 0.0;  ///< of the bands or modes
  double time = 0.0;        ///< of the interpolation between keys
  double encoding = 0.0;    ///< of the stored numbers and the map of the modes
};

/// The irradiance error of docs/conventions.md: the largest |E - E_ref| of a channel over all normals and instants,
/// divided by the mean of E_ref over the normals.
struct Certificate {
  enum class Method { fast = 1, full = 2 };
  Method method = Method::fast;
  double max_error = 0.0;
  double time_h = 0.0;  ///< of max_error, as normal and channel
  Number3 normal{0.0, 1.0, 0.0};
  int channel = 0;
  double mean_error = 0.0;  ///< over normals, channels and instants
  ErrorParts parts;
  std::size_t instants = 0;
  /// What the reference of sky/irradiance.h may itself be off by, as errors are divided: max_error may be wrong by so
  /// much. An estimate, 1 to 4 times what is found; under 2e-4 for every named model, hundredths for a lobe that is a
  /// degree wide.
  double reference_error = 0.0;

  /// Of the cubemaps: docs/conventions.md, "Error of the cubemaps". All 0 without any.
  struct Cubemaps {
    double max_error = 0.0;
    double time_h = 0.0;
    double resolution = 0.0, time = 0.0, encoding = 0.0;  ///< parts
  } cubemaps;
  double dome_error = 0.0;  ///< of the analytic dome, in the same measure: what rounds the gradients
};

}  // namespace welkin::table
