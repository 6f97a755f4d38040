// SPDX-License-Identifier: Apache-2.0
// Directions over the upper hemisphere that integrate a cubemap's error: even ones, ones that crowd about the
// sun, where a filter flattens the cusp, and ones that crowd above the horizon, where the sky changes fastest. A
// deterministic mixture, weighted by the balance heuristic (Veach, "Robust Monte Carlo Methods for Light Transport
// Simulation", 1997, ch. 9).
#pragma once

#include <vector>

#include "sh/deterministic.h"

namespace welkin::cubemap {

using det::Number3;

struct WeightedDirection {
  Number3 direction;   ///< unit, above the horizon
  double solid_angle;  ///< that it stands for; the sum over a set is close to 2 pi
};

/// Numbers of directions of each kind; `even` >= 1.
struct DirectionCounts {
  int even;
  int about_sun;
  int low;
};

/// Immutable; the same bits on every machine.
class DomeDirections {
 public:
  /// Even ones along a Fibonacci spiral; of the others, the distance to the sun and the height over the horizon are
  /// spread over their logarithms.
  explicit DomeDirections(const DirectionCounts& counts);

  /// The set for a sun in unit direction `sun`: first those that stay, then those of its crowd that are above the
  /// horizon.
  std::vector<WeightedDirection> around(const Number3& sun) const;

  /// Those that are there whatever the sun: the even and the low ones.
  const std::vector<Number3>& staying() const { return staying_; }

 private:
  struct Offset {
    double chord, cosine, sine;  ///< distance of two points of the unit sphere, and the turn about the sun
  };
  std::vector<Number3> staying_;
  std::vector<Offset> about_sun_;
  // Directions a solid angle: of the even ones; of those about the sun, times the chord's square; of the low ones,
  // times the height.
  double even_density_, sun_density_, low_density_;
};

}  // namespace welkin::cubemap
