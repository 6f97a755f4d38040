// SPDX-License-Identifier: Apache-2.0
#include "probes/contact/contact_check.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "probes/geometry/random.h"
#include "probes/reference/reference.h"
#include "probes/sectors/level_light.h"
#include "sky/model/projection.h"

namespace welkin::contact {
namespace {

constexpr double kHours_h[] = {2.0, 6.0, 10.0, 14.0, 18.0, 22.0};
constexpr std::size_t kDraws = 32;  ///< a point: most of a level may lie under water, or beyond its probes
constexpr double kNormal95 = 1.959963984540054;
constexpr std::uint64_t kSeed = 0xc2;

/// Squares of a point's error at one hour, without the tracer's variance.
struct Squares {
  double probes = 0.0, contact = 0.0;
};

/// Sums of squares over points.
class Mean {
 public:
  void add(const Squares& s) {
    probes_ += s.probes;
    contact_ += s.contact;
    fourth_ += s.contact * s.contact;
    count_ += 1.0;
  }
  ContactError error() const {
    if (count_ == 0.0) return {};
    const double mean = contact_ / count_;
    const double rms = std::sqrt(std::max(mean, 0.0));
    const double deviation = std::sqrt(std::max(fourth_ / count_ - mean * mean, 0.0) / count_);
    return {std::sqrt(std::max(probes_ / count_, 0.0)), rms, rms > 0.0 ? kNormal95 * deviation / (2.0 * rms) : 0.0};
  }

 private:
  double probes_ = 0.0, contact_ = 0.0, fourth_ = 0.0, count_ = 0.0;
};

}  // namespace

ContactCheck checkContact(const geometry::Tracer& tracer, const model::Sky& sky,
                          const std::vector<sectors::SectorFile>& sectors, const PlacedVertices& vertices,
                          const std::vector<std::uint8_t>& bytes, const CheckSettings& settings,
                          const base::Progress& progress) {
  std::vector<TrianglePoint> points;
  const sectors::LevelLight any(sectors, sky, kHours_h[0]);
  for (const TrianglePoint& p : pointsToCheck(vertices, kDraws * settings.points))
    if (points.size() < settings.points && any.at(p.position, p.normal) && isVisible(tracer, p)) points.push_back(p);
  const base::Progress shown = progress.stage("check", points.size() * std::size(kHours_h));
  ContactCheck check;
  check.points = points.size();
  std::vector<Squares> of_point(points.size());
  for (const double time_h : kHours_h) {
    const sectors::LevelLight light(sectors, sky, time_h);
    const reference::DistantLight distant(sky, time_h);
    const model::SkyInstant instant(sky, time_h);
    const model::SkyProjector projector(sky.luminance, 2, 1e-6);
    const double unit = det::luminanceOf(projector.irradiance(instant, {0, 1, 0}) * instant.intensity());
    std::vector<Squares> now(points.size());
    tbb::parallel_for(std::size_t{0}, points.size(), [&](std::size_t i) {
      const TrianglePoint& p = points[i];
      const auto want = reference::traceReference(
          tracer, distant, {}, p.position, p.normal,
          {settings.paths, settings.bounces, geometry::Random(kSeed, i, std::llround(time_h)).next()});
      const double is = det::luminanceOf(light.at(p.position, p.normal)->total());
      const double deviation = det::luminanceOf(want.total.standard_error);
      const auto square = [&](double value) {
        return (std::pow(value - det::luminanceOf(want.total.value), 2) - deviation * deviation) / (unit * unit);
      };
      double factor = 0.0;
      for (std::size_t c = 0; c < 3; ++c) factor += p.share[c] * bytes[p.vertex[c]] / kSteps;
      now[i] = {square(is), square(factor * is)};
      shown.step();
    });
    shown.check();
    Mean mean;
    for (std::size_t i = 0; i < points.size(); ++i) {
      mean.add(now[i]);
      of_point[i].probes += now[i].probes / std::size(kHours_h);
      of_point[i].contact += now[i].contact / std::size(kHours_h);
    }
    check.hour.emplace_back(time_h, mean.error());
  }
  Mean mean;
  for (const Squares& s : of_point) mean.add(s);
  check.all = mean.error();
  return check;
}

}  // namespace welkin::contact
