// SPDX-License-Identifier: Apache-2.0
#include "probes/transfer/local_paths.h"

#include <algorithm>
#include <cmath>

#include "probes/geometry/see_through.h"
#include "sh/deterministic.h"

namespace welkin::transfer {

std::uint64_t traceVertices(const geometry::Tracer& tracer, const Number3& position, const PathPoints& points,
                            std::uint32_t from, std::uint32_t to, int bounces, std::vector<PathVertex>& vertices) {
  std::uint64_t rays = 0;
  for (std::uint32_t i = from; i < to; ++i) {
    const Number3 first = points.onSphere(i);
    Number3 origin = position;
    Number3 direction = first;
    Number3 reflected(1.0 / det::kPi);
    geometry::Random random = points.choicesOf(i);
    for (int bounce = 0; bounce < bounces; ++bounce) {
      ++rays;
      const geometry::Sight sight =
          geometry::lookAlong(tracer, origin, direction, false, [&] { return random.unit(); });
      const auto& hit = sight.hit;
      if (!hit) break;
      reflected = reflected * sight.weight * tracer.albedo(*hit);
      if (reflected == Number3(0.0)) break;
      origin = tracer.leaving(*hit);
      vertices.push_back({origin, hit->normal, reflected, first, points.lightOffset(bounce, i)});
      direction = points.aboutNormal(bounce, i, hit->normal);
    }
  }
  return rays;
}

double unshadowedIrradiance(const Number3& origin, const Number3& normal, const Number3& light, double nearest_m) {
  const Number3 away = light - origin;
  const double cosine = dot(normal, away);
  if (cosine <= 0.0) return 0.0;
  const double squared = dot(away, away);
  return cosine / (std::max(squared, nearest_m * nearest_m) * std::sqrt(squared));
}

bool seesEachOther(const geometry::Tracer& tracer, const Number3& from, const Number3& to) {
  const Number3 away = to - from;
  const double distance = std::sqrt(dot(away, away));
  return distance == 0.0 || !tracer.occluded(from, away / distance, distance);
}

Number3 shareBetween(const geometry::Tracer& tracer, const Number3& from, const Number3& to) {
  const Number3 away = to - from;
  const double distance = std::sqrt(dot(away, away));
  return distance == 0.0 ? Number3(1.0) : geometry::arrivingShare(tracer, from, away / distance, distance);
}

}  // namespace welkin::transfer
