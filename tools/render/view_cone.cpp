// SPDX-License-Identifier: Apache-2.0
#include "render/view_cone.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace welkin::render {
namespace {

using f64::Number3;

level::Bounds boundsOf(const level::Scene& scene, const level::Draw& draw) {
  level::Bounds bounds;
  for (uint32_t i = 0; i < draw.index_count; ++i) {
    const auto vertex =
        static_cast<std::size_t>(draw.vertex_offset + std::int64_t{scene.indices[draw.first_index + i]});
    const float(&p)[3] = scene.vertices[vertex].position;
    bounds.add({double{p[0]}, double{p[1]}, double{p[2]}});
  }
  return bounds;
}

Sphere sphereOf(const level::Bounds& bounds, const level::Instance& instance) {
  const auto placed = [&](const Number3& p) {
    Number3 q(0.0);
    for (int i = 0; i < 3; ++i) {
      const float(&row)[4] = instance.row[i];
      const double value = double{row[0]} * p.x + double{row[1]} * p.y + double{row[2]} * p.z + double{row[3]};
      (i == 0 ? q.x : i == 1 ? q.y : q.z) = value;
    }
    return q;
  };
  Sphere sphere{placed((bounds.low + bounds.high) * 0.5), 0.0, 1.0};
  for (int i = 0; i < 8; ++i) {
    const Number3 corner((i & 1) != 0 ? bounds.high.x : bounds.low.x, (i & 2) != 0 ? bounds.high.y : bounds.low.y,
                         (i & 4) != 0 ? bounds.high.z : bounds.low.z);
    const Number3 to = placed(corner) - sphere.middle;
    sphere.radius = std::max(sphere.radius, std::sqrt(dot(to, to)));
  }
  const Number3 size = bounds.high - bounds.low;
  const double own = 0.5 * std::sqrt(dot(size, size));
  if (own > 0.0) sphere.scale = sphere.radius / own;
  sphere.radius *= 1.0 + 1e-5;  // the device places vertices in floats
  return sphere;
}

}  // namespace

std::vector<Sphere> instanceSpheres(const level::Scene& scene) {
  std::vector<Sphere> spheres(scene.instances.size());
  for (const level::Draw& draw : scene.draws) {
    if (draw.index_count == 0) continue;
    const level::Bounds bounds = boundsOf(scene, draw);
    for (uint32_t i = draw.first_instance; i < draw.first_instance + draw.instance_count; ++i)
      spheres[i] = sphereOf(bounds, scene.instances[i]);
  }
  return spheres;
}

ViewCone::ViewCone(const float (&view)[16]) {
  const auto row = [&](int i) {
    return Plane{{double{view[i]}, double{view[4 + i]}, double{view[8 + i]}}, double{view[12 + i]}, 0.0};
  };
  const auto sum = [](const Plane& a, const Plane& b, double sign) {
    return Plane{a.normal + b.normal * sign, a.offset + b.offset * sign, 0.0};
  };
  const Plane x = row(0), y = row(1), w = row(3);
  metre_ = 0.5 * std::sqrt(dot(y.normal, y.normal));
  planes_ = {sum(w, x, 1.0), sum(w, x, -1.0), sum(w, y, 1.0), sum(w, y, -1.0), w};
  for (Plane& plane : planes_) plane.length = std::sqrt(dot(plane.normal, plane.normal));
}

bool ViewCone::sees(const Sphere& sphere) const {
  return std::all_of(planes_.begin(), planes_.end(), [&](const Plane& plane) {
    return dot(plane.normal, sphere.middle) + plane.offset >= -sphere.radius * plane.length;
  });
}

double ViewCone::heightOfMetre(const Sphere& sphere) const {
  const Plane& eye = planes_.back();
  const double nearest = dot(eye.normal, sphere.middle) + eye.offset - sphere.radius * eye.length;
  return nearest > 0.0 ? metre_ / nearest : std::numeric_limits<double>::infinity();
}

}  // namespace welkin::render
