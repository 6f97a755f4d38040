// SPDX-License-Identifier: Apache-2.0
#include "probes/placement/column.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "probes/placement/validity.h"

namespace welkin::placement {
namespace {

constexpr double kNowhere = std::numeric_limits<double>::infinity();

/// A surface on the line.
struct Crossing {
  double y;
  double normal_y;
  bool front_above;
  bool front_below;
};

/// All crossings from the highest to the lowest.
std::vector<Crossing> crossingsAt(const geometry::Tracer& tracer, double x, double z, double top_y) {
  constexpr double kSheet_m = 1e-3;
  constexpr double kFloats = 4.0 * 0x1p-23;  // rounding of the ray's start
  std::vector<Crossing> result;
  const geometry::Surfaces& s = tracer.surfaces();
  double y = top_y;
  std::optional<std::uint32_t> last;
  while (const auto hit = tracer.closest({x, y, z}, {0, -1, 0}, kNowhere, geometry::Meets::fixed)) {
    if (!last || *last != hit->triangle) {
      const bool two_sides = s.material[s.triangle[hit->triangle].material].double_sided;
      result.push_back({hit->position.y, hit->normal.y, !hit->back, two_sides || hit->back});
    }
    last = hit->triangle;
    y -= hit->distance + kSheet_m + kFloats * std::abs(y - tracer.origin().y);
  }
  return result;
}

}  // namespace

std::vector<Span> spansAt(const geometry::Tracer& tracer, double x, double z, double top_y, double least_m) {
  const std::vector<Crossing> crossing = crossingsAt(tracer, x, z, top_y);
  std::vector<Span> result;
  for (std::size_t i = crossing.size() + 1; i-- > 0;) {
    const Crossing* above = i > 0 ? &crossing[i - 1] : nullptr;
    const Crossing* below = i < crossing.size() ? &crossing[i] : nullptr;
    const bool open_above = above == nullptr || above->front_below;
    const bool open_below = below == nullptr || below->front_above;
    if (!open_above && !open_below) continue;
    Span span{below != nullptr ? below->y : -kNowhere, above != nullptr ? above->y : kNowhere};
    if (span.high_y <= span.low_y) continue;
    if (below != nullptr) span.floor_normal_y = below->normal_y;
    if (!open_above || !open_below) {
      if (above == nullptr || below == nullptr) continue;
      if (span.high_y - span.low_y < least_m) {
        if (open_below) result.push_back(span);
        continue;
      }
      const double rise = std::min(1.0, 0.5 * (span.high_y - span.low_y));
      span.inside = insideGeometry(tracer, {x, span.low_y + rise, z});
      if (span.inside && !open_below) continue;
    }
    result.push_back(span);
  }
  return result;
}

std::optional<double> topOver(const geometry::Surfaces& s, const geometry::SectorId& id) {
  const double low_x = geometry::kSector_m * id.x;
  const double low_z = geometry::kSector_m * id.z;
  std::optional<double> top;
  for (const geometry::Triangle& t : s.triangle) {
    if (s.object[t.object].role != geometry::Role::fixed) continue;
    const auto& a = s.position[t.vertex[0]];
    const auto& b = s.position[t.vertex[1]];
    const auto& c = s.position[t.vertex[2]];
    const auto over = [&](std::size_t axis, double low) {
      return double{std::max({a[axis], b[axis], c[axis]})} >= low &&
             double{std::min({a[axis], b[axis], c[axis]})} <= low + geometry::kSector_m;
    };
    if (!over(0, low_x) || !over(2, low_z)) continue;
    const double high = double{std::max({a[1], b[1], c[1]})} + 1.0;
    top = top ? std::max(*top, high) : high;
  }
  return top;
}

}  // namespace welkin::placement
