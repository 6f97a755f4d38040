// SPDX-License-Identifier: Apache-2.0
#include "probes/contact/contact_points.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "probes/geometry/directions.h"
#include "probes/geometry/random.h"
#include "probes/placement/validity.h"

namespace welkin::contact {
namespace {

constexpr double kOff_m = 0.05;  ///< points are judged from here, off their surface
constexpr double kLeastPoints = 2.0, kMostPoints = 64.0;
constexpr std::uint64_t kFitSeed = 0xc0, kCheckSeed = 0xc1;

/// The steps of the R2 sequence, powers of the inverse of the plastic number (Roberts, "The Unreasonable Effectiveness
/// of Quasirandom Sequences", 2018).
constexpr double kStep_s = 0.7548776662466927, kStep_r = 0.5698402909980532;

double fractionOf(double v) {
  return v - std::floor(v);
}

/// A point of a triangle, uniform over it for uniform `s` and `r` in [0, 1). It stands for the whole area.
TrianglePoint pointIn(const PlacedVertices& v, const std::array<std::uint32_t, 3>& t, double s, double r) {
  TrianglePoint p;
  const Number3& a = v.position[t[0]];
  const Number3 across = cross(v.position[t[1]] - a, v.position[t[2]] - a);
  const double length = std::sqrt(dot(across, across));
  p.normal = across / length;
  p.area_m2 = 0.5 * length;
  p.vertex = t;
  const double u = std::sqrt(s);
  p.share = {1.0 - u, u * (1.0 - r), u * r};
  for (std::size_t i = 0; i < 3; ++i) p.position += v.position[t[i]] * p.share[i];
  return p;
}

double areaOf(const PlacedVertices& v, const std::array<std::uint32_t, 3>& t) {
  return pointIn(v, t, 0.0, 0.0).area_m2;
}

/// Whether all that the point sees lies against it, as between the layers of a roof.
bool isBuried(const geometry::Tracer& tracer, const TrianglePoint& p) {
  constexpr int kRays = 16;
  constexpr double kAgainst_m = 0.25, kFrom_m = 1e-3;
  for (int i = 0; i < kRays; ++i) {
    const Number3 direction = geometry::cosineDirection(p.normal, fractionOf(kStep_s * i), fractionOf(kStep_r * i));
    if (!tracer.occluded(p.position + p.normal * kFrom_m, direction, kAgainst_m)) return false;
  }
  return true;
}

}  // namespace

std::vector<TrianglePoint> pointsToFit(const PlacedVertices& v, double spacing_m) {
  std::vector<TrianglePoint> points;
  for (std::size_t i = 0; i < v.triangle.size(); ++i) {
    const double squares = std::ceil(areaOf(v, v.triangle[i]) / (spacing_m * spacing_m));
    const auto count = static_cast<std::size_t>(std::clamp(squares, kLeastPoints, kMostPoints));
    geometry::Random random(kFitSeed, i);
    const double s = random.unit();
    const double r = random.unit();
    for (std::size_t k = 0; k < count; ++k) {
      const auto n = static_cast<double>(k);
      points.push_back(pointIn(v, v.triangle[i], fractionOf(s + kStep_s * n), fractionOf(r + kStep_r * n)));
      points.back().area_m2 /= static_cast<double>(count);
    }
  }
  return points;
}

std::vector<TrianglePoint> pointsToCheck(const PlacedVertices& v, std::size_t count) {
  std::vector<double> sum;
  for (const auto& t : v.triangle) sum.push_back((sum.empty() ? 0.0 : sum.back()) + areaOf(v, t));
  std::vector<TrianglePoint> points;
  if (sum.empty()) return points;
  geometry::Random random(kCheckSeed);
  for (std::size_t i = 0; i < count; ++i) {
    const auto found = std::upper_bound(sum.begin(), sum.end() - 1, random.unit() * sum.back());
    const double s = random.unit();
    points.push_back(pointIn(v, v.triangle[static_cast<std::size_t>(found - sum.begin())], s, random.unit()));
    points.back().area_m2 = sum.back() / static_cast<double>(count);
  }
  return points;
}

bool isVisible(const geometry::Tracer& tracer, const TrianglePoint& point) {
  const Number3 off = point.position + point.normal * kOff_m;
  const geometry::Surfaces& s = tracer.surfaces();
  const auto above = tracer.closest(off, {0, 1, 0}, std::numeric_limits<double>::infinity());
  const bool wet = above && s.object[s.triangle[above->triangle].object].role == geometry::Role::water;
  return !wet && !isBuried(tracer, point) && !placement::insideGeometry(tracer, off);
}

}  // namespace welkin::contact
