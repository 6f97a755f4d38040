// SPDX-License-Identifier: Apache-2.0
#include "study/chart_legend.h"

#include <algorithm>
#include <array>
#include <utility>

namespace welkin::study {
namespace {

constexpr double kTextSize = 12.0;
constexpr double kSmallestText = 8.0;
constexpr std::array<double, 3> kMostWidths = {170.0, 260.0, 400.0};  // of the words, unless a single word is longer
constexpr double kSymbolWidth = 34.0;
constexpr double kLineHeight = 1.25;  // of the size of the words
constexpr double kEntryGap = 0.4;

}  // namespace

std::vector<std::string> brokenIntoLines(Pen& pen, const std::string& words, double size, double width) {
  std::vector<std::string> lines;
  std::string line;
  std::size_t from = 0;
  while (from < words.size()) {
    const std::size_t end = std::min(words.find(' ', from), words.size());
    const std::string word = words.substr(from, end - from);
    const std::string longer = line.empty() ? word : line + ' ' + word;
    if (!line.empty() && pen.textWidth(longer, size) > width) {
      lines.push_back(line);
      line = word;
    } else {
      line = longer;
    }
    from = end + 1;
  }
  lines.push_back(line);
  return lines;
}

Legend::Legend(Pen& pen, const std::vector<Series>& series, double height) {
  for (const double most_width : kMostWidths) {
    for (size_ = kTextSize; size_ >= kSmallestText; size_ -= 0.5) {
      if (arrange(pen, series, most_width) <= height) return;
    }
  }
  size_ = kSmallestText;
}

double Legend::arrange(Pen& pen, const std::vector<Series>& series, double most_width) {
  entries_.clear();
  width_ = 0.0;
  double height = 0.0;
  for (std::size_t i = 0; i < series.size(); ++i) {
    if (series[i].name.empty()) continue;
    Entry entry = {i, series[i].style, brokenIntoLines(pen, series[i].name, size_, most_width)};
    for (const std::string& line : entry.lines) width_ = std::max(width_, kSymbolWidth + pen.textWidth(line, size_));
    height += (static_cast<double>(entry.lines.size()) * kLineHeight + kEntryGap) * size_;
    entries_.push_back(std::move(entry));
  }
  return height;
}

void Legend::draw(Pen& pen, const Corner& top_left) const {
  double y = top_left.y + size_ * kLineHeight / 2.0;
  for (const Entry& entry : entries_) {
    const Corner middle = {top_left.x + 12.0, y};
    if (entry.style == SeriesStyle::front) {
      pen.line({{middle.x - 12.0, y - 4.0}, {middle.x, y - 4.0}, {middle.x, y + 4.0}, {middle.x + 12.0, y + 4.0}}, kInk,
               1.8);
    } else {
      if (entry.style == SeriesStyle::line) {
        pen.line({{middle.x - 12.0, y}, {middle.x + 12.0, y}}, colourOf(entry.series), 1.8);
      }
      pen.marker(entry.series, middle, 5.0);
    }
    for (const std::string& line : entry.lines) {
      pen.text(line, {top_left.x + kSymbolWidth, y}, Anchor::left, size_);
      y += size_ * kLineHeight;
    }
    y += size_ * kEntryGap;
  }
}

}  // namespace welkin::study
