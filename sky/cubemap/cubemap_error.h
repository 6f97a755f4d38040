// SPDX-License-Identifier: Apache-2.0
// How far the cubemaps of a bake are from the sky: docs/conventions.md, "Error of the cubemaps". At an instant it is
// the root mean square, over the upper hemisphere, of what the runtime shows less the model's dome, over the mean of
// the model's dome: the worst channel, of the larger of its own mean and the luminance's.
#pragma once

#include <span>
#include <vector>

#include "sky/cubemap/cubemap_filter.h"
#include "sky/cubemap/dome_directions.h"

namespace welkin::cubemap {

using det::Number3;

enum class Effort {
  draft,  ///< a third of the directions of fast: for planning
  fast,   ///< within 5 % of full (tests/sky/cubemap_error_test.cpp)
  full    ///< four times the directions and more instants
};

/// Cubemaps as a file holds them: all of one size and format.
struct CubemapSet {
  int size = 0;  ///< >= 2
  format::CubemapFormat format = format::CubemapFormat::rgba16f;
  std::vector<double> time_h;                         ///< strictly ascending, in [0, 24), at least one
  std::vector<std::span<const std::uint8_t>> texels;  ///< one for every time, or none: those that a bake would make
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
  double mean = 0.0;  ///< of the error over the day
  /// What each part alone would cause, the largest over instants; their squares add up to about that of the whole.
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

/// The sky's own measure: what errors are divided by.
class DomeScale {
 public:
  explicit DomeScale(const model::Sky& sky);
  /// Of a mean radiance over the hemisphere: what a channel's error is divided by. 0 only for a sky that is black all
  /// day.
  double of(const Number3& mean, int channel) const;

 private:
  double floor_;  ///< 1e-4 of the day's brightest mean luminance
};

/// Hours at which the sky bends: keys of intensity and tint, and of a path by hand; columns of the
/// gradients; around sunrise and sunset.
/// Ascending, in [0, 24).
std::vector<double> bendsOf(const model::Sky& sky);

/// Whether a direction above the horizon is at least a texel away from it, on its face: only those are compared.
bool isClearOfHorizon(int size, const Number3& direction);

/// Measures at the cubemaps' times, between them, at the curves' bends, and closer
/// around the worst of these. Parallel; the same numbers
/// for any number of threads. `progress` as in bakeDayTable.
CubemapError measureCubemaps(const model::Sky& sky, const CubemapSet& cubemaps, Effort effort,
                             const table::Progress& progress = {});

/// Resolution and encoding of each of the cubemaps at its own time, from a thousand directions: what a plan weighs.
std::vector<CubemapError::Parts> partsAt(const model::Sky& sky, const CubemapSet& cubemaps,
                                         const table::Progress& progress = {});

}  // namespace welkin::cubemap
