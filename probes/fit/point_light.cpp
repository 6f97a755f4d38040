// SPDX-License-Identifier: Apache-2.0
#include "probes/fit/point_light.h"

#include <algorithm>
#include <cmath>

namespace welkin::fit {
namespace {

/// Sums what cosine-distributed paths find. Radiance times pi is irradiance.
class PointSink {
 public:
  PointSink(const TrainingSkies& skies, const transfer::TransferSettings& settings, const transfer::OwnLight& own)
      : skies_(skies), settings_(settings), own_(own), expected_(skies.count(), 0.0) {
    light_.sky.assign(skies.count(), Number3(0.0));
    light_.sun.assign(settings.light_directions.size(), Number3(0.0));
  }

  /// Notes the light that a first direction has in the open.
  void begin(const Number3& first) {
    Half& half = first.y > 0.0 ? above_ : below_;
    ++half.paths;
    if (first.y <= 0.0) return;
    const auto radiance = skies_.radiance(first);
    for (std::size_t l = 0; l < radiance.size(); ++l) expected_[l] += radiance[l];
  }
  void open(const Number3& direction, const Number3& share) {
    above_.open += (share.x + share.y + share.z) / 3.0;
    sky(direction, share);
  }
  void sky(const Number3& direction, const Number3& throughput) {
    const auto radiance = skies_.radiance(direction);
    for (std::size_t l = 0; l < radiance.size(); ++l) light_.sky[l] += throughput * radiance[l];
  }
  void openPlane(const Number3& share) {
    below_.open += (share.x + share.y + share.z) / 3.0;
    plane(share);
  }
  /// Ground of horizontal irradiance 1 under every sky.
  void plane(const Number3& throughput) {
    const Number3 reflected = throughput * settings_.ground_albedo / det::kPi;
    for (Number3& e : light_.sky) e += reflected;
    for (std::size_t i = 0; i < light_.sun.size(); ++i)
      light_.sun[i] += reflected * std::max(settings_.light_directions[i].y, 0.0);
    light_.emitted += throughput * own_.plane_radiance;
  }
  void emitted(const Number3& radiance) { light_.emitted += radiance; }
  void light(std::size_t index, const Number3& radiance) { light_.sun[index] += radiance; }

  /// The irradiance, after `paths` paths. Directions in the open are integrated instead of drawn, by the share of them
  /// that is open. So nothing is noisy in the open, and nothing is lit that no path lights.
  PointLight finish(const Number3& normal, std::uint32_t paths) {
    const double each = det::kPi / paths;
    for (auto* sums : {&light_.sky, &light_.sun})
      for (Number3& e : *sums) e = e * each;
    light_.emitted = light_.emitted * each;
    const std::vector<double> whole = skies_.irradiance(normal);
    for (std::size_t l = 0; l < whole.size(); ++l)
      light_.sky[l] += Number3(above_.share() * (whole[l] - each * expected_[l]));
    if (settings_.bounces > 0)
      plane(Number3(below_.share() * (det::kPi * 0.5 * (1.0 - normal.y) - each * below_.paths)));
    return light_;
  }

 private:
  /// Paths whose first direction is above or below the horizon.
  struct Half {
    double paths = 0.0, open = 0.0;
    double share() const { return paths > 0.0 ? open / paths : 0.0; }
  };

  const TrainingSkies& skies_;
  const transfer::TransferSettings& settings_;
  const transfer::OwnLight& own_;
  Half above_, below_;
  std::vector<double> expected_;  ///< sums of the radiance of first directions, by sky
  PointLight light_;
};

}  // namespace

PointLight PointTracer::trace(const FitPoint& point, std::size_t index, std::uint32_t paths) const {
  constexpr std::uint64_t kKey = 0x66697470;  // other numbers than the probes' own
  const transfer::OwnLight own = transfer::ownLightAt(tracer_, settings_, emissive_, point.position);
  const geometry::Tracer near = tracer_.within(point.position, settings_.reach_m);
  const Number3 origin = near.leaving(near.pointOn(point.position, point.normal));
  const transfer::PathPoints points(circle_, geometry::Random(kKey, index).next(), settings_.bounces + 1);
  PointSink sink(skies_, settings_, own);
  transfer::Paths<geometry::Tracer, PointSink> trace(near, settings_, own, sink);
  for (std::uint32_t i = 0; i < paths; ++i) {
    const Number3 first = points.aboutNormal(0, i, point.normal);
    sink.begin(first);
    trace.trace(origin, first, points, i, 1);
  }
  PointLight light = sink.finish(point.normal, paths);
  light.rays = trace.rayCount();
  return light;
}

}  // namespace welkin::fit
