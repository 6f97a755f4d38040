// SPDX-License-Identifier: Apache-2.0
// The divisor of errors of the dome and of cubemaps: docs/conventions.md, "Error of the cubemaps".
#pragma once

#include "sky/model/sky.h"

namespace welkin::cubemap {

using det::Number3;

class DomeScale {
 public:
  explicit DomeScale(const model::Sky& sky);
  /// The divisor of a channel's error where the mean radiance over the hemisphere is `mean`: the larger of the channel
  /// and the luminance. 0 only for a sky that is black all day.
  double of(const Number3& mean, int channel) const;

 private:
  double floor_;  ///< 1e-4 of the day's brightest mean luminance
};

}  // namespace welkin::cubemap
