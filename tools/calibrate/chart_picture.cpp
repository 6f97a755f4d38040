// SPDX-License-Identifier: Apache-2.0
#include "calibrate/chart_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "picture/digits.h"
#include "picture/pen.h"
#include "sh/deterministic.h"

namespace welkin::calibrate {
namespace {

using picture::Corner;
using picture::Pen;

constexpr Box kPhoto = {20.0, 20.0, 650.0, 480.0};
constexpr Box kCells = {690.0, 20.0, 540.0, 480.0};  // thirds of a cell are whole pixels
constexpr Box kBars = {70.0, 530.0, 1150.0, 240.0};
constexpr double kCellGap = 6.0;
constexpr picture::Colour kWhite = {1.0, 1.0, 1.0}, kGrid = {0.82, 0.82, 0.82};

std::vector<Corner> edgeOf(const Box& b) {
  return {{b.x, b.y}, {b.x + b.width, b.y}, {b.x + b.width, b.y + b.height}, {b.x, b.y + b.height}};
}

std::uint8_t codeOf(double light) {
  return static_cast<std::uint8_t>(std::lround(255.0 * det::srgbEncode(std::clamp(light, 0.0, 1.0))));
}

picture::Colour shown(const Colour& rgb) {
  return {codeOf(rgb[0]) / 255.0, codeOf(rgb[1]) / 255.0, codeOf(rgb[2]) / 255.0};
}

/// The mean light of squares of pixels, in sRGB.
picture::Pixels reduced(const image::Image& image, int factor) {
  picture::Pixels result{image.width / factor, image.height / factor, {}};
  for (int y = 0; y < result.height; ++y)
    for (int x = 0; x < result.width; ++x)
      for (std::size_t c = 0; c < 3; ++c) {
        double sum = 0.0;
        for (int row = 0; row < factor; ++row)
          for (int column = 0; column < factor; ++column)
            sum += double{
                image.rgb[3 * (static_cast<std::size_t>(y * factor + row) * static_cast<std::size_t>(image.width) +
                               static_cast<std::size_t>(x * factor + column)) +
                          c]};
        result.rgb.push_back(codeOf(sum / (factor * factor)));
      }
  return result;
}

void drawPhoto(Pen& pen, const image::Image& photo) {
  const Box box = photoBox(photo.width, photo.height);
  const int sharp = static_cast<int>(photo.width / box.width);
  const int factor = std::max(1, std::min({sharp, photo.width, photo.height}));
  const picture::Pixels pixels = reduced(photo, factor);
  // The last pixels of a side that no square holds are left out, so the squares cover a little less than the box.
  pen.picture(pixels, {box.x, box.y}, box.width * factor / photo.width);
}

void drawOutline(Pen& pen, const image::Image& photo, const ChartPlace& place, const picture::Colour& colour) {
  const Box box = photoBox(photo.width, photo.height);
  const double scale = box.width / photo.width;
  const auto at = [&](const Point& p) { return Corner{box.x + scale * p.x(), box.y + scale * p.y()}; };
  std::vector<Corner> outline;
  for (const Point& p : place.corners()) outline.push_back(at(p));
  outline.push_back(outline[0]);
  pen.line(outline, kWhite, 4.0);
  pen.line(outline, colour, 2.0);
  for (std::size_t i = 0; i < kPatches; ++i) {
    std::vector<Corner> middle;  // the part that was measured
    for (const auto& [u, v] : {std::pair(0.25, 0.25), {0.75, 0.25}, {0.75, 0.75}, {0.25, 0.75}, {0.25, 0.25}})
      middle.push_back(at(place.pixelOf(i, u, v)));
    pen.line(middle, colour, 1.0);
  }
  pen.ring(outline[0], 7.0, kWhite);
  pen.ring(outline[0], 5.5, colour);
}

void cross(Pen& pen, const Box& b) {
  pen.line({{b.x, b.y}, {b.x + b.width, b.y + b.height}}, picture::kInk, 1.5);
  pen.line({{b.x, b.y + b.height}, {b.x + b.width, b.y}}, picture::kInk, 1.5);
}

bool isUsed(const DrawnChart& chart, std::size_t patch) {
  return std::find(chart.used.begin(), chart.used.end(), patch) != chart.used.end();
}

void drawCells(Pen& pen, const DrawnChart& chart, const ReferenceChart& reference) {
  for (std::size_t i = 0; i < kPatches; ++i) {
    const Box cell = cellOf(i);
    const std::array<Colour, 3> colours = {chart.patches[i].mean, chart.model(chart.patches[i].mean), reference[i]};
    for (std::size_t k = 0; k < 3; ++k)
      pen.fill(edgeOf({cell.x + static_cast<double>(k) * cell.width / 3.0, cell.y, cell.width / 3.0, cell.height}),
               shown(colours[k]));
    if (!isUsed(chart, i)) cross(pen, cell);
  }
}

void write(Pen& pen, const std::string& number, const Corner& middle) {
  constexpr double kHeight = 10.0;
  const Corner at = {middle.x - 0.5 * picture::widthOf(number, kHeight), middle.y - 0.5 * kHeight};
  for (const std::vector<Corner>& line : picture::linesOf(number, at, kHeight)) pen.line(line, picture::kInk, 1.5);
}

void drawScale(Pen& pen, double range) {
  constexpr int kSteps = 5;
  for (int i = 0; i <= kSteps; ++i) {
    const double y = kBars.y + kBars.height * (1.0 - static_cast<double>(i) / kSteps);
    pen.line({{kBars.x, y}, {kBars.x + kBars.width, y}}, kGrid, 1.0);
    write(pen, fmt::format("{:g}", range * i / kSteps), {kBars.x - 25.0, y});
  }
}

void drawBars(Pen& pen, const DrawnChart& chart, const ReferenceChart& reference) {
  const double range = errorRange(chart);
  drawScale(pen, range);
  const auto part = [&](const Box& bar, double margin, double error) {
    const double height = bar.height * error / range;
    return edgeOf({bar.x + margin * bar.width, bar.y + bar.height - height, (1.0 - 2.0 * margin) * bar.width, height});
  };
  for (std::size_t i = 0; i < kPatches; ++i) {
    const Box bar = barOf(i);
    const double bottom = bar.y + bar.height;
    pen.fill(edgeOf({bar.x, bottom + 6.0, bar.width, 14.0}), shown(reference[i]));
    write(pen, std::to_string(i + 1), {bar.x + 0.5 * bar.width, bottom + 36.0});
    if (!isUsed(chart, i)) cross(pen, {bar.x, bottom + 6.0, bar.width, 14.0});
  }
  for (std::size_t k = 0; k < chart.used.size(); ++k) {
    const Box bar = barOf(chart.used[k]);
    if (!chart.left_out.empty()) pen.fill(part(bar, 0.0, chart.left_out[k]), picture::colourOf(5));
    pen.fill(part(bar, 0.25, chart.after[k]), picture::colourOf(0));
    const double y = bar.y + bar.height * (1.0 - chart.before[k] / range);
    pen.line({{bar.x, y}, {bar.x + bar.width, y}}, picture::kInk, 2.0);
  }
}

}  // namespace

Box photoBox(int width, int height) {
  const double scale = std::min(kPhoto.width / width, kPhoto.height / height);
  return {kPhoto.x, kPhoto.y, scale * width, scale * height};
}

Box cellOf(std::size_t patch) {
  const double width = kCells.width / static_cast<double>(kColumns),
               height = kCells.height / static_cast<double>(kRows);
  return {kCells.x + width * static_cast<double>(patch % kColumns),
          kCells.y + height * static_cast<double>(patch / kColumns), width - kCellGap, height - kCellGap};
}

Box barOf(std::size_t patch) {
  const double step = kBars.width / static_cast<double>(kPatches);
  return {kBars.x + step * (static_cast<double>(patch) + 0.15), kBars.y, 0.7 * step, kBars.height};
}

double errorRange(const DrawnChart& chart) {
  double most = 0.0;
  for (const auto* errors : {&chart.before, &chart.after, &chart.left_out})
    for (const double error : *errors) most = std::max(most, error);
  double range = 1.0;
  for (int i = 0; range < most; ++i) range *= i % 3 == 1 ? 2.5 : 2.0;
  return range;
}

std::string drawReport(const image::Image& photo, const std::vector<ChartPlace>& charts, const DrawnChart& chart,
                       const ReferenceChart& reference) {
  Pen pen(kPictureWidth, kPictureHeight);
  drawPhoto(pen, photo);
  for (std::size_t i = 0; i < charts.size(); ++i) drawOutline(pen, photo, charts[i], picture::colourOf(i == 0 ? 0 : 1));
  drawCells(pen, chart, reference);
  drawBars(pen, chart, reference);
  return pen.finish();
}

}  // namespace welkin::calibrate
