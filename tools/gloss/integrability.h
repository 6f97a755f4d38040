// SPDX-License-Identifier: Apache-2.0
// Tells whether the green channel of a normal map points up or down: only one of them is the slope of a surface.
#pragma once

#include "gloss/normal_map.h"

namespace welkin::gloss {

/// How the map's edges meet.
enum class Wrap { repeat, clamp };

/// The slopes p = -x/z and q = -y/z of a height h are its derivatives to the right and up, so dp/dup = dq/dright. With
/// green flipped the two have opposite signs.
struct GreenDirection {
  double correlation = 0.0;  ///< of the two, in [-1, 1]: 1 for a height with green up, -1 with green down, 0 unknown
  double certainty = 0.5;    ///< that its sign is not chance, in [0.5, 1]

  bool points_down() const { return correlation < -0.1 && certainty > 0.999; }
  bool points_up() const { return correlation > 0.1 && certainty > 0.999; }
};

/// Measures it by differences over two texels. The certainty is that of the mean over up to 256 blocks of the map, as
/// independent samples of a normal distribution. A map that is bent along one axis alone tells nothing: 0 and 0.5.
GreenDirection greenDirectionOf(const NormalMap& map, Wrap wrap);

}  // namespace welkin::gloss
