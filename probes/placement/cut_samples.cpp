// SPDX-License-Identifier: Apache-2.0
#include "probes/placement/cut_samples.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "probes/geometry/random.h"
#include "probes/placement/validity.h"

namespace welkin::placement {
namespace {

constexpr int kAcross = 4;                 // points of the lattice on each axis
constexpr double kOffFace_m = 5e-3;        // of points beside faces
constexpr std::size_t kMostFaces = 20;     // that get points, the largest
constexpr double kLargeFace_m2 = 1.0;      // a larger one gets more points
constexpr double kOffCorner = 0.06;        // share of the way from a face's corner to its middle
constexpr double kMostSight_m = 48.0;      // between a point and a probe
constexpr std::size_t kMostLookedAt = 24;  // probes of a point, the nearest
constexpr double kMostBetween_m = 32.0;    // between two probes

std::vector<Number3> latticeIn(const geometry::Box& box, std::size_t cell) {
  std::vector<Number3> points;
  geometry::Random random(cell);
  const Number3 step = (box.high - box.low) / double{kAcross};
  for (int k = 0; k < kAcross; ++k)
    for (int j = 0; j < kAcross; ++j)
      for (int i = 0; i < kAcross; ++i) {
        const double x = i + random.unit();
        const double y = j + random.unit();
        const double z = k + random.unit();
        points.push_back(box.low + Number3(step.x * x, step.y * y, step.z * z));
      }
  return points;
}

std::vector<Number3> besideFaces(const geometry::Box& box, const std::vector<CellFace>& faces) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < faces.size(); ++i)
    if (!faces[i].corner.empty()) order.push_back(i);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return faces[a].area_m2 > faces[b].area_m2; });
  order.resize(std::min(order.size(), kMostFaces));
  std::vector<Number3> points;
  for (const std::size_t i : order) {
    const CellFace& face = faces[i];
    Number3 middle(0.0);
    for (const Number3& p : face.corner) middle += p / static_cast<double>(face.corner.size());
    std::vector<Number3> on = {middle};
    for (const Number3& p : face.corner) {
      on.push_back(p + (middle - p) * kOffCorner);
      if (face.area_m2 > kLargeFace_m2) on.push_back(0.5 * (p + middle));
    }
    for (const Number3& p : on)
      for (const double side : {-kOffFace_m, kOffFace_m}) {
        const Number3 off = p + face.normal * side;
        if (geometry::contains(box, off)) points.push_back(off);
      }
  }
  return points;
}

/// The larger of the differences of sky, as a share of the open sky's light, and of lamps, of the brighter ones' light.
double differenceOf(const ProbeLook& a, const ProbeLook& b) {
  double result = 0.0;
  for (std::size_t i = 0; i < a.sky.size(); ++i) {
    result = std::max(result, std::abs(a.sky[i] - b.sky[i]));
    const double most = std::max(a.lamps[i], b.lamps[i]);
    if (most > 0.0) result = std::max(result, std::abs(a.lamps[i] - b.lamps[i]) / most);
  }
  return result;
}

}  // namespace

ProbeSight::ProbeSight(const geometry::Tracer& tracer, const std::vector<geometry::Probe>& probe,
                       const std::vector<ProbeLook>& look, bool lamps_come)
    : probe_(probe), akin_(probe.size() * probe.size(), 0), alike_(akin_), space_(probe.size()) {
  constexpr double kAkin = 0.1, kAlike = 0.5;  // differences of light, of the open sky's and of the brighter lamps'
  constexpr double kOutdoors = 0.3;            // share of the sky's light
  const std::size_t n = probe.size();
  std::vector<std::uint8_t> seen(n * n, 0);
  tbb::parallel_for(std::size_t{0}, n, [&](std::size_t a) {
    for (std::size_t b = a + 1; b < n; ++b)
      if (distanceOf(position(a), position(b)) < kMostBetween_m && placement::sees(tracer, position(a), position(b)))
        seen[a * n + b] = seen[b * n + a] = 1;
  });
  std::iota(space_.begin(), space_.end(), std::size_t{0});
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t b = a + 1; b < n; ++b)
      if (seen[a * n + b] != 0 && space_[a] != space_[b]) {
        const std::size_t from = std::max(space_[a], space_[b]), to = std::min(space_[a], space_[b]);
        std::replace(space_.begin(), space_.end(), from, to);
      }
  const auto isOutdoors = [&](std::size_t a) {
    return std::max({look[a].sky[0], look[a].sky[1], look[a].sky[2]}) > kOutdoors;
  };
  const auto meet = [&](std::size_t a, std::size_t b) {
    for (std::size_t c = 0; c < n; ++c)
      if (seen[a * n + c] != 0 && seen[b * n + c] != 0) return true;
    return false;
  };
  for (std::size_t a = 0; a < n; ++a) {
    akin_[a * n + a] = alike_[a * n + a] = 1;
    for (std::size_t b = a + 1; b < n; ++b) {
      const double difference = differenceOf(look[a], look[b]);
      const bool is_seen = seen[a * n + b] != 0;
      const bool is_akin = is_seen && difference < kAkin;
      const bool is_alike = is_akin || (difference < kAlike && space_[a] == space_[b] && isOutdoors(a) &&
                                        isOutdoors(b) && distanceOf(position(a), position(b)) < kMostBetween_m &&
                                        (is_seen || (!lamps_come && meet(a, b))));
      akin_[a * n + b] = akin_[b * n + a] = is_akin ? 1 : 0;
      alike_[a * n + b] = alike_[b * n + a] = is_alike ? 1 : 0;
    }
  }
}

bool CutSampler::sees(const Number3& from, const Number3& to) const {
  return placement::sees(tracer_, from, to);
}

bool CutSampler::sees(CutSample& sample, std::size_t probe) const {
  std::uint8_t& answer = sample.sees[probe];
  if (answer == 0) answer = sees(sample.position, sight_.position(probe)) ? 2 : 1;
  return answer == 2;
}

std::vector<std::size_t> CutSampler::probesNear(const Number3& place) const {
  std::vector<std::pair<double, std::size_t>> near;
  for (std::size_t i = 0; i < sight_.size(); ++i) {
    const double distance_m = distanceOf(place, sight_.position(i));
    if (distance_m < kMostSight_m) near.emplace_back(distance_m, i);
  }
  const std::size_t kept = std::min(kMostLookedAt, near.size());
  std::partial_sort(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(kept), near.end());
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < kept; ++i) result.push_back(near[i].second);
  return result;
}

std::optional<std::size_t> CutSampler::nearestSeen(const Number3& from, const std::vector<std::size_t>& near,
                                                   std::vector<std::uint8_t>* sees) const {
  std::array<std::pair<double, std::size_t>, kMostLookedAt> order;
  for (std::size_t i = 0; i < near.size(); ++i) order[i] = {distanceOf(from, sight_.position(near[i])), near[i]};
  for (std::size_t i = 0; i < near.size(); ++i) {
    std::nth_element(order.begin() + static_cast<std::ptrdiff_t>(i), order.begin() + static_cast<std::ptrdiff_t>(i),
                     order.begin() + static_cast<std::ptrdiff_t>(near.size()));
    const auto [distance_m, probe] = order[i];
    const bool seen = placement::sees(tracer_, from, sight_.position(probe));
    if (sees != nullptr) (*sees)[probe] = seen ? 2 : 1;
    if (seen) return probe;
    if (i > 0 || !(distance_m > 0.0)) continue;
    // Behind a one-sided surface there is no place for a point.
    const Number3 direction = (sight_.position(probe) - from) / distance_m;
    const auto hit = tracer_.closest(from, direction, distance_m, geometry::Meets::fixed);
    if (hit && hit->back) return std::nullopt;
  }
  return std::nullopt;
}

bool CutSampler::fits(CutSample& sample, std::size_t probe) const {
  if (sight_.alike(sample.nearest, probe) || sees(sample, probe)) return true;
  constexpr double kFar_m = 8.0;  // placement's coverage: in a room, a probe is nearer
  return sample.distance_m > kFar_m && sight_.joined(sample.nearest, probe) &&
         distanceOf(sample.position, sight_.position(probe)) < sample.distance_m;
}

std::vector<CutSample> CutSampler::samplesOf(std::size_t cell, const geometry::Box& box,
                                             const std::vector<CellFace>& faces,
                                             const std::vector<std::size_t>& near) const {
  std::vector<Number3> points = latticeIn(box, cell);
  const std::vector<Number3> beside = besideFaces(box, faces);
  points.insert(points.end(), beside.begin(), beside.end());
  std::vector<CutSample> samples;
  for (const Number3& p : points) {
    if (geometry::sectorAt(p) != id_) continue;
    std::vector<std::uint8_t> sees(sight_.size(), 0);
    const auto nearest = nearestSeen(p, near, &sees);
    if (nearest) samples.push_back({p, *nearest, distanceOf(p, sight_.position(*nearest)), std::move(sees), 0, 0});
  }
  return samples;
}

}  // namespace welkin::placement
