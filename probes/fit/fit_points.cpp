// SPDX-License-Identifier: Apache-2.0
#include "probes/fit/fit_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "probes/geometry/directions.h"
#include "probes/geometry/random.h"
#include "probes/placement/validity.h"

namespace welkin::fit {
namespace {

/// Points are judged from here, metres off their surface.
constexpr double kOff_m = 0.05;
constexpr double kLowest_m = 0.3, kHighest_m = 2.0;
constexpr double kWalkable_y = 0.5;  ///< cosine of the steepest ground

/// Draws for a point at most, on average. Points fail in water and within bodies, or beyond the sector's square.
constexpr std::size_t kDraws = 400;

/// The triangles of static geometry that touch a sector's square, with the sum of their areas up to each.
class StaticSurface {
 public:
  StaticSurface(const geometry::Surfaces& surfaces, const Number3& corner) : surfaces_(surfaces), corner_(corner) {
    double area = 0.0;
    for (std::size_t i = 0; i < surfaces.triangle.size(); ++i) {
      const geometry::Triangle& t = surfaces.triangle[i];
      if (surfaces.object[t.object].role != geometry::Role::fixed) continue;
      const auto p = verticesOf(t);
      if (!touches(p)) continue;
      const Number3 normal = cross(p[1] - p[0], p[2] - p[0]);
      area += std::sqrt(dot(normal, normal));
      triangle_.push_back(i);
      sum_.push_back(area);
    }
  }

  bool empty() const { return sum_.empty() || !(sum_.back() > 0.0); }

  /// Of the triangles, within the square or not.
  double area_m2() const { return 0.5 * sum_.back(); }

  bool holds(const Number3& p) const {
    const Number3 from = p - corner_;
    return from.x >= 0.0 && from.x < geometry::kSector_m && from.z >= 0.0 && from.z < geometry::kSector_m;
  }

  FitPoint draw(geometry::Random& random) const {
    const auto found = std::upper_bound(sum_.begin(), sum_.end(), random.unit() * sum_.back());
    const auto i = std::min(static_cast<std::size_t>(found - sum_.begin()), sum_.size() - 1);
    const auto p = verticesOf(surfaces_.triangle[triangle_[i]]);
    const double u = std::sqrt(random.unit());
    const double v = random.unit();
    return {p[0] * (1.0 - u) + p[1] * (u * (1.0 - v)) + p[2] * (u * v),
            geometry::unit(cross(p[1] - p[0], p[2] - p[0]))};
  }

 private:
  std::array<Number3, 3> verticesOf(const geometry::Triangle& t) const {
    std::array<Number3, 3> p;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& v = surfaces_.position[t.vertex[i]];
      p[i] = Number3(v[0], v[1], v[2]);
    }
    return p;
  }

  bool touches(const std::array<Number3, 3>& p) const {
    const auto along = [&](double a, double b, double c, double from) {
      return std::max({a, b, c}) > from && std::min({a, b, c}) < from + geometry::kSector_m;
    };
    return along(p[0].x, p[1].x, p[2].x, corner_.x) && along(p[0].z, p[1].z, p[2].z, corner_.z);
  }

  const geometry::Surfaces& surfaces_;
  Number3 corner_;
  std::vector<std::size_t> triangle_;
  std::vector<double> sum_;
};

bool isUnderWater(const geometry::Tracer& tracer, const Number3& p) {
  const geometry::Surfaces& s = tracer.surfaces();
  const auto above = tracer.closest(p, {0, 1, 0}, std::numeric_limits<double>::infinity());
  return above && s.object[s.triangle[above->triangle].object].role == geometry::Role::water;
}

}  // namespace

FitPoints pointsOf(const geometry::Tracer& tracer, geometry::SectorId sector, std::size_t surface, std::size_t air,
                   std::uint64_t seed) {
  FitPoints points;
  const StaticSurface ground(tracer.surfaces(), geometry::cornerOf(sector));
  if (ground.empty()) return points;
  geometry::Random random(seed);
  const std::size_t most = kDraws * std::max(surface, air);
  std::size_t surface_draws = 0, air_draws = 0;
  for (std::size_t i = 0; i < most && (points.surface.size() < surface || points.air.size() < air); ++i) {
    if (points.surface.size() < surface) ++surface_draws;
    if (points.air.size() < air) ++air_draws;
    const FitPoint point = ground.draw(random);
    const double height_m = kLowest_m + (kHighest_m - kLowest_m) * random.unit();
    const double s = random.unit();
    const double t = random.unit();
    if (!ground.holds(point.position)) continue;
    const bool wants_air = points.air.size() < air && point.normal.y >= kWalkable_y;
    if (!wants_air && points.surface.size() >= surface) continue;
    const Number3 off = point.position + point.normal * kOff_m;
    if (isUnderWater(tracer, off) || placement::insideGeometry(tracer, off)) continue;
    if (points.surface.size() < surface) points.surface.push_back(point);
    const Number3 above = point.position + Number3(0.0, height_m, 0.0);
    if (wants_air && placement::sees(tracer, off, above))
      points.air.push_back({above, geometry::sphereDirection(s, t)});
  }
  const auto share = [](std::size_t found, std::size_t draws) {
    return draws > 0 ? static_cast<double>(found) / static_cast<double>(draws) : 0.0;
  };
  points.surface_m2 = ground.area_m2() * share(points.surface.size(), surface_draws);
  points.air_m2 = ground.area_m2() * share(points.air.size(), air_draws);
  return points;
}

}  // namespace welkin::fit
