// SPDX-License-Identifier: Apache-2.0
// The errors that cubemaps make at their own times, where nothing is blended: of the size's resolution and of the
// format's encoding, over a day.
#pragma once

#include <vector>

#include "sky/cubemap/cubemap_error.h"

namespace welkin::cubemap {

inline constexpr int kSmallestCubemap = 8;  ///< that a plan looks at
inline constexpr format::CubemapFormat kPlannedFormats[] = {
    format::CubemapFormat::rgba16f, format::CubemapFormat::rgb9e5, format::CubemapFormat::b10g11r11};

class CubemapStillErrors {
 public:
  /// Measures sizes from kSmallestCubemap on, each twice the last, up to `largest_size`, at some hours of the day and
  /// where the sky bends. `progress` as in bakeDayTable.
  CubemapStillErrors(const model::Sky& sky, int largest_size, const base::Progress& progress);

  /// The root of the sum of the squares of both, each the larger of those measured before and after `time_h`.
  double at(int size, format::CubemapFormat format, double time_h) const;

 private:
  std::vector<double> time_h_;
  std::vector<std::vector<double>> resolution_;  ///< by size, then hour
  std::vector<std::vector<double>> encoding_;    ///< by format, then hour
};

}  // namespace welkin::cubemap
