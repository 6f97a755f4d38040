// SPDX-License-Identifier: Apache-2.0
#include "probes/placement/column.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "probes/placement/validity.h"

namespace welkin::placement {
namespace {

constexpr double kNowhere = std::numeric_limits<double>::infinity();
constexpr std::size_t kFew = 64;          // surfaces on an ordinary line
constexpr std::size_t kMostAsked = 2048;  // doubtful spans of other lines, times the surfaces on the line

/// A surface on the line.
struct Crossing {
  std::uint32_t triangle;
  double y;
  double normal_y;
  bool front_above;
  bool front_below;
};

/// The space between two crossings that follow each other.
struct Gap {
  Span span;
  bool open_above = false;  ///< the surface above shows its front
  bool open_below = false;
  double height_m() const { return span.high_y - span.low_y; }
  bool isDoubtful() const { return open_above != open_below; }
};

/// Collects the crossings of a line from the highest to the lowest.
class Line {
 public:
  Line(const geometry::Tracer& tracer, double top_y) : tracer_(tracer), y_(top_y) {}

  /// The height where the rest of the line begins: just below the last surface.
  double y() const { return y_; }

  /// Takes the next surface, which a ray from `from_y` has met.
  void add(const geometry::Hit& hit, double from_y) {
    constexpr double kSheet_m = 1e-3;
    constexpr double kFloats = 4.0 * 0x1p-23;  // rounding of the ray's start
    if (from_y - hit.distance > y_) return;
    if (crossing_.empty() || crossing_.back().triangle != hit.triangle) {
      const geometry::Surfaces& s = tracer_.surfaces();
      const bool two_sides = s.material[s.triangle[hit.triangle].material].double_sided;
      crossing_.push_back({hit.triangle, hit.position.y, hit.normal.y, !hit.back, two_sides || hit.back});
    }
    y_ = from_y - (hit.distance + kSheet_m + kFloats * std::abs(from_y - tracer_.origin().y));
  }

  const std::vector<Crossing>& crossings() const { return crossing_; }

 private:
  const geometry::Tracer& tracer_;
  double y_;
  std::vector<Crossing> crossing_;
};

/// All crossings from the highest to the lowest. A ray for each serves ordinary lines; where they are many, one ray
/// meets the rest, since the time of each grows with them.
std::vector<Crossing> crossingsAt(const geometry::Tracer& tracer, double x, double z, double top_y) {
  const Number3 kDown{0, -1, 0};
  Line line(tracer, top_y);
  while (line.crossings().size() < kFew) {
    const auto hit = tracer.closest({x, line.y(), z}, kDown, kNowhere, geometry::Meets::fixed);
    if (!hit) return line.crossings();
    line.add(*hit, line.y());
  }
  const double from_y = line.y();
  for (const geometry::Hit& hit : tracer.all({x, from_y, z}, kDown, kNowhere, geometry::Meets::fixed))
    line.add(hit, from_y);
  return line.crossings();
}

/// The height from which doubtful spans are asked whether they are inside: at most kMostAsked / crossings of them, the
/// highest, where the line crosses more than kFew surfaces.
double leastAsked(std::vector<double> doubtful_m, std::size_t crossings) {
  const std::size_t most = crossings <= kFew ? doubtful_m.size() : kMostAsked / crossings;
  if (doubtful_m.size() <= most) return 0.0;
  std::sort(doubtful_m.begin(), doubtful_m.end(), std::greater<>());
  return std::nextafter(doubtful_m[most], kNowhere);
}

}  // namespace

std::vector<Span> spansAt(const geometry::Tracer& tracer, double x, double z, double top_y, double least_m) {
  const std::vector<Crossing> crossing = crossingsAt(tracer, x, z, top_y);
  std::vector<Gap> gaps;
  std::vector<double> doubtful_m;
  for (std::size_t i = crossing.size() + 1; i-- > 0;) {
    const Crossing* above = i > 0 ? &crossing[i - 1] : nullptr;
    const Crossing* below = i < crossing.size() ? &crossing[i] : nullptr;
    Gap gap{{below != nullptr ? below->y : -kNowhere, above != nullptr ? above->y : kNowhere}};
    gap.open_above = above == nullptr || above->front_below;
    gap.open_below = below == nullptr || below->front_above;
    if (gap.height_m() <= 0.0 || (!gap.open_above && !gap.open_below)) continue;
    if (gap.isDoubtful() && (above == nullptr || below == nullptr)) continue;
    if (below != nullptr) gap.span.floor_normal_y = below->normal_y;
    if (gap.isDoubtful() && gap.height_m() >= least_m) doubtful_m.push_back(gap.height_m());
    gaps.push_back(gap);
  }
  const double asked_m = std::max(least_m, leastAsked(std::move(doubtful_m), crossing.size()));
  std::vector<Span> result;
  for (Gap& gap : gaps) {
    if (gap.isDoubtful() && gap.height_m() >= asked_m)
      gap.span.inside = insideGeometry(tracer, {x, gap.span.low_y + std::min(1.0, 0.5 * gap.height_m()), z});
    if (gap.open_below || (gap.height_m() >= asked_m && !gap.span.inside)) result.push_back(gap.span);
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
