// SPDX-License-Identifier: Apache-2.0
#include "probes/geometry/tracer_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

#include "probes/geometry/sector.h"
#include "probes/geometry/surface_at.h"
#include "sky/base/error.h"

namespace welkin::geometry {
namespace {

/// A position as Embree has it, from the origin.
std::array<float, 3> floatsOf(const std::array<double, 3>& position, const Number3& origin) {
  return {static_cast<float>(position[0] - origin.x), static_cast<float>(position[1] - origin.y),
          static_cast<float>(position[2] - origin.z)};
}

Number3 originBelow(const Number3& p) {
  const auto below = [](double v) { return kSector_m * std::floor(v / kSector_m); };
  return {below(p.x), below(p.y), below(p.z)};
}

void passMaskedTexels(const RTCFilterFunctionNArguments* arguments) {
  const auto& part = *static_cast<const TracedPart*>(arguments->geometryUserPtr);
  for (unsigned i = 0; i < arguments->N; ++i) {
    if (arguments->valid[i] == 0) continue;
    const Triangle& triangle = part.surfaces->triangle[part.triangle[RTCHitN_primID(arguments->hit, arguments->N, i)]];
    const Barycentric at(double{RTCHitN_u(arguments->hit, arguments->N, i)},
                         double{RTCHitN_v(arguments->hit, arguments->N, i)});
    const Material& material = part.surfaces->material[triangle.material];
    // Where nothing of a blended surface is there, light need not ask for it.
    const bool any = material.blended && RTCRayN_flags(arguments->ray, arguments->N, i) == kForLight;
    const double cutoff = any ? std::numeric_limits<double>::min() : material.alpha_cutoff;
    if (surfaceAt(*part.surfaces, triangle, at).alpha < cutoff) arguments->valid[i] = 0;
  }
}

[[noreturn]] void refuse(const std::string& what) {
  throw base::Error(base::ExitStatus::file, fmt::format("tracing rays: {}", what));
}

}  // namespace

Tracer::Scene::Scene(const Surfaces& s, const Number3& about) : surfaces(&s), origin(originBelow(about)) {
  static_assert(std::string_view(kIsa) == "avx2", "what the processor is asked for below");
  if (!__builtin_cpu_supports("avx2")) refuse(fmt::format("this processor has no {}", kIsa));
  device = rtcNewDevice(fmt::format("isa={},hugepages=0", kIsa).c_str());
  if (device == nullptr) refuse("no Embree device");
  scene = rtcNewScene(device);
  rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION);
  rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_HIGH);
  part.fill({&s, {}});
  for (std::uint32_t i = 0; i < s.triangle.size(); ++i) {
    const bool masked = s.material[s.triangle[i].material].alpha_cutoff > 0.0;
    any_see_through = any_see_through || s.material[s.triangle[i].material].letsLightThrough();
    const bool fixed = s.object[s.triangle[i].object].role == Role::fixed;
    part[(fixed ? 0 : 2) + (masked ? 1 : 0)].triangle.push_back(i);
  }
  for (unsigned id = 0; id < part.size(); ++id)
    if (!part[id].triangle.empty()) attach(id);
  rtcCommitScene(scene);
  if (const RTCError error = rtcGetDeviceError(device); error != RTC_ERROR_NONE)
    refuse(error == RTC_ERROR_OUT_OF_MEMORY ? "out of memory" : fmt::format("Embree's error {}", int{error}));
}
Tracer::Scene::~Scene() {
  rtcReleaseScene(scene);
  rtcReleaseDevice(device);
}

void Tracer::Scene::attach(unsigned id) {
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* vertex = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                             3 * sizeof(float), surfaces->position.size()));
  auto* index = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), part[id].triangle.size()));
  if (vertex == nullptr || index == nullptr) refuse("out of memory");
  for (const auto& position : surfaces->position) {
    const auto from_origin = floatsOf(position, origin);
    vertex = std::copy(from_origin.begin(), from_origin.end(), vertex);
  }
  for (const std::uint32_t i : part[id].triangle) {
    const auto& corner = surfaces->triangle[i].vertex;
    index = std::copy(corner.begin(), corner.end(), index);
  }
  rtcSetGeometryUserData(geometry, &part[id]);
  rtcSetGeometryMask(geometry, id < 2 ? kFixedMask : kOtherMask);
  if (id % 2 == 1) {
    rtcSetGeometryIntersectFilterFunction(geometry, passMaskedTexels);
    rtcSetGeometryOccludedFilterFunction(geometry, passMaskedTexels);
  }
  rtcCommitGeometry(geometry);
  rtcAttachGeometryByID(scene, geometry, id);
  rtcReleaseGeometry(geometry);
}

Number3 Tracer::Scene::corner(std::uint32_t vertex) const {
  return load(floatsOf(surfaces->position[vertex], origin));
}

Number3 nearestToZero(const Surfaces& s) {
  Number3 nearest(0.0);
  for (std::size_t axis = 0; axis < 3 && !s.position.empty(); ++axis) {
    const auto [low, high] = std::minmax_element(s.position.begin(), s.position.end(),
                                                 [=](const auto& a, const auto& b) { return a[axis] < b[axis]; });
    nearest[static_cast<int>(axis)] = std::clamp(0.0, (*low)[axis], (*high)[axis]);
  }
  return nearest;
}

}  // namespace welkin::geometry
