// SPDX-License-Identifier: Apache-2.0
// A quantity over the day, read from the keys of an opened file.
#pragma once

#include <span>

#include "format/domain_check.h"
#include "format/key_segment.h"
#include "shared.h"

namespace welkin::core {

/// One number or one colour per key. Borrows the file's keys.
class Curve {
 public:
  Curve() = default;
  explicit Curve(const format::Curve& curve)
      : time_h_(format::spanOf(curve.time_h())), value_(format::spanOf(curve.value())) {}

  /// Value at an hour in [0, 24) of a curve of numbers.
  double at(double time_h) const {
    if (value_.size() == 1) return value_[0];
    double value = 0.0;
    format::interpolate(time_h_, value_, time_h, {&value, 1});
    return value;
  }

  /// Value at an hour in [0, 24) of a curve of colours.
  f64::Number3 colourAt(double time_h) const {
    if (value_.size() == 3) return {value_[0], value_[1], value_[2]};
    double v[3];
    format::interpolate(time_h_, value_, time_h, v);
    return {v[0], v[1], v[2]};
  }

 private:
  std::span<const double> time_h_, value_;
};

}  // namespace welkin::core
