// SPDX-License-Identifier: Apache-2.0
#include "probes/placement/narrow_ground.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "probes/placement/ground_part.h"

namespace welkin::placement {
namespace {

constexpr double kNarrow_m = 0.5;  // spacing of the lattice
constexpr double kAbove_m = 0.1;   // of a foot above its ground

/// Points of the lattice on the triangles that one can walk on.
std::vector<Number3> pointsOnGround(const geometry::Surfaces& s, const geometry::SectorId& id) {
  const Number3 corner = geometry::cornerOf(id);
  static constexpr int kLines = static_cast<int>(geometry::kSector_m / kNarrow_m);
  const double aside_x = corner.x + 0.5 * kNarrow_m + 0.0131, aside_z = corner.z + 0.5 * kNarrow_m + 0.0173;
  std::vector<Number3> points;
  for (const geometry::Triangle& t : s.triangle) {
    if (s.object[t.object].role != geometry::Role::fixed) continue;
    std::array<Number3, 3> v;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& p = s.position[t.vertex[i]];
      v[i] = {p[0], p[1], p[2]};
    }
    Number3 normal = cross(v[1] - v[0], v[2] - v[0]);
    if (s.material[t.material].double_sided && normal.y < 0.0) normal = -normal;
    if (!(normal.y > 0.0) || normal.y < kWalkable_normal_y * std::sqrt(dot(normal, normal))) continue;
    const auto line = [](double at) { return std::clamp(static_cast<int>(std::ceil(at)), 0, kLines); };
    const auto [low_x, high_x] = std::minmax({v[0].x, v[1].x, v[2].x});
    const auto [low_z, high_z] = std::minmax({v[0].z, v[1].z, v[2].z});
    for (int k = line((low_z - aside_z) / kNarrow_m); k < line((high_z - aside_z) / kNarrow_m); ++k)
      for (int i = line((low_x - aside_x) / kNarrow_m); i < line((high_x - aside_x) / kNarrow_m); ++i) {
        const double x = aside_x + i * kNarrow_m, z = aside_z + k * kNarrow_m;
        double least = 1.0, most = -1.0;
        for (std::size_t e = 0; e < 3; ++e) {
          const Number3 &a = v[e], &b = v[(e + 1) % 3];
          const double side = (b.x - a.x) * (z - a.z) - (b.z - a.z) * (x - a.x);
          least = e == 0 ? side : std::min(least, side);
          most = e == 0 ? side : std::max(most, side);
        }
        if (least < 0.0 && most > 0.0) continue;
        const double y = v[0].y - (normal.x * (x - v[0].x) + normal.z * (z - v[0].z)) / normal.y;
        points.push_back({x, y, z});
      }
  }
  return points;
}

}  // namespace

std::vector<WalkablePoint> narrowGround(const geometry::Tracer& tracer, const geometry::SectorId& id,
                                        const PlacementSettings& settings, const base::Progress& progress) {
  std::vector<Number3> points = pointsOnGround(tracer.surfaces(), id);
  if (points.size() > kMostNarrow) {
    const std::size_t all = points.size();
    for (std::size_t i = 0; i < kMostNarrow; ++i) points[i] = points[i * all / kMostNarrow];
    points.resize(kMostNarrow);
  }
  std::vector<double> height_m(points.size(), 0.0);
  tbb::parallel_for(std::size_t{0}, points.size(), [&](std::size_t i) {
    if (i % 64 == 0) progress.check();
    const Number3 foot = points[i] + Number3(0.0, kAbove_m, 0.0);
    const auto roof = tracer.closest(foot, {0, 1, 0}, geometry::kSector_m, geometry::Meets::fixed);
    if (roof && !roof->back) height_m[i] = roof->distance + kAbove_m;
  });
  std::vector<WalkablePoint> result;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (height_m[i] < settings.headroom_m) continue;
    const double above_m = std::min(settings.height_m, 0.5 * height_m[i]);
    result.push_back({points[i] + Number3(0.0, kAbove_m, 0.0), points[i] + Number3(0.0, above_m, 0.0), false});
  }
  return result;
}

}  // namespace welkin::placement
