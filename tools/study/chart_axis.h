// SPDX-License-Identifier: Apache-2.0
// Where numbers lie along an axis of a chart, and which of them are marked.
#pragma once

#include <string>
#include <vector>

#include "study/chart.h"

namespace welkin::study {

/// A mark on an axis. The finer divisions of decades are minor; not all of them have a label.
struct Tick {
  double position;  ///< in [0, 1] along the axis
  std::string label;
  bool minor = false;
};

class AxisScale {
 public:
  /// An axis that shows every value and axis.range, widened to round numbers. Throws Error(internal) naming the axis
  /// for no values, one that is not finite, or one below 0 for decades.
  AxisScale(const Axis& axis, const std::vector<double>& values);

  /// In [0, 1] for what the axis shows.
  double position(double value) const;

  const std::vector<Tick>& ticks() const { return ticks_; }

 private:
  void markLinear(const Axis& axis, double low, double high, bool whole);
  void markDecades(const Axis& axis, double low, double high, bool zero);

  Scale scale_;
  double low_ = 0.0;  // of the scale: values, or their decimal logarithms
  double high_ = 1.0;
  double start_ = 0.0;  // position of low_: above 0 when zeros lie below it
  std::vector<Tick> ticks_;
};

}  // namespace welkin::study
