// SPDX-License-Identifier: Apache-2.0
#include "probes/placement/cell_faces.h"

#include <algorithm>
#include <cmath>

#include "probes/placement/grid_cells.h"

namespace welkin::placement {
namespace {

/// The part of a convex polygon with sign * coordinate <= sign * limit (Sutherland and Hodgman, 1974).
std::vector<Number3> clippedAt(const std::vector<Number3>& polygon, int axis, double limit, double sign) {
  std::vector<Number3> result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Number3& a = polygon[i];
    const Number3& b = polygon[(i + 1) % polygon.size()];
    const double da = sign * (a[axis] - limit);
    const double db = sign * (b[axis] - limit);
    if (da <= 0.0) result.push_back(a);
    if ((da < 0.0 && db > 0.0) || (da > 0.0 && db < 0.0)) result.push_back(a + (b - a) * (da / (da - db)));
  }
  return result;
}

std::vector<Number3> clippedTo(std::vector<Number3> polygon, const geometry::Box& box) {
  for (int axis = 0; axis < 3 && !polygon.empty(); ++axis) {
    polygon = clippedAt(polygon, axis, box.high[axis], 1.0);
    polygon = clippedAt(polygon, axis, box.low[axis], -1.0);
  }
  return polygon;
}

geometry::Box grown(const geometry::Box& box, double by) {
  return {box.low - Number3(by), box.high + Number3(by)};
}

double areaOf(const std::vector<Number3>& polygon) {
  Number3 sum(0.0);
  for (std::size_t i = 2; i < polygon.size(); ++i) sum += cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
  return 0.5 * std::sqrt(dot(sum, sum));
}

Number3 middleOfCorners(const std::vector<Number3>& polygon) {
  Number3 sum(0.0);
  for (const Number3& p : polygon) sum += p;
  return sum / static_cast<double>(polygon.size());
}

}  // namespace

geometry::Box boxOfCell(const geometry::SectorId& id, double low_y, double cell_height_m, std::size_t cell) {
  const auto i = static_cast<int>(cell) % geometry::kCells;
  const auto j = static_cast<int>(cell) / geometry::kCells % geometry::kCells;
  const auto k = static_cast<int>(cell) / (geometry::kCells * geometry::kCells);
  const Number3 low{geometry::kSector_m * id.x + i * geometry::kCell_m, low_y + j * cell_height_m,
                    geometry::kSector_m * id.z + k * geometry::kCell_m};
  return {low, low + Number3(geometry::kCell_m, cell_height_m, geometry::kCell_m)};
}

format::CutPlane cutPlaneOf(const Number3& normal, const Number3& through) {
  constexpr double kFull = 32767.0;
  const double size = std::abs(normal.x) + std::abs(normal.y) + std::abs(normal.z);
  auto u = static_cast<std::int16_t>(std::lround(normal.x / size * kFull));
  auto v = static_cast<std::int16_t>(std::lround(normal.z / size * kFull));
  if (std::abs(int{u}) + std::abs(int{v}) > 32767) {  // both were rounded up
    std::int16_t& larger = std::abs(int{u}) > std::abs(int{v}) ? u : v;
    larger = static_cast<std::int16_t>(larger + (larger > 0 ? -1 : 1));
  }
  const bool flip = normal.y < 0.0 || (normal.y == 0.0 && (u < 0 || (u == 0 && v < 0)));
  if (flip) {
    u = static_cast<std::int16_t>(-u);
    v = static_cast<std::int16_t>(-v);
  }
  const format::FromCorner n = format::normalOf({u, v, 0.0F});
  const double offset = double{n[0]} * through.x + double{n[1]} * through.y + double{n[2]} * through.z;
  return {u, v, static_cast<float>(offset)};
}

std::vector<std::vector<CellFace>> cellFacesOf(const geometry::Surfaces& s, const geometry::SectorId& id, double low_y,
                                               double cell_height_m) {
  std::vector<std::vector<CellFace>> result(kAllCells);
  const Number3 corner = geometry::cornerOf(id);
  const Number3 low = corner + Number3(0.0, low_y, 0.0);
  const Number3 size(geometry::kCell_m, cell_height_m, geometry::kCell_m);
  const geometry::Box all = grown({low, low + size * double{geometry::kCells}}, kBesideCell_m);
  for (const geometry::Triangle& t : s.triangle) {
    if (s.object[t.object].role != geometry::Role::fixed) continue;
    std::vector<Number3> polygon;
    for (const std::uint32_t vertex : t.vertex) {
      const auto& p = s.position[vertex];
      polygon.push_back({p[0], p[1], p[2]});
    }
    Number3 normal = cross(polygon[1] - polygon[0], polygon[2] - polygon[0]);
    const double length = std::sqrt(dot(normal, normal));
    polygon = clippedTo(std::move(polygon), all);
    if (polygon.size() < 3 || !(length > 0.0)) continue;
    normal = normal / length;
    const format::CutPlane plane = cutPlaneOf(normal, middleOfCorners(polygon) - corner);
    std::array<int, 3> first{}, last{};
    for (int axis = 0; axis < 3; ++axis) {
      const auto byAxis = [axis](const Number3& a, const Number3& b) { return a[axis] < b[axis]; };
      const auto [least, most] = std::minmax_element(polygon.begin(), polygon.end(), byAxis);
      const auto cellOf = [&](double v) {
        return std::clamp(static_cast<int>(std::floor((v - low[axis]) / size[axis])), 0, geometry::kCells - 1);
      };
      first[static_cast<std::size_t>(axis)] = cellOf((*least)[axis] - kBesideCell_m);
      last[static_cast<std::size_t>(axis)] = cellOf((*most)[axis] + kBesideCell_m);
    }
    for (int k = first[2]; k <= last[2]; ++k)
      for (int j = first[1]; j <= last[1]; ++j)
        for (int i = first[0]; i <= last[0]; ++i) {
          const std::size_t cell = cellIndex(i, j, k);
          const geometry::Box box = boxOfCell(id, low_y, cell_height_m, cell);
          if (clippedTo(polygon, grown(box, kBesideCell_m)).size() < 3) continue;
          std::vector<Number3> part = clippedTo(polygon, box);
          if (part.size() < 3) part.clear();
          const double area_m2 = areaOf(part);
          result[cell].push_back({std::move(part), area_m2, normal, plane});
        }
  }
  return result;
}

}  // namespace welkin::placement
