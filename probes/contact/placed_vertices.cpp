// SPDX-License-Identifier: Apache-2.0
#include "probes/contact/placed_vertices.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "probes/geometry/directions.h"
#include "sky/base/error.h"

namespace welkin::contact {
namespace {

Number3 load(const float (&v)[3]) {
  return {double{v[0]}, double{v[1]}, double{v[2]}};
}

/// A normal of a mesh in the world, by the transform's cofactors.
Number3 placedNormal(const geometry::Affine& t, const Number3& n) {
  const Number3 along = cross(t.y, t.z) * n.x + cross(t.z, t.x) * n.y + cross(t.x, t.y) * n.z;
  const double length = std::sqrt(dot(along, along));
  return length > 0.0 ? along * (std::copysign(1.0, t.determinant()) / length) : Number3(0.0, 1.0, 0.0);
}

void addPiece(const level::Scene& scene, const level::Draw& draw, std::uint32_t instance, PlacedVertices& to) {
  if (draw.index_count == 0) return;
  const std::uint32_t* indices = scene.indices.data() + draw.first_index;
  const std::size_t count = std::size_t{*std::max_element(indices, indices + draw.index_count)} + 1;
  if (to.position.size() + count > std::numeric_limits<std::uint32_t>::max())
    throw base::Error(base::ExitStatus::content, "the level has more than 2^32 placed vertices");
  const auto first = static_cast<std::uint32_t>(to.position.size());
  to.piece.push_back({instance, first, static_cast<std::uint32_t>(count)});
  const geometry::Affine& transform = scene.placings[instance].transform;
  for (std::size_t i = 0; i < count; ++i) {
    const level::Vertex& v = scene.vertices[static_cast<std::size_t>(draw.vertex_offset) + i];
    to.position.push_back(transform.point(load(v.position)));
    to.normal.push_back(placedNormal(transform, load(v.normal)));
  }
  for (std::uint32_t i = 0; i < draw.index_count; i += 3) {
    std::array<std::uint32_t, 3> corner{first + indices[i], first + indices[i + 1], first + indices[i + 2]};
    if (draw.mirrored) std::swap(corner[1], corner[2]);
    const Number3& a = to.position[corner[0]];
    const Number3 area = cross(to.position[corner[1]] - a, to.position[corner[2]] - a);
    if (dot(area, area) > 0.0) to.triangle.push_back(corner);
  }
}

/// Vertices are the same place where their numbers agree to a tenth of a millimetre and a thousandth of the normal.
void share(PlacedVertices& vertices) {
  std::map<std::array<std::int64_t, 6>, std::uint32_t> known;
  const auto rounded = [](double v, double step) { return static_cast<std::int64_t>(std::llround(v / step)); };
  constexpr double kPlace_m = 1e-4, kNormal = 1e-3;
  for (std::size_t i = 0; i < vertices.position.size(); ++i) {
    const Number3& p = vertices.position[i];
    const Number3& n = vertices.normal[i];
    const auto next = static_cast<std::uint32_t>(known.size());
    const auto found = known.emplace(
        std::array<std::int64_t, 6>{rounded(p.x, kPlace_m), rounded(p.y, kPlace_m), rounded(p.z, kPlace_m),
                                    rounded(n.x, kNormal), rounded(n.y, kNormal), rounded(n.z, kNormal)},
        next);
    vertices.shared.push_back(found.first->second);
  }
  vertices.places = known.size();
}

}  // namespace

PlacedVertices placedVertices(const level::Scene& scene) {
  PlacedVertices vertices;
  for (const level::Draw& draw : scene.draws) {
    if (draw.role != geometry::Role::fixed) continue;
    for (std::uint32_t i = 0; i < draw.instance_count; ++i) addPiece(scene, draw, draw.first_instance + i, vertices);
  }
  share(vertices);
  return vertices;
}

}  // namespace welkin::contact
