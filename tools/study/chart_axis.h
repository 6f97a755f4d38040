// SPDX-License-Identifier: Apache-2.0
// The range and the tick labels along an axis of a chart, as commands of gnuplot.
#pragma once

#include <string>
#include <vector>

#include "study/chart.h"

namespace welkin::study {

class AxisScale {
 public:
  /// An axis that shows every value and axis.range. Throws Error(internal) naming the axis for no values, for one that
  /// is not finite, or for one below 0 for decades.
  AxisScale(const Axis& axis, const std::vector<double>& values);

  /// The coordinate at which a value is drawn: the value itself, but zeros of decades lie on the lower edge.
  double coordinate(double value) const { return decades_ && value == 0.0 ? zero_ : value; }

  /// Share of the axis below a value; in [0, 1] for a value that the axis shows.
  double position(double value) const;

  double low() const { return low_; }
  double high() const { return high_; }

  /// Characters of the longest label.
  std::size_t labelLength() const { return label_length_; }

  /// Sets scale, range and ticks of axis `name`, "x" or "y".
  std::string commands(const std::string& name) const;

 private:
  void addDecades(const Axis& axis);
  void addTick(double value, const std::string& label);

  bool decades_;
  double low_ = 0.0;  // the ends of everything that is shown
  double high_ = 0.0;
  double zero_ = 0.0;
  std::string ticks_;  // in gnuplot's words: 'label' value [0 major, 1 minor], ...
  std::size_t label_length_ = 6;
};

/// `words` in single quotes, in which gnuplot substitutes nothing; characters that end a line become spaces.
std::string quoted(const std::string& words);

}  // namespace welkin::study
