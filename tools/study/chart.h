// SPDX-License-Identifier: Apache-2.0
// A chart: numbers and words, and its picture as SVG and PNG, drawn by gnuplot. The same input gives the same bytes on
// a machine with the same gnuplot and fonts. Colours are told apart by colour-blind people (Okabe and Ito, "Color
// Universal Design", 2008), and every series has a marker of its own beside.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "study/quantity.h"

namespace welkin::study {

enum class Scale {
  linear,
  log,  ///< decades; zeros lie apart on the lower edge, negative numbers are refused
};

struct Range {
  double low;
  double high;
};

struct Axis {
  std::string title;
  Quantity quantity = Quantity::number;  ///< for an axis of decades; a linear one shows plain numbers
  Scale scale = Scale::linear;
  std::optional<Range> range = std::nullopt;  ///< shown at least; the data can widen it
};

struct Point {
  double x;
  double y;
  std::string label = {};  ///< written beside it
};

enum class SeriesStyle {
  markers,  ///< points alone
  line,     ///< points, joined in their order
  front,    ///< a Pareto front: points joined by steps, right and then down, since nothing between them can be had
};

struct Series {
  std::string name;
  SeriesStyle style = SeriesStyle::markers;
  std::vector<Point> points;
};

/// A horizontal line across the chart: a budget.
struct ReferenceLine {
  double y;
  std::string label;
};

struct Chart {
  std::string title;
  Axis x;
  Axis y;
  std::vector<Series> series;
  std::vector<ReferenceLine> lines = {};
};

constexpr int kChartWidth = 960;
constexpr int kChartHeight = 600;
constexpr std::size_t kMostSeries = 20;

/// A chart as files.
struct ChartPictures {
  std::string svg;
  std::string png;
};

/// None when gnuplot is not installed. Throws Error(internal) for a chart without points, with more than kMostSeries
/// series, with a number that is not finite, or with one below 0 on an axis of decades; Error(file) when gnuplot fails.
std::optional<ChartPictures> drawChart(const Chart& chart);

}  // namespace welkin::study
