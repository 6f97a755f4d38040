// SPDX-License-Identifier: Apache-2.0
// The day's SH table: the shape of the sky's radiance at every key.
#pragma once

#include <functional>

#include "sky/projection.h"

namespace welkin::sky {

struct DayTable {
  int bands = 2;
  std::vector<double> key_time_h;
  std::vector<float> shape_sh;          ///< key, coefficient, RGB: at intensity 1, without ground
  std::vector<float> shape_irradiance;  ///< key, RGB: horizontal irradiance of the same
  std::size_t evaluations = 0;          ///< of the sky's radiance
};

/// Told after every finished piece of work, from any thread; returns false to stop, which throws Error(interrupted).
using Progress = std::function<bool()>;

/// Projects every key within `tolerance` (projection.h), in parallel (oneTBB's current arena); the same bytes for any
/// number of threads.
DayTable bakeDayTable(const Sky& sky, int bands, const std::vector<double>& key_time_h, const Progress& progress,
                      double tolerance = kTolerance);

}  // namespace welkin::sky
