// SPDX-License-Identifier: Apache-2.0
#include "probes/placement/validity.h"

#include <array>
#include <cmath>

#include "probes/geometry/directions.h"

namespace welkin::placement {
namespace {

constexpr std::size_t kRays = 64;
constexpr auto kMostBackRays = static_cast<std::size_t>(kMostBacks * double{kRays});
constexpr double kFar_m = 64.0;

/// Directions evenly spaced in height, with azimuths by the golden angle.
const std::array<Number3, kRays>& fixedDirections() {
  static const std::array<Number3, kRays> direction = [] {
    std::array<Number3, kRays> result;
    for (std::size_t i = 0; i < kRays; ++i) {
      constexpr double kGolden = 0.6180339887498949;
      const double turn = static_cast<double>(i) * kGolden;
      result[i] = geometry::sphereDirection((static_cast<double>(i) + 0.5) / double{kRays}, turn - std::floor(turn));
    }
    return result;
  }();
  return direction;
}

/// insideGeometry, and adds the rays that it took.
bool isInside(const geometry::Tracer& tracer, const Number3& position, std::size_t& rays) {
  std::size_t backs = 0;
  for (std::size_t left = kRays; left > 0 && backs <= kMostBackRays && backs + left > kMostBackRays; --left) {
    ++rays;
    if (tracer.meetsBack(position, fixedDirections()[left - 1], kFar_m)) ++backs;
  }
  return backs > kMostBackRays;
}

/// A file holds places to a millimetre (transfer/encoding.h), so probes keep this much more.
constexpr double kStored_m = 1e-3;

}  // namespace

Place placeAt(const geometry::Tracer& tracer, const Number3& position, double clearance_m) {
  if (insideGeometry(tracer, position)) return Place::inside;
  return tracer.isNearer(position, clearance_m + kStored_m) ? Place::too_close : Place::free;
}

bool insideGeometry(const geometry::Tracer& tracer, const Number3& position) {
  std::size_t rays = 0;
  return isInside(tracer, position, rays);
}

Search freePlaceNear(const geometry::Tracer& tracer, const Number3& position, double clearance_m,
                     const std::function<bool(const Number3&)>& allowed) {
  Search search;
  const bool inside = isInside(tracer, position, search.rays);
  for (const double distance_m : {0.125, 0.25, 0.5, 0.75, 1.0, 1.5, 2.0})
    for (const Number3& direction : fixedDirections()) {
      const Number3 to = position + direction * distance_m;
      if (!allowed(to) || (!inside && !sees(tracer, position, to))) continue;
      ++search.rays;
      if (tracer.isNearer(to, clearance_m + kStored_m) || isInside(tracer, to, search.rays)) continue;
      search.found = to;
      return search;
    }
  return search;
}

bool sees(const geometry::Tracer& tracer, const Number3& from, const Number3& to) {
  const double distance = distanceOf(from, to);
  return distance == 0.0 || !tracer.occluded(from, (to - from) / distance, distance, geometry::Meets::fixed);
}

double distanceOf(const Number3& a, const Number3& b) {
  const Number3 way = b - a;
  return std::sqrt(dot(way, way));
}

}  // namespace welkin::placement
