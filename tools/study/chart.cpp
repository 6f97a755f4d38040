// SPDX-License-Identifier: Apache-2.0
#include "study/chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "sky/base/error.h"
#include "study/chart_axis.h"
#include "study/chart_label.h"
#include "study/gnuplot.h"

namespace welkin::study {
namespace {

constexpr double kTextSize = 12.0;  // pixels, of ticks and the legend
constexpr double kTitleSize = 17.0;
constexpr double kAxisTitleSize = 13.0;
constexpr double kLabelSize = 11.0;
constexpr double kCharacter = 0.55;      // mean width of a character, in the size of the text
constexpr double kWideCharacter = 0.68;  // the same where nothing may be cut
constexpr double kEdge = 16.0;           // free at the sides of the picture
constexpr double kTop = 54.0;
constexpr double kBottom = 62.0;
constexpr double kSymbol = 40.0;                  // of the legend
constexpr double kYTitle = 3.0 * kAxisTitleSize;  // the title of the y axis, ticks and the gaps between
constexpr double kLabelHeight = 1.25 * kLabelSize;
constexpr std::size_t kLegendCharacters = 29;
constexpr double kMarkerSize = 1.05;
constexpr double kHalo = 0.35;         // added to the size of the white marker below
constexpr double kMarkerRadius = 5.0;  // pixels
constexpr double kFrontRadius = 9.0;   // of the circles of a front

constexpr const char* kInk = "#212121";
constexpr const char* kGrey = "#6b6b6b";
constexpr const char* kGrid = "#e6e6e6";
// Okabe and Ito's colours but yellow, which is too light on white. Pairs of colour and marker repeat after 56 series.
constexpr std::array<unsigned, 7> kColours = {0x0072b2, 0xd55e00, 0x009e73, 0xcc79a7, 0xe69f00, 0x56b4e9, 0x595959};

struct Marker {
  int type;     // of gnuplot
  double size;  // of gnuplot's: some are small
};

// Filled circle, square, triangles, diamond and pentagon, a cross and a star.
constexpr std::array<Marker, 8> kMarkers = {
    {{7, 1.0}, {5, 1.0}, {9, 1.1}, {13, 1.3}, {11, 1.1}, {15, 1.2}, {2, 1.0}, {3, 1.0}}};
constexpr unsigned kWhite = 0xffffff;

std::string terminal(std::string_view name) {
  // pngcairo takes points of 96 dots an inch.
  return fmt::format("set terminal {} size {},{} noenhanced font 'DejaVu Sans,{}' fontscale {} background 'white'\n",
                     name, kChartWidth, kChartHeight, kTextSize, name == "svg" ? 1.0 : 0.75);
}

std::vector<double> valuesOf(const Chart& chart, double Point::*coordinate) {
  std::vector<double> values;
  for (const Series& series : chart.series)
    for (const Point& point : series.points) values.push_back(point.*coordinate);
  if (coordinate == &Point::y && !values.empty())
    for (const ReferenceLine& line : chart.lines) values.push_back(line.y);
  return values;
}

std::vector<std::string> brokenIntoLines(const std::string& words, std::size_t most) {
  std::vector<std::string> lines(1);
  for (std::size_t from = 0; from < words.size();) {
    const std::size_t end = std::min(words.find(' ', from), words.size());
    const std::string word = words.substr(from, end - from);
    if (!lines.back().empty() && lines.back().size() + 1 + word.size() > most) lines.emplace_back();
    lines.back() += (lines.back().empty() ? "" : " ") + word;
    from = end + 1;
  }
  return lines;
}

/// Quoted words and a font of at most `size` in which they fit `room` pixels.
std::string fitting(const std::string& words, double size, double room, const char* weight = "") {
  const double width = kWideCharacter * size * static_cast<double>(std::max<std::size_t>(words.size(), 1));
  return fmt::format("{} font 'DejaVu Sans{},{:.1f}'", quoted(words), weight,
                     width > room ? size * room / width : size);
}

/// gnuplot's word.
std::string_view nameOf(Alignment alignment) {
  return alignment == Alignment::left ? "left" : alignment == Alignment::right ? "right" : "center";
}

/// Writes the script of a chart, its terminal apart.
class Script {
 public:
  explicit Script(const Chart& chart)
      : chart_(chart), x_(chart.x, valuesOf(chart, &Point::x)), y_(chart.y, valuesOf(chart, &Point::y)) {}

  std::string text() {
    addFrame();
    for (const ReferenceLine& line : chart_.lines) addLine(line);
    addLabels();
    for (std::size_t i = 0; i < chart_.series.size(); ++i) addData(i);
    std::string plots;
    for (std::size_t i = 0; i < chart_.series.size(); ++i) plots += lineOf(i);
    for (std::size_t i = 0; i < chart_.series.size(); ++i) plots += markersOf(i);
    for (std::size_t i = 0; i < chart_.series.size(); ++i) plots += legendOf(i);
    plots.resize(plots.size() - 2);  // the last comma
    return text_ + "plot " + plots + "\n";
  }

 private:
  template <typename... Values>
  void add(fmt::format_string<Values...> format, const Values&... values) {
    text_ += fmt::vformat(format, fmt::make_format_args(values...)) + "\n";
  }

  void addFrame() {
    std::size_t legend = 0;
    for (const Series& series : chart_.series)
      for (const std::string& line : brokenIntoLines(series.name, kLegendCharacters))
        legend = std::max(legend, line.size());
    std::size_t beside = 0;
    for (const ReferenceLine& line : chart_.lines) beside = std::max(beside, line.label.size());
    const double characters = kCharacter * kTextSize;
    const double left = kEdge + kYTitle + characters * static_cast<double>(y_.labelLength());
    const double key = kChartWidth - kEdge - kSymbol - characters * static_cast<double>(legend);
    const double right = key - 2.0 * kEdge - characters * static_cast<double>(beside);
    frame_ = {left, kBottom, right, kChartHeight - kTop};
    add("set encoding utf8");
    add("set lmargin at screen {:.5f}\nset rmargin at screen {:.5f}", left / kChartWidth, right / kChartWidth);
    add("set bmargin at screen {:.5f}\nset tmargin at screen {:.5f}", kBottom / kChartHeight,
        1.0 - kTop / kChartHeight);
    add("set border 15 lc rgb '{}' lw 1\nset tics nomirror out scale 0.7,0.4 textcolor rgb '{}'", kGrey, kInk);
    add("set grid xtics ytics mxtics mytics back lt 1 lc rgb '{0}' lw 1, lt 1 lc rgb '{0}' lw 0.5", kGrid);
    add("set style textbox opaque noborder margins 0.2,0.2 fillcolor rgb '#33ffffff'");
    add("set key at screen {:.5f},{:.5f} left top vertical maxrows 99 Left reverse samplen 2 spacing 1.25",
        key / kChartWidth, 1.0 - (kTop - 6.0) / kChartHeight);
    text_ += x_.commands("x") + y_.commands("y");
    add("set label {} at screen 0.5,{:.5f} center textcolor rgb '{}'",
        fitting(chart_.title, kTitleSize, kChartWidth - 2.0 * kEdge, " Bold"), 1.0 - 27.0 / kChartHeight, kInk);
    add("set label {} at screen {:.5f},{:.5f} center textcolor rgb '{}'",
        fitting(chart_.x.title, kAxisTitleSize, right - left), (left + right) / 2.0 / kChartWidth, 20.0 / kChartHeight,
        kInk);
    add("set label {} at screen {:.5f},{:.5f} center rotate by 90 textcolor rgb '{}'",
        fitting(chart_.y.title, kAxisTitleSize, kChartHeight - kTop - kBottom),
        (kEdge + kAxisTitleSize / 2.0) / kChartWidth, (kBottom + kChartHeight - kTop) / 2.0 / kChartHeight, kInk);
  }

  void addLine(const ReferenceLine& line) {
    const double y = y_.coordinate(line.y);
    add("set arrow from graph 0,first {0:.17g} to graph 1,first {0:.17g} nohead back dt (16,10) lw 1.2 lc rgb '{1}'", y,
        kGrey);
    add("set label {} at graph 1,first {:.17g} left offset character 0.8,0 font ',{}' textcolor rgb '{}'",
        quoted(line.label), y, kLabelSize, kGrey);
  }

  double across(double x) const { return frame_.left + x_.position(x) * (frame_.right - frame_.left); }
  double up(double y) const { return frame_.bottom + y_.position(y) * (frame_.top - frame_.bottom); }

  /// Everything that labels stay off.
  LabelRoom roomForLabels() const {
    LabelRoom room(frame_);
    for (const ReferenceLine& line : chart_.lines) room.addLine({frame_.left, up(line.y), frame_.right, up(line.y)});
    for (const Series& series : chart_.series) {
      const bool front = series.style == SeriesStyle::front;
      for (const Point& point : series.points)
        room.addMarker(across(point.x), up(point.y), front ? kFrontRadius : kMarkerRadius);
      const std::vector<std::array<double, 2>> path = pathOf(series);
      for (std::size_t i = 1; i < path.size(); ++i) {
        const auto [x0, y0] = path[i - 1];
        const auto [x1, y1] = path[i];
        if (front) room.addLine({across(x1), up(y0), across(x1), up(y1)});
        room.addLine({across(x0), up(y0), across(x1), up(front ? y0 : y1)});
      }
    }
    return room;
  }

  void addLabels() {
    LabelRoom room = roomForLabels();
    for (const Series& series : chart_.series)
      for (const Point& point : series.points) {
        if (point.label.empty()) continue;
        const double width = kWideCharacter * kLabelSize * static_cast<double>(point.label.size());
        const auto [box, alignment] = room.place(across(point.x), up(point.y), width, kLabelHeight);
        const double x = alignment == Alignment::left    ? box.left
                         : alignment == Alignment::right ? box.right
                                                         : (box.left + box.right) / 2.0;
        add("set label {} at screen {:.5f},{:.5f} {} front boxed font ',{}' textcolor rgb '{}'", quoted(point.label),
            x / kChartWidth, (box.bottom + box.top) / 2.0 / kChartHeight, nameOf(alignment), kLabelSize, kInk);
      }
  }

  static unsigned colourOf(std::size_t series) { return kColours[series % kColours.size()]; }
  static const Marker& markerOf(std::size_t series) { return kMarkers[series % kMarkers.size()]; }
  static double sizeOf(std::size_t series) { return kMarkerSize * markerOf(series).size; }

  /// The points as coordinates, marker size and colour: each on a white one, which parts markers that overlap.
  void addData(std::size_t i) {
    const Series& series = chart_.series[i];
    add("$points{} << EOD", i);
    for (const Point& point : series.points)
      for (const auto& [size, colour] : {std::pair(sizeOf(i) + kHalo, kWhite), std::pair(sizeOf(i), colourOf(i))})
        add("{:.17g} {:.17g} {} {}", x_.coordinate(point.x), y_.coordinate(point.y), size, colour);
    add("EOD");
    const std::vector<std::array<double, 2>> path = pathOf(series);
    if (path.empty()) return;
    add("$path{} << EOD", i);
    for (const auto& [x, y] : path) add("{:.17g} {:.17g}", x, y);
    add("EOD");
  }

  /// Coordinates that the line of a series joins, by steps for a front.
  std::vector<std::array<double, 2>> pathOf(const Series& series) const {
    std::vector<std::array<double, 2>> path;
    if (series.style == SeriesStyle::markers || series.points.empty()) return path;
    const bool front = series.style == SeriesStyle::front;
    if (front) path.push_back({x_.coordinate(series.points.front().x), y_.high()});
    for (const Point& point : series.points) path.push_back({x_.coordinate(point.x), y_.coordinate(point.y)});
    if (front) path.push_back({x_.high(), y_.coordinate(series.points.back().y)});
    return path;
  }

  std::string lineOf(std::size_t i) const {
    const Series& series = chart_.series[i];
    if (series.style == SeriesStyle::markers || series.points.empty()) return {};
    if (series.style == SeriesStyle::front)
      return fmt::format("$path{} with steps lw 1.8 lc rgb '{}' notitle, ", i, kInk);
    return fmt::format("$path{} with lines lw 1.8 lc rgb {} notitle, ", i, colourOf(i));
  }

  std::string markersOf(std::size_t i) const {
    const Series& series = chart_.series[i];
    if (series.points.empty()) return {};
    if (series.style == SeriesStyle::front)
      return fmt::format("$points{} using 1:2 with points pt 6 ps 2.4 lw 1.5 lc rgb '{}' notitle, ", i, kInk);
    return fmt::format("$points{} using 1:2:3:4 with points pt {} ps variable lw 1.8 lc rgb variable notitle, ", i,
                       markerOf(i).type);
  }

  std::string legendOf(std::size_t i) const {
    const Series& series = chart_.series[i];
    if (series.name.empty()) return {};
    std::string symbol =
        fmt::format("{} pt {} ps {} lw 1.8 lc rgb {}", series.style == SeriesStyle::line ? "linespoints" : "points",
                    markerOf(i).type, sizeOf(i), colourOf(i));
    if (series.style == SeriesStyle::front) symbol = fmt::format("linespoints pt 6 ps 2.4 lw 1.5 lc rgb '{}'", kInk);
    std::string text;
    for (const std::string& line : brokenIntoLines(series.name, kLegendCharacters)) {
      text += fmt::format("keyentry {}{} title {}, ", symbol.empty() ? "" : "with ", symbol, quoted(line));
      symbol.clear();
    }
    return text;
  }

  const Chart& chart_;
  AxisScale x_;
  AxisScale y_;
  Box frame_{};  // pixels
  std::string text_;
};

}  // namespace

std::optional<ChartPictures> drawChart(const Chart& chart) {
  if (chart.series.size() > kMostSeries)
    throw base::Error(base::ExitStatus::internal, fmt::format("chart '{}': {} series; at most {} can be told apart",
                                                              chart.title, chart.series.size(), kMostSeries));
  const std::string script = Script(chart).text();
  const auto draw = [&](std::string_view name, std::string_view end) {
    std::optional<std::string> picture = runGnuplot(terminal(name) + script);
    if (picture && picture->find(end) == std::string::npos)
      throw base::Error(base::ExitStatus::file,
                        fmt::format("gnuplot: chart '{}' is cut: is the disk for temporary files full?", chart.title));
    return picture;
  };
  std::optional<std::string> svg = draw("svg", "</svg>");
  if (!svg) return std::nullopt;
  std::optional<std::string> png = draw("pngcairo", "IEND");
  if (!png) return std::nullopt;
  return ChartPictures{std::move(*svg), std::move(*png)};
}

}  // namespace welkin::study
