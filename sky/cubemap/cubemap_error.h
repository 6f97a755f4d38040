// SPDX-License-Identifier: Apache-2.0
// The error of a bake's cubemaps: docs/conventions.md, "Error of the cubemaps". The difference is the runtime's picture
// less the model's dome. At an instant the error is its root mean square over the upper hemisphere, divided by the mean
// of the model's dome: the larger of the channel's own mean and the luminance's. The worst channel counts.
#pragma once

#include <vector>

#include "sky/base/progress.h"
#include "sky/cubemap/cubemap_look.h"

namespace welkin::cubemap {

using det::Number3;

enum class Effort {
  draft,  ///< a third of the directions of fast: for planning
  fast,   ///< within 5 % of full (tests/sky/cubemap_error_test.cpp)
  full    ///< four times the directions and more instants
};

/// The error at an instant, or the largest over instants.
struct CubemapError {
  double error = 0.0;   ///< root mean square over directions, of the worst channel
  double time_h = 0.0;  ///< where
  int channel = 0;      ///< 0 to 2
  /// The largest difference in one direction, over the same mean.
  struct Largest {
    double error = 0.0;
    double time_h = 0.0;
    Number3 direction{0.0, 1.0, 0.0};
    int channel = 0;
  } largest;
  double mean = 0.0;  ///< mean of the error over the day
  /// The error of each part alone, the largest over instants; their squares add up to about the whole's square.
  struct Parts {
    double resolution = 0.0;  ///< filtering between texels: at the cubemaps' own times, unencoded
    double time = 0.0;        ///< blending two instants of the model itself
    double encoding = 0.0;    ///< rounding to the format, at the cubemaps' own times
  } parts;
  /// The error at every instant that was measured, in the order of time.
  struct At {
    double time_h;
    double error;
  };
  std::vector<At> day;
};

/// Measures at the cubemaps' times, between them, at the curves' bends, and closer around the worst of these. Parallel;
/// the same numbers for any number of threads. `progress` as in bakeDayTable.
CubemapError measureCubemaps(const model::Sky& sky, const CubemapSet& cubemaps, Effort effort,
                             const base::Progress& progress = {});

/// Resolution and encoding of each of the cubemaps at its own time, from a thousand directions, for a plan.
std::vector<CubemapError::Parts> partsAt(const model::Sky& sky, const CubemapSet& cubemaps,
                                         const base::Progress& progress = {});

}  // namespace welkin::cubemap
