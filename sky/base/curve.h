// SPDX-License-Identifier: Apache-2.0
// Quantities over the time of day: piecewise linear between keys, periodic.
#pragma once

#include <optional>
#include <vector>

#include "format/key_segment.h"
#include "sh/deterministic.h"

namespace welkin::base {

using det::Number3;

/// One number (components = 1) or one colour (components = 3) for every key.
struct Curve {
  int components = 1;
  std::vector<double> time_h;  ///< strictly ascending, in [0, 24)
  std::vector<double> value;   ///< key-major

  static Curve constant(double value) { return {1, {0.0}, {value}}; }
  static Curve constant(const Number3& value) { return {3, {0.0}, {value.x, value.y, value.z}}; }

  /// Value at a finite time. The curve has one component.
  double at(double time) const {
    double v = 0.0;
    format::interpolate(time_h, value, time, {&v, 1});
    return v;
  }
  /// Colour at a finite time. The curve has three components.
  Number3 colourAt(double time) const {
    double v[3];
    format::interpolate(time_h, value, time, v);
    return {v[0], v[1], v[2]};
  }
};

}  // namespace welkin::base
