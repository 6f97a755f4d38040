// SPDX-License-Identifier: Apache-2.0
#include "study/chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sky/base/error.h"
#include "study/chart_axis.h"
#include "study/chart_legend.h"
#include "study/chart_pen.h"

namespace welkin::study {
namespace {

constexpr double kTitleSize = 17.0;
constexpr double kAxisTitleSize = 13.0;
constexpr double kTickSize = 12.0;
constexpr double kLabelSize = 11.0;
constexpr double kEdge = 16.0;  // of the picture, left free
constexpr double kTop = 54.0;
constexpr double kBottom = kChartHeight - 62.0;
constexpr double kMarkerRadius = 5.0;
constexpr double kRingRadius = 8.0;
constexpr double kLeadFrom = 14.0;  // distance from which a line joins a label to its point

std::vector<double> valuesOf(const Chart& chart, double Point::*coordinate) {
  std::vector<double> values;
  for (const Series& series : chart.series) {
    for (const Point& point : series.points) values.push_back(point.*coordinate);
  }
  return values;
}

std::vector<double> heightsOf(const Chart& chart) {
  std::vector<double> values = valuesOf(chart, &Point::y);
  if (!values.empty()) {
    for (const Level& level : chart.levels) values.push_back(level.y);
  }
  return values;
}

class Painter {
 public:
  Painter(const Chart& chart, Pen& pen)
      : chart_(chart),
        pen_(pen),
        x_(chart.x, valuesOf(chart, &Point::x)),
        y_(chart.y, heightsOf(chart)),
        legend_(pen_, chart.series, kBottom - kTop) {
    double ticks = 0.0;
    for (const Tick& tick : y_.ticks()) ticks = std::max(ticks, pen_.textWidth(tick.label, kTickSize));
    for (const Level& level : chart.levels)
      level_width_ = std::max(level_width_, pen_.textWidth(level.label, kLabelSize));
    const double beside =
        legend_.width() + (legend_.width() > 0.0 ? kEdge : 0.0) + (level_width_ > 0.0 ? level_width_ + 14.0 : 0.0);
    frame_ = {kEdge + kAxisTitleSize + 10.0 + ticks + 10.0, kTop, kChartWidth - kEdge - std::max(beside, 10.0),
              kBottom};
  }

  void paint() {
    drawGrid();
    drawTitles();
    drawLevels();
    pen_.beginClip(
        {frame_.left - kRingRadius, frame_.top - kRingRadius, frame_.right + kRingRadius, frame_.bottom + kRingRadius});
    for (std::size_t i = 0; i < chart_.series.size(); ++i) drawLine(i);
    for (std::size_t i = 0; i < chart_.series.size(); ++i) drawMarkers(i);
    pen_.endClip();
    drawLabels();
    legend_.draw(pen_, {kChartWidth - kEdge - legend_.width(), frame_.top});
  }

 private:
  Corner at(const Point& point) const { return {left(x_.position(point.x)), top(y_.position(point.y))}; }
  double left(double position) const { return frame_.left + position * (frame_.right - frame_.left); }
  double top(double position) const { return frame_.bottom - position * (frame_.bottom - frame_.top); }

  // Labels of minor ticks give way to those of major ones, and later ones to earlier ones.
  template <typename Extent, typename Draw>
  static void drawTickLabels(const std::vector<Tick>& ticks, const Extent& extent, const Draw& draw) {
    std::vector<Range> taken;
    for (const bool minor : {false, true}) {
      for (const Tick& tick : ticks) {
        if (tick.minor != minor || tick.label.empty()) continue;
        const Range range = extent(tick);
        const auto overlaps = [&](const Range& other) { return range.low < other.high && other.low < range.high; };
        if (std::ranges::any_of(taken, overlaps)) continue;
        taken.push_back(range);
        draw(tick);
      }
    }
  }

  void drawGrid() {
    for (const Tick& tick : x_.ticks()) {
      const double x = left(tick.position);
      pen_.line({{x, frame_.top}, {x, frame_.bottom}}, kGrid, tick.minor ? 0.5 : 1.0);
      pen_.line({{x, frame_.bottom}, {x, frame_.bottom + (tick.minor ? 3.0 : 5.0)}}, kInk, 1.0);
    }
    for (const Tick& tick : y_.ticks()) {
      const double y = top(tick.position);
      pen_.line({{frame_.left, y}, {frame_.right, y}}, kGrid, tick.minor ? 0.5 : 1.0);
      pen_.line({{frame_.left - (tick.minor ? 3.0 : 5.0), y}, {frame_.left, y}}, kInk, 1.0);
    }
    const auto width = [&](const Tick& tick) {
      const double half = pen_.textWidth(tick.label, kTickSize) / 2.0 + 5.0;
      return Range{left(tick.position) - half, left(tick.position) + half};
    };
    drawTickLabels(x_.ticks(), width, [&](const Tick& tick) {
      pen_.text(tick.label, {left(tick.position), frame_.bottom + 16.0}, Anchor::middle, kTickSize);
    });
    const auto height = [&](const Tick& tick) {
      return Range{top(tick.position) - kTickSize * 0.6, top(tick.position) + kTickSize * 0.6};
    };
    drawTickLabels(y_.ticks(), height, [&](const Tick& tick) {
      pen_.text(tick.label, {frame_.left - 9.0, top(tick.position)}, Anchor::right, kTickSize);
    });
    pen_.line({{frame_.left, frame_.top},
               {frame_.right, frame_.top},
               {frame_.right, frame_.bottom},
               {frame_.left, frame_.bottom},
               {frame_.left, frame_.top}},
              kGrey, 1.0);
  }

  void drawFitting(const std::string& words, const Corner& middle, double size, double room, bool bold, bool upwards) {
    const double width = pen_.textWidth(words, size, bold);
    pen_.text(words, middle, Anchor::middle, width > room ? size * room / width : size, kInk, bold, upwards);
  }

  void drawTitles() {
    const double middle = (frame_.left + frame_.right) / 2.0;
    drawFitting(chart_.title, {kChartWidth / 2.0, 27.0}, kTitleSize, kChartWidth - 2.0 * kEdge, true, false);
    drawFitting(chart_.x.title, {middle, kChartHeight - 20.0}, kAxisTitleSize, frame_.right - frame_.left, false,
                false);
    drawFitting(chart_.y.title, {kEdge + kAxisTitleSize / 2.0, (frame_.top + frame_.bottom) / 2.0}, kAxisTitleSize,
                frame_.bottom - frame_.top, false, true);
  }

  // The words stand beside the frame, moved apart where lines are close.
  void drawLevels() {
    std::vector<Level> levels = chart_.levels;
    std::ranges::stable_sort(levels, std::ranges::greater(), &Level::y);
    double below = frame_.top;
    std::vector<double> heights;
    for (const Level& level : levels) {
      const double y = top(y_.position(level.y));
      heights.push_back(std::max(y, below));
      below = heights.back() + kLabelSize * 1.3;
    }
    double above = frame_.bottom;
    for (std::size_t i = heights.size(); i-- > 0;) {
      heights[i] = std::min(heights[i], above);
      above = heights[i] - kLabelSize * 1.3;
    }
    for (std::size_t i = 0; i < levels.size(); ++i) {
      const double y = top(y_.position(levels[i].y));
      pen_.line({{frame_.left, y}, {frame_.right, y}}, kGrey, 1.2, true);
      pen_.line({{frame_.right, y}, {frame_.right + 7.0, heights[i]}}, kGrey, 1.0);
      pen_.text(levels[i].label, {frame_.right + 10.0, heights[i]}, Anchor::left, kLabelSize, kGrey);
    }
  }

  std::vector<Corner> cornersOf(const Series& series) const {
    std::vector<Corner> corners;
    if (series.points.empty() || series.style == SeriesStyle::markers) return corners;
    if (series.style == SeriesStyle::front) corners.push_back({at(series.points.front()).x, frame_.top});
    for (const Point& point : series.points) {
      const Corner corner = at(point);
      if (series.style == SeriesStyle::front) corners.push_back({corner.x, corners.back().y});
      corners.push_back(corner);
    }
    if (series.style == SeriesStyle::front) corners.push_back({frame_.right, corners.back().y});
    return corners;
  }

  void drawLine(std::size_t i) {
    const Series& series = chart_.series[i];
    pen_.line(cornersOf(series), series.style == SeriesStyle::front ? kInk : colourOf(i), 1.8);
  }

  void drawMarkers(std::size_t i) {
    for (const Point& point : chart_.series[i].points) {
      if (chart_.series[i].style == SeriesStyle::front) {
        pen_.ring(at(point), kRingRadius, kInk);
      } else {
        pen_.marker(i, at(point), kMarkerRadius);
      }
    }
  }

  std::vector<Obstacle> obstacles() const {
    std::vector<Obstacle> found;
    const auto add = [&](const Corner& middle, double half, double weight) {
      found.push_back({{middle.x - half, middle.y - half, middle.x + half, middle.y + half}, weight});
    };
    for (const Series& series : chart_.series) {
      const double radius = series.style == SeriesStyle::front ? kRingRadius : kMarkerRadius;
      for (const Point& point : series.points) add(at(point), radius, 1.0);
      const std::vector<Corner> corners = cornersOf(series);
      for (std::size_t i = 1; i < corners.size(); ++i) {
        const double x = corners[i].x - corners[i - 1].x;
        const double y = corners[i].y - corners[i - 1].y;
        const double steps = std::ceil(std::hypot(x, y) / 4.0);
        for (double step = 0.5; step < steps; step += 1.0) {
          add({corners[i - 1].x + x * step / steps, corners[i - 1].y + y * step / steps}, 2.0, 0.5);
        }
      }
    }
    for (const Level& level : chart_.levels) {
      const double y = top(y_.position(level.y));
      found.push_back({{frame_.left, y - 1.0, frame_.right, y + 1.0}, 0.2});
    }
    return found;
  }

  void drawLabels() {
    std::vector<LabelRequest> requests;
    std::vector<const Point*> points;
    for (const Series& series : chart_.series) {
      for (const Point& point : series.points) {
        if (point.label.empty()) continue;
        requests.push_back({at(point).x, at(point).y, pen_.textWidth(point.label, kLabelSize), kLabelSize + 2.0});
        points.push_back(&point);
      }
    }
    const Box inside = {frame_.left + 2.0, frame_.top + 2.0, frame_.right - 2.0, frame_.bottom - 2.0};
    const std::vector<std::optional<PlacedLabel>> labels = placeLabels(requests, obstacles(), inside);
    for (std::size_t i = 0; i < labels.size(); ++i) {
      if (!labels[i]) continue;
      const double away = std::hypot(labels[i]->lead_x - requests[i].x, labels[i]->lead_y - requests[i].y);
      if (away > kLeadFrom)
        pen_.line({{requests[i].x, requests[i].y}, {labels[i]->lead_x, labels[i]->lead_y}}, kGrey, 0.8);
    }
    for (std::size_t i = 0; i < labels.size(); ++i) {
      if (labels[i]) pen_.label(points[i]->label, labels[i]->box, kLabelSize);
    }
  }

  const Chart& chart_;
  Pen& pen_;
  AxisScale x_;
  AxisScale y_;
  Legend legend_;
  double level_width_ = 0.0;
  Box frame_ = {};
};

}  // namespace

ChartPictures drawChart(const Chart& chart) {
  if (chart.series.size() > kMostSeries) {
    throw base::Error(base::ExitStatus::internal, fmt::format("chart '{}': {} series; at most {} can be told apart",
                                                              chart.title, chart.series.size(), kMostSeries));
  }
  // Not a recording that is played back: cairo 1.16 writes its matrices with 0 or -0, as it happens.
  Pen extent(Pen::Target::extent, kChartWidth, kChartHeight);
  Pen svg(Pen::Target::svg, kChartWidth, kChartHeight);
  Pen png(Pen::Target::png, kChartWidth, kChartHeight);
  for (Pen* const pen : {&extent, &svg, &png}) Painter(chart, *pen).paint();
  const Box ink = extent.ink();
  return {svg.finish(), png.finish(), {ink.left, ink.right}, {ink.top, ink.bottom}};
}

}  // namespace welkin::study
