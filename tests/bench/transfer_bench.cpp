// SPDX-License-Identifier: Apache-2.0
// The cost of tracing the transfer beside its physical limit: a bare Embree loop over the same rays, on one thread.
//   transfer_bench [PROBES [PATHS [BOUNCES]]]
#include <embree3/rtcore.h>
#include <fmt/format.h>

#include <chrono>
#include <cstdlib>
#include <limits>

#include "probes/build/bake_section.h"
#include "probes/geometry/directions.h"
#include "probes/transfer/probe_paths.h"
#include "town.h"

namespace {

using namespace welkin;

struct Ray {
  std::array<float, 3> origin, direction;
  float far;
  bool occluded;
};

/// A tracer that records its rays.
class Recorder {
 public:
  explicit Recorder(const geometry::Tracer& tracer) : tracer_(tracer) {}
  std::optional<geometry::Hit> closest(const f64::Number3& o, const f64::Number3& d, double far,
                                       geometry::Meets meets = geometry::Meets::all) const {
    note(o, d, far, false);
    return tracer_.closest(o, d, far, meets);
  }
  bool occluded(const f64::Number3& o, const f64::Number3& d, double far) const {
    note(o, d, far, true);
    return tracer_.occluded(o, d, far);
  }
  f64::Number3 leaving(const geometry::Hit& hit) const { return tracer_.leaving(hit); }
  f64::Number3 beyond(const geometry::Hit& hit) const { return tracer_.beyond(hit); }
  f64::Number3 passing(const geometry::Hit& hit) const { return tracer_.passing(hit); }
  bool anySeeThrough() const { return tracer_.anySeeThrough(); }
  f64::Number3 albedo(const geometry::Hit& hit) const { return tracer_.albedo(hit); }
  f64::Number3 emission(const geometry::Hit& hit) const { return tracer_.emission(hit); }
  const std::vector<Ray>& ray() const { return ray_; }

 private:
  void note(const f64::Number3& o, const f64::Number3& d, double far, bool occluded) const {
    const auto narrow = [](const f64::Number3& v) {
      return std::array{static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
    };
    far = std::min(std::min(far, tracer_.leavesAfter(o, d)), double{std::numeric_limits<float>::max()});
    ray_.push_back({narrow(o), narrow(d), static_cast<float>(far), occluded});
  }
  const geometry::Tracer& tracer_;
  mutable std::vector<Ray> ray_;
};

RTCScene bareScene(RTCDevice device, const geometry::Surfaces& s) {
  RTCScene scene = rtcNewScene(device);
  rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
  rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_HIGH);
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* vertex = static_cast<float*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12, s.position.size()));
  for (const auto& p : s.position) vertex = std::copy(p.begin(), p.end(), vertex);
  auto* index = static_cast<std::uint32_t*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, s.triangle.size()));
  for (const auto& t : s.triangle) index = std::copy(t.vertex.begin(), t.vertex.end(), index);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(scene);
  return scene;
}

std::size_t bareLoop(RTCScene scene, const std::vector<Ray>& rays) {
  std::size_t hits = 0;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  for (const Ray& r : rays) {
    RTCRayHit ray;
    ray.ray = {r.origin[0], r.origin[1], r.origin[2], 0.0F, r.direction[0], r.direction[1], r.direction[2], 0.0F,
               r.far,       ~0U,         0,           0};
    if (r.occluded) {
      rtcOccluded1(scene, &context, &ray.ray);
      hits += ray.ray.tfar < 0.0F ? 1 : 0;
    } else {
      ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
      ray.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
      rtcIntersect1(scene, &context, &ray);
      hits += ray.hit.geomID != RTC_INVALID_GEOMETRY_ID ? 1 : 0;
    }
  }
  return hits;
}

template <typename Work>
double seconds(const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

int main(int argc, char** argv) {
  const auto number = [&](int i, int otherwise) { return argc > i ? std::atoi(argv[i]) : otherwise; };
  const int count = number(1, 100);
  transfer::TransferSettings settings;
  settings.rays = static_cast<std::size_t>(number(2, 1024));
  settings.bounces = number(3, 2);
  settings.reach_m = build::TransferSection{}.reach_m;
  constexpr int kLights = 24;
  for (int i = 0; i < kLights; ++i) {
    const double hour = det::kPi * (i + 0.5) / kLights;
    settings.light_directions.push_back(
        geometry::unit(f64::Number3(std::cos(hour), std::sin(hour), 0.3 * std::sin(hour))));
  }
  const geometry::Surfaces surfaces = bench::town();
  const geometry::Tracer tracer(surfaces);
  const std::vector<f64::Number3> position = bench::probesIn(tracer, count);
  const transfer::TransferTracer transfer(tracer, settings);
  const transfer::CircleTable circle;
  RTCDevice device = rtcNewDevice(fmt::format("isa={},hugepages=0", geometry::Tracer::kIsa).c_str());
  RTCScene scene = bareScene(device, surfaces);

  double traced = 0.0;
  double bare = 0.0;
  std::uint64_t rays = 0;
  std::size_t hits = 0;
  double error = 0.0;
  for (std::size_t i = 0; i < position.size(); ++i) {
    const geometry::Tracer seen = tracer.within(position[i], settings.reach_m);
    const Recorder recorder(seen);
    transfer::traceProbe(recorder, settings, circle, {}, position[i], {0, 0}, i);
    // One right after the other, so that other work on the machine slows both.
    bare += seconds([&] { hits += bareLoop(scene, recorder.ray()); });
    traced += seconds([&] {
      const transfer::TracedProbe probe = transfer.trace(position[i], {0, 0}, i);
      rays += probe.effort.rays;
      error += probe.effort.error;
    });
  }
  const auto n = static_cast<double>(position.size());
  fmt::print("{} probes, {} paths of {} bounces, {} triangles, {:.3g} rays a probe, {:.0f} % hit\n", position.size(),
             settings.rays, settings.bounces, surfaces.triangle.size(), static_cast<double>(rays) / n,
             100.0 * static_cast<double>(hits) / static_cast<double>(rays));
  fmt::print("traced {:.2f} M rays/s, bare Embree {:.2f} M rays/s: {:.0f} % of the time is Embree's\n",
             static_cast<double>(rays) / traced * 1e-6, static_cast<double>(rays) / bare * 1e-6, 100.0 * bare / traced);
  fmt::print("3570 probes: {:.1f} s on one thread; mean error (95 %) {:.2f} %\n", traced / n * 3570.0,
             100.0 * error / n);
  rtcReleaseScene(scene);
  rtcReleaseDevice(device);
  return EXIT_SUCCESS;
}
