// SPDX-License-Identifier: Apache-2.0
#include "picture/probe_picture.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "picture/pen.h"
#include "probes/placement/column.h"
#include "probes/placement/grid_cells.h"

namespace welkin::picture {
namespace {

using f64::Number3;
using geometry::kCell_m;
using geometry::kCells;
using geometry::kNoProbe;
using geometry::kSector_m;
using geometry::PlacedSector;

constexpr double kMost_px = 2000.0;
constexpr double kMargin_px = 4.0;

/// Metres to pixels; `down` grows downwards in the picture.
struct Frame {
  double left = 0.0, top = 0.0, right = 0.0, bottom = 0.0;
  double scale() const {
    return std::min(10.0, (kMost_px - 2.0 * kMargin_px) / std::max({right - left, bottom - top, 1.0}));
  }
  int width() const { return static_cast<int>(std::ceil((right - left) * scale() + 2.0 * kMargin_px)); }
  int height() const { return static_cast<int>(std::ceil((bottom - top) * scale() + 2.0 * kMargin_px)); }
  Corner at(double across, double down) const {
    return {kMargin_px + (across - left) * scale(), kMargin_px + (down - top) * scale()};
  }
};

Colour grey(double brightness) {
  return {brightness, brightness, brightness};
}

Frame frameOf(const std::vector<PlacedSector>& sectors) {
  Frame frame;
  for (const PlacedSector& s : sectors) {
    const bool first = &s == &sectors.front();
    const double x = kSector_m * s.id.x;
    const double z = kSector_m * s.id.z;
    frame.left = first ? x : std::min(frame.left, x);
    frame.right = first ? x + kSector_m : std::max(frame.right, x + kSector_m);
    frame.top = first ? z : std::min(frame.top, z);
    frame.bottom = first ? z + kSector_m : std::max(frame.bottom, z + kSector_m);
  }
  return frame;
}

void drawRelief(Pen& pen, const Frame& frame, const geometry::Tracer& tracer, const PlacedSector& sector) {
  constexpr double kStep_m = 0.5;
  const double top_y = placement::topOver(tracer.surfaces(), sector.id).value_or(0.0);
  const double height = kCells * sector.cell_height_m;
  for (double x = 0.5 * kStep_m; x < kSector_m; x += kStep_m)
    for (double z = 0.5 * kStep_m; z < kSector_m; z += kStep_m) {
      const Number3 from{kSector_m * sector.id.x + x, top_y, kSector_m * sector.id.z + z};
      const auto hit =
          tracer.closest(from, {0, -1, 0}, std::numeric_limits<double>::infinity(), geometry::Meets::fixed);
      if (!hit) continue;
      const double rise = std::clamp((hit->position.y - sector.low_y) / height, 0.0, 1.0);
      const Colour colour = grey((0.55 + 0.4 * std::sqrt(rise)) * (0.6 + 0.4 * hit->normal.y));
      const Corner middle = frame.at(from.x, from.z);
      const double half = 0.5 * kStep_m * frame.scale();
      pen.line({{middle.x - half, middle.y}, {middle.x + half, middle.y}}, colour, 2.0 * half + 0.5);
    }
}

void drawCross(Pen& pen, const Corner& at) {
  pen.line({{at.x - 2, at.y - 2}, {at.x + 2, at.y + 2}}, kInk, 1.0);
  pen.line({{at.x - 2, at.y + 2}, {at.x + 2, at.y - 2}}, kInk, 1.0);
}

void drawProbe(Pen& pen, const Corner& at, std::size_t probe) {
  constexpr double kRadius_px = 5.0;
  pen.line({{at.x - kRadius_px, at.y}, {at.x + kRadius_px, at.y}}, colourOf(probe), 2.0 * kRadius_px);
  pen.ring(at, kRadius_px, kInk);
}

}  // namespace

std::string drawFromAbove(const geometry::Tracer& tracer, const std::vector<PlacedSector>& sectors) {
  const Frame frame = frameOf(sectors);
  Pen pen(frame.width(), frame.height());
  for (const PlacedSector& s : sectors) drawRelief(pen, frame, tracer, s);
  for (const PlacedSector& s : sectors) {
    const double x = kSector_m * s.id.x;
    const double z = kSector_m * s.id.z;
    for (int k = 0; k < kCells; ++k)
      for (int i = 0; i < kCells; ++i) {
        const std::uint8_t probe = s.top[static_cast<std::size_t>(i + kCells * k)];
        if (probe == kNoProbe) continue;
        const Number3& p = s.probe[probe].position;
        pen.line({frame.at(x + (i + 0.5) * kCell_m, z + (k + 0.5) * kCell_m), frame.at(p.x, p.z)}, colourOf(probe),
                 1.5);
      }
    for (std::size_t i = 0; i < s.probe.size(); ++i)
      drawProbe(pen, frame.at(s.probe[i].position.x, s.probe[i].position.z), i);
    pen.line({frame.at(x, z), frame.at(x + kSector_m, z), frame.at(x + kSector_m, z + kSector_m),
              frame.at(x, z + kSector_m), frame.at(x, z)},
             kInk, 1.0, true);
  }
  return pen.finish();
}

std::string drawSection(const geometry::Tracer& tracer, const std::vector<PlacedSector>& sectors, double z) {
  std::vector<PlacedSector> row;
  for (const PlacedSector& s : sectors)
    if (s.id.z == geometry::sectorAt({0, 0, z}).z) row.push_back(s);
  Frame frame = frameOf(row);
  double low_y = row.empty() ? 0.0 : row.front().low_y;
  double high_y = low_y + kCell_m;
  for (const PlacedSector& s : row) {
    low_y = std::min(low_y, s.low_y);
    for (const geometry::Probe& p : s.probe) high_y = std::max(high_y, p.position.y + 8.0);
  }
  frame.top = -high_y;
  frame.bottom = -low_y;
  Pen pen(frame.width(), frame.height());
  for (const PlacedSector& s : row) {
    constexpr double kStep_m = 0.125;
    const double top_y = placement::topOver(tracer.surfaces(), s.id).value_or(0.0);
    const double middle_x = kSector_m * (s.id.x + 0.5);
    pen.line({frame.at(middle_x, -low_y), frame.at(middle_x, -high_y)}, grey(0.75), kSector_m * frame.scale());
    for (double x = kSector_m * s.id.x + 0.5 * kStep_m; x < kSector_m * (s.id.x + 1.0); x += kStep_m) {
      const double width = kStep_m * frame.scale() + 0.5;
      for (const placement::Span& span : placement::spansAt(tracer, x, z, top_y))
        if (!span.inside && span.high_y > low_y && span.low_y < high_y)
          pen.line({frame.at(x, -std::max(span.low_y, low_y)), frame.at(x, -std::min(span.high_y, high_y))}, grey(1.0),
                   width);
    }
    const int k = static_cast<int>(std::floor((z - kSector_m * s.id.z) / kCell_m));
    std::vector<bool> named(s.probe.size(), false);
    for (int j = 0; j < kCells; ++j)
      for (int i = 0; i < kCells; ++i) {
        const double y = s.low_y + (j + 0.5) * s.cell_height_m;
        if (y > high_y) continue;
        const Corner middle = frame.at(kSector_m * s.id.x + (i + 0.5) * kCell_m, -y);
        const std::uint8_t probe = s.grid[placement::cellIndex(i, j, k)];
        if (probe == kNoProbe) {
          drawCross(pen, middle);
          continue;
        }
        named[probe] = true;
        const Number3& p = s.probe[probe].position;
        pen.line({middle, frame.at(p.x, -p.y)}, colourOf(probe), 1.5);
      }
    for (std::size_t i = 0; i < named.size(); ++i)
      if (named[i]) drawProbe(pen, frame.at(s.probe[i].position.x, -s.probe[i].position.y), i);
  }
  return pen.finish();
}

}  // namespace welkin::picture
