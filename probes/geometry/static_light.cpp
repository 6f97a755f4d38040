// SPDX-License-Identifier: Apache-2.0
#include "probes/geometry/static_light.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sh/deterministic.h"

namespace welkin::geometry {
namespace {

using det::Number;
#define INLINE inline
#define NUMBER(literal) Number(literal)
#include "punctual_light.glsl"  // NOLINT(bugprone-suspicious-include)
#undef NUMBER
#undef INLINE

}  // namespace

LightArriving arrivingAt(const StaticLight& light, const Number3& point, const Number3& normal) {
  LightArriving arriving;
  if (light.directional) {
    const double cosine = -dot(normal, light.axis);
    if (cosine <= 0.0) return arriving;
    return {light.intensity * cosine, -light.axis, std::numeric_limits<double>::infinity()};
  }
  const Number3 away = light.position - point;
  const double along = dot(normal, away);
  if (along <= 0.0) return arriving;
  const double squared = dot(away, away);
  const double distance = std::sqrt(squared);
  const Number3 direction = away / distance;
  const double share = rangeShare(squared, light.inverse_range4) *
                       coneShare(-dot(light.axis, direction), light.cone_scale, light.cone_offset);
  if (share == 0.0) return arriving;
  return {light.intensity * (share * along / (squared * distance)), direction, distance};
}

Number3 onOpenGround(std::span<const StaticLight> lights) {
  Number3 sum(0.0);
  for (const StaticLight& light : lights)
    if (light.directional) sum += arrivingAt(light, Number3(0.0), {0, 1, 0}).irradiance;
  return sum;
}

void setCone(StaticLight& light, double inner_rad, double outer_rad) {
  constexpr double kLeast = 0.001;  // of the specification's example, against a division by zero
  const double outer = det::cos(outer_rad);
  light.cone_scale = 1.0 / std::max(kLeast, det::cos(inner_rad) - outer);
  light.cone_offset = -outer * light.cone_scale;
}

}  // namespace welkin::geometry
