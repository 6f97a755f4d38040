// SPDX-License-Identifier: Apache-2.0
// The legend of a chart: names of series, broken into lines, beside the frame.
#pragma once

#include <string>
#include <vector>

#include "study/chart.h"
#include "study/chart_pen.h"

namespace welkin::study {

class Legend {
 public:
  /// Breaks the names into lines and makes the words smaller when they would not fit `height` pixels;
  /// at the smallest, lines are longer.
  Legend(Pen& pen, const std::vector<Series>& series, double height);

  double width() const { return width_; }
  void draw(Pen& pen, const Corner& top_left) const;

 private:
  struct Entry {
    std::size_t series;
    SeriesStyle style;
    std::vector<std::string> lines;
  };

  double arrange(Pen& pen, const std::vector<Series>& series, double most_width);  // returns the height

  std::vector<Entry> entries_;
  double size_ = 0.0;
  double width_ = 0.0;
};

/// `words` in lines of at most `width` pixels, broken at spaces; a word that is longer stays whole.
std::vector<std::string> brokenIntoLines(Pen& pen, const std::string& words, double size, double width);

}  // namespace welkin::study
