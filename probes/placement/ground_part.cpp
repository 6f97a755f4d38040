// SPDX-License-Identifier: Apache-2.0
#include "probes/placement/ground_part.h"

#include <algorithm>
#include <tuple>

namespace welkin::placement {
namespace {

/// The part of a polygon where side * (coordinate - limit) >= 0.
std::vector<Number3> cut(const std::vector<Number3>& polygon, int axis, double limit, double side) {
  std::vector<Number3> result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Number3& a = polygon[i];
    const Number3& b = polygon[(i + 1) % polygon.size()];
    const double of_a = side * (a[axis] - limit);
    const double of_b = side * (b[axis] - limit);
    if (of_a >= 0.0) result.push_back(a);
    if ((of_a < 0.0) != (of_b < 0.0)) result.push_back(a + (b - a) * (of_a / (of_a - of_b)));
  }
  return result;
}

}  // namespace

std::array<Number3, 3> cornersOf(const geometry::Surfaces& surfaces, const geometry::Triangle& triangle) {
  std::array<Number3, 3> corner;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& p = surfaces.position[triangle.vertex[i]];
    corner[i] = {double{p[0]}, double{p[1]}, double{p[2]}};
  }
  return corner;
}

bool isWalkable(const std::array<Number3, 3>& corner, bool two_sides) {
  const Number3 normal = cross(corner[1] - corner[0], corner[2] - corner[0]);
  const double y = two_sides ? std::abs(normal.y) : normal.y;
  return y > 0.0 && y >= kWalkable_normal_y * std::sqrt(dot(normal, normal));
}

GroundPart partOver(const std::array<Number3, 3>& corner, const geometry::SectorId& id) {
  std::vector<Number3> polygon(corner.begin(), corner.end());
  polygon = cut(polygon, 0, geometry::kSector_m * id.x, 1.0);
  polygon = cut(polygon, 0, geometry::kSector_m * (id.x + 1.0), -1.0);
  polygon = cut(polygon, 2, geometry::kSector_m * id.z, 1.0);
  polygon = cut(polygon, 2, geometry::kSector_m * (id.z + 1.0), -1.0);
  GroundPart part;
  double x = 0.0;
  double z = 0.0;
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    const Number3 b = polygon[i - 1] - polygon[0];
    const Number3 c = polygon[i] - polygon[0];
    const double area = 0.5 * std::abs(b.z * c.x - b.x * c.z);
    part.area_m2 += area;
    x += area * (b.x + c.x) / 3.0;
    z += area * (b.z + c.z) / 3.0;
  }
  if (part.area_m2 > 0.0) {
    part.x = polygon[0].x + x / part.area_m2;
    part.z = polygon[0].z + z / part.area_m2;
  }
  return part;
}

std::vector<GroundPart> walkableParts(const geometry::Surfaces& s, const geometry::SectorId& id) {
  std::vector<GroundPart> parts;
  for (const geometry::Triangle& t : s.triangle) {
    if (s.object[t.object].role != geometry::Role::fixed) continue;
    const std::array<Number3, 3> corner = cornersOf(s, t);
    if (!isWalkable(corner, s.material[t.material].double_sided)) continue;
    const GroundPart part = partOver(corner, id);
    if (part.area_m2 > 0.0 && geometry::sectorAt({part.x, 0.0, part.z}) == id) parts.push_back(part);
  }
  std::sort(parts.begin(), parts.end(), [](const GroundPart& a, const GroundPart& b) {
    return std::tuple(-a.area_m2, a.x, a.z) < std::tuple(-b.area_m2, b.x, b.z);
  });
  double area_m2 = 0.0;
  for (const GroundPart& part : parts) area_m2 += part.area_m2;
  if (area_m2 < kLeastGround_m2) return {};
  parts.resize(std::min(parts.size(), geometry::kMostProbes));
  return parts;
}

}  // namespace welkin::placement
