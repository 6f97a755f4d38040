// SPDX-License-Identifier: Apache-2.0
// Cubemaps under an error budget: the size, the format and the times with the fewest bytes whose error, as
// cubemap_error.h measures it, stays under it.
#pragma once

#include <string>
#include <vector>

#include "sky/base/progress.h"
#include "sky/cubemap/cubemap_error.h"

namespace welkin::cubemap {

/// The limits of a plan.
struct CubemapLimits {
  int largest_size = 1024;        ///< a power of two, 8 to 1024
  std::size_t most_times = 1440;  ///< at least 1
  double most_bytes = 1.5e9;      ///< of all texels
};

struct CubemapPlan {
  int size = 8;  ///< 8 to 1024, a power of two
  format::CubemapFormat format = format::CubemapFormat::rgba16f;
  std::vector<double> time_h;  ///< ascending, whole milliseconds
  double bytes = 0.0;          ///< of all texels
  double predicted = 0.0;      ///< the error that the model of squares expects
  CubemapError measured;       ///< by Effort::fast, of the texels that a bake will make
  bool met = false;            ///< whether measured.error is under the budget
  std::string reason;          ///< when it is not: why, in one sentence
  double wanted_bytes = 0.0;   ///< when most_bytes are too few: about as many as the budget takes; 0: more than 1.5e9
};

/// Plans for `max_error` > 0, relative (0.01: one percent). The fewest bytes; of as many, the fewest texels, which a
/// bake renders soonest. Expects error^2 = resolution^2 + time^2 + encoding^2 at every instant, from cheap measures of
/// the sky; then measures the bake's cubemaps, and tightens where it is past the budget. A budget that the limits do
/// not allow gives the best that was found. The same plan for any number of threads. `progress` as in bakeDayTable.
CubemapPlan planCubemaps(const model::Sky& sky, double max_error, const CubemapLimits& limits = {},
                         const base::Progress& progress = {});

}  // namespace welkin::cubemap
