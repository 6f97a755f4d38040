// SPDX-License-Identifier: Apache-2.0
#include "probes/geometry/tracer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "probes/geometry/directions.h"
#include "probes/geometry/nearest_point.h"
#include "probes/geometry/tracer_scene.h"

namespace welkin::geometry {
namespace {

void setRay(RTCRay& ray, const Number3& origin, const Number3& direction, double far, Meets meets) {
  ray.org_x = static_cast<float>(origin.x);
  ray.org_y = static_cast<float>(origin.y);
  ray.org_z = static_cast<float>(origin.z);
  ray.dir_x = static_cast<float>(direction.x);
  ray.dir_y = static_cast<float>(direction.y);
  ray.dir_z = static_cast<float>(direction.z);
  ray.tnear = 0.0F;
  ray.tfar = static_cast<float>(std::min(far, double{std::numeric_limits<float>::max()}));
  ray.time = 0.0F;
  ray.mask = meets == Meets::fixed ? kFixedMask : kFixedMask | kOtherMask;
  ray.id = 0;
  ray.flags = meets == Meets::light ? kForLight : 0;
}

bool isOneSided(const Material& material) {
  return !material.double_sided && !material.letsLightThrough();
}

}  // namespace

/// A triangle on a ray, as Embree tells it.
struct Tracer::Met {
  float distance;
  std::uint32_t triangle;
  float u, v;
};

Tracer::Tracer(const Surfaces& surfaces, const std::optional<Number3>& about)
    : scene_(std::make_shared<Scene>(surfaces, about ? *about : nearestToZero(surfaces))) {}
Tracer::Tracer(std::shared_ptr<const Scene> scene, const Square& square) : scene_(std::move(scene)), square_(square) {}
Tracer::~Tracer() = default;
Tracer::Tracer(Tracer&&) noexcept = default;
Tracer& Tracer::operator=(Tracer&&) noexcept = default;

const Surfaces& Tracer::surfaces() const {
  return *scene_->surfaces;
}

const Number3& Tracer::origin() const {
  return scene_->origin;
}

Tracer Tracer::within(const Number3& about, double reach_m) const {
  return {scene_, Square{about.x - reach_m, about.x + reach_m, about.z - reach_m, about.z + reach_m}};
}

double Tracer::leavesAfter(const Number3& origin, const Number3& direction) const {
  const auto along = [](double from, double slope, double low, double high) {
    if (slope == 0.0) return std::numeric_limits<double>::infinity();
    return ((slope > 0.0 ? high : low) - from) / slope;
  };
  const double x = along(origin.x, direction.x, square_.low_x, square_.high_x);
  const double z = along(origin.z, direction.z, square_.low_z, square_.high_z);
  return std::max(std::min(x, z), 0.0);
}

std::optional<Tracer::Met> Tracer::meet(const Number3& origin, const Number3& direction, double far,
                                        Meets meets) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRayHit ray;
  setRay(ray.ray, origin - scene_->origin, direction, std::min(far, leavesAfter(origin, direction)), meets);
  ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  ray.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(scene_->scene, &context, &ray);
  if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  return Met{ray.ray.tfar, scene_->triangleOf(ray.hit.geomID, ray.hit.primID), ray.hit.u, ray.hit.v};
}

std::optional<Hit> Tracer::closest(const Number3& origin, const Number3& direction, double far, Meets meets) const {
  const auto met = meet(origin, direction, far, meets);
  return met ? std::optional(hitOf(*met, direction)) : std::nullopt;
}

std::vector<Hit> Tracer::all(const Number3& origin, const Number3& direction, double far, Meets meets) const {
  struct Question {
    RTCIntersectContext context;  // first, so that Embree's pointer to it is one to the question
    const Scene* scene;
    std::vector<Met> met;
  } question{{}, scene_.get(), {}};
  rtcInitIntersectContext(&question.context);
  question.context.filter = [](const RTCFilterFunctionNArguments* arguments) {
    auto& q = *reinterpret_cast<Question*>(arguments->context);
    for (unsigned i = 0; i < arguments->N; ++i) {
      if (arguments->valid[i] == 0) continue;
      q.met.push_back({RTCRayN_tfar(arguments->ray, arguments->N, i),
                       q.scene->triangleOf(RTCHitN_geomID(arguments->hit, arguments->N, i),
                                           RTCHitN_primID(arguments->hit, arguments->N, i)),
                       RTCHitN_u(arguments->hit, arguments->N, i), RTCHitN_v(arguments->hit, arguments->N, i)});
      arguments->valid[i] = 0;  // on to the next surface
    }
  };
  RTCRayHit ray;
  setRay(ray.ray, origin - scene_->origin, direction, std::min(far, leavesAfter(origin, direction)), meets);
  ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  ray.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(scene_->scene, &question.context, &ray);
  const auto key = [](const Met& met) { return std::pair(met.distance, met.triangle); };
  std::sort(question.met.begin(), question.met.end(), [&](const Met& a, const Met& b) { return key(a) < key(b); });
  std::vector<Hit> result;
  for (std::size_t i = 0; i < question.met.size(); ++i)
    if (i == 0 || key(question.met[i]) != key(question.met[i - 1])) result.push_back(hitOf(question.met[i], direction));
  return result;
}

Hit Tracer::hitOf(const Met& met, const Number3& direction) const {
  Hit hit;
  hit.distance = double{met.distance};
  hit.triangle = met.triangle;
  hit.u = double{met.u};
  hit.v = double{met.v};
  // The position is computed from the vertices, not from the ray. So it lies on the triangle's plane up to the rounding
  // of doubles.
  const Triangle& triangle = surfaces().triangle[hit.triangle];
  const Number3 a = scene_->corner(triangle.vertex[0]);
  const Number3 b = scene_->corner(triangle.vertex[1]);
  const Number3 c = scene_->corner(triangle.vertex[2]);
  const Number3 ab = b - a;
  const Number3 ac = c - a;
  hit.position = scene_->origin + (a + ab * hit.u + ac * hit.v);
  const Number3 normal = unit(cross(ab, ac));
  const bool behind = dot(normal, direction) > 0.0;
  hit.normal = behind ? -normal : normal;
  hit.back_along = -direction;
  for (const Number3& p : {a, b, c})
    for (int axis = 0; axis < 3; ++axis) hit.coarsest_m = std::max(hit.coarsest_m, std::abs(p[axis]));
  hit.back = behind && isOneSided(surfaces().material[triangle.material]);
  return hit;
}

bool Tracer::meetsBack(const Number3& origin, const Number3& direction, double far) const {
  const auto met = meet(origin, direction, far, Meets::all);
  if (!met) return false;
  const Triangle& triangle = surfaces().triangle[met->triangle];
  if (!isOneSided(surfaces().material[triangle.material])) return false;
  const Number3 a = scene_->corner(triangle.vertex[0]);
  const Number3 ab = scene_->corner(triangle.vertex[1]) - a;
  const Number3 ac = scene_->corner(triangle.vertex[2]) - a;
  return dot(unit(cross(ab, ac)), direction) > 0.0;
}

bool Tracer::occluded(const Number3& origin, const Number3& direction, double far, Meets meets) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRay ray;
  setRay(ray, origin - scene_->origin, direction, std::min(far, leavesAfter(origin, direction)), meets);
  rtcOccluded1(scene_->scene, &context, &ray);
  return ray.tfar < 0.0F;
}

bool Tracer::isNearer(const Number3& position, double distance_m) const {
  struct Question {
    const Scene* scene;
    Number3 position;
    double distance_m;
    bool is_nearer;
  } question{scene_.get(), position - scene_->origin, distance_m, false};
  const auto ask = [](RTCPointQueryFunctionArguments* arguments) {
    auto& q = *static_cast<Question*>(arguments->userPtr);
    if (q.is_nearer || arguments->geomID >= 2) return false;  // only static geometry counts
    const auto& vertex = q.scene->surfaces->triangle[q.scene->triangleOf(arguments->geomID, arguments->primID)].vertex;
    const auto corner = [&](std::size_t i) { return q.scene->corner(vertex[i]); };
    const Number3 way = nearestPoint(q.position, corner(0), corner(1), corner(2)) - q.position;
    q.is_nearer = dot(way, way) < q.distance_m * q.distance_m;
    return false;
  };
  constexpr float kRounding = 1.0F + 0x1p-20F;  // floats may not hide a triangle that is just nearer
  RTCPointQuery query;
  query.x = static_cast<float>(question.position.x);
  query.y = static_cast<float>(question.position.y);
  query.z = static_cast<float>(question.position.z);
  query.time = 0.0F;
  const double largest =
      std::max({std::abs(question.position.x), std::abs(question.position.y), std::abs(question.position.z)});
  query.radius = static_cast<float>(distance_m + largest * 0x1p-22) * kRounding;
  RTCPointQueryContext context;
  rtcInitPointQueryContext(&context);
  rtcPointQuery(scene_->scene, &query, &context, ask, &question);
  return question.is_nearer;
}

Hit Tracer::pointOn(const Number3& position, const Number3& normal) const {
  constexpr double kOnSurface_m = 0.01;
  Hit hit;
  hit.position = position;
  hit.normal = normal;
  if (const auto under = closest(position + normal * kOnSurface_m, -normal, 2.0 * kOnSurface_m))
    hit.coarsest_m = under->coarsest_m;
  return hit;
}

Number3 Tracer::leaving(const Hit& hit) const {
  constexpr double kLeast_m = 1e-5;
  constexpr double kFloats = 4.0 * 0x1p-23;  // rounding of the origin, and of Embree's robust test
  constexpr double kBack = 8.0;              // clears a wall that stands there, unless the ray came along that wall
  const double off = kLeast_m + kFloats * hit.coarsest_m;
  return hit.position + hit.normal * off + hit.back_along * std::min(kBack * off, 0.5 * hit.distance);
}

Number3 Tracer::beyond(const Hit& hit) const {
  Hit other = hit;
  other.normal = -hit.normal;
  other.back_along = Number3(0.0);
  return leaving(other);
}

bool Tracer::anySeeThrough() const {
  return scene_->any_see_through;
}

}  // namespace welkin::geometry
