// SPDX-License-Identifier: Apache-2.0
#include "probes/light_shares.h"

#include <algorithm>
#include <cmath>

#include "shared.h"

namespace welkin::probes {
namespace {

using f64::Number;
using f64::Number3;
#define INLINE inline
#define NUMBER(literal) Number(literal)
#include "punctual_light.glsl"  // NOLINT(bugprone-suspicious-include)
#undef NUMBER
#undef INLINE

constexpr std::size_t kNearest = 4;
constexpr double kReach = 1.5;  // of the distance of the fourth nearest
constexpr double kOutside = 1.0 / 16.0;

/// The virtual lights that see a lamp, nearest first. The last one that there is room for only ends the reach.
struct SeenLights {
  NearLight light[kMostShares + 1];
  std::size_t count = 0;

  double reach() const {
    const double fourth = kReach * light[std::min(kNearest, count) - 1].distance_m;
    return count > kMostShares ? std::min(fourth, light[kMostShares].distance_m) : fourth;
  }
  /// Whether lights from this distance on take no share.
  bool endsAt(double distance_m) const { return count > kMostShares || (count >= kNearest && distance_m >= reach()); }
};

bool sees(const Sight& sight, const NearLight& from, const float to[3]) {
  if (sight.sees == nullptr) return true;
  const float place[3] = {static_cast<float>(from.place[0]), static_cast<float>(from.place[1]),
                          static_cast<float>(from.place[2])};
  return sight.sees(sight.user, place, to) != 0;
}

SeenLights seenBy(const LightTable& table, const Sight& sight, const float position[3]) {
  constexpr std::size_t kAtOnce = 24;
  const Place place = {double{position[0]}, double{position[1]}, double{position[2]}};
  SeenLights seen;
  NearLight near[kAtOnce], last;
  for (const NearLight* after = nullptr;; after = &last) {
    const std::size_t count = nearestLights(table, place, after, near);
    for (std::size_t i = 0; i < count; ++i) {
      if (seen.endsAt(near[i].distance_m)) return seen;
      if (sees(sight, near[i], position)) seen.light[seen.count++] = near[i];
    }
    if (count < kAtOnce) return seen;
    last = near[kAtOnce - 1];
  }
}

}  // namespace

Cone coneOf(const WelkinPointLight& light) {
  if (light.outer_rad == 0.0F) return {0.0, 1.0, 1.0};
  constexpr double kLeast = 0.001;  // of the specification's example, against a division by zero
  const double inner = std::cos(double{light.inner_rad});
  const double outer = std::min(std::cos(double{light.outer_rad}), inner - kLeast);
  const double width = inner - outer;
  // Within the inner cone the share is 1. Between the two it is ((cosine - outer) / width)^2, as far as cosines go.
  const double beyond = (std::max(outer, -1.0) - outer) / width;
  const double part = (1.0 - inner + width / 3.0 * (1.0 - beyond * beyond * beyond)) / 2.0;
  return {1.0 / width, -outer / width, part};
}

void shareLamp(const LightTable& table, const Sight& sight, Lamp& lamp) {
  const SeenLights seen = seenBy(table, sight, lamp.light.position);
  lamp.shares = static_cast<std::uint32_t>(std::min(seen.count, kMostShares));
  lamp.reach_m = seen.count < kNearest ? kFarthestLight_m : seen.reach();
  if (seen.count == 0) return;
  const Cone cone = coneOf(lamp.light);
  const NearLight& nearest = seen.light[0];
  if (nearest.distance_m == 0.0) {
    lamp.shares = 1;
    lamp.share[0] = {nearest.light, static_cast<float>(cone.part)};
    return;
  }
  const float* p = lamp.light.position;
  const float* axis = lamp.light.direction;
  const double reach = seen.reach();
  double weight[kMostShares], sum = 0.0;
  for (std::size_t i = 0; i < lamp.shares; ++i) {
    const NearLight& l = seen.light[i];
    // Scaled by the nearest distance, so that a tiny distance does not overflow.
    const double root = nearest.distance_m * (1.0 / l.distance_m - 1.0 / reach);
    const double along = (l.place[0] - double{p[0]}) * double{axis[0]} + (l.place[1] - double{p[1]}) * double{axis[1]} +
                         (l.place[2] - double{p[2]}) * double{axis[2]};
    const double within = coneShare(along / l.distance_m, cone.scale, cone.offset);
    weight[i] = root * root * (kOutside + within);
    sum += weight[i];
  }
  for (std::size_t i = 0; i < lamp.shares; ++i) {
    // Only more than kMostShares lights that are all equally far leave a sum of 0.
    const double share = sum > 0.0 ? weight[i] / sum : 1.0 / lamp.shares;
    lamp.share[i] = {seen.light[i].light, static_cast<float>(cone.part * share)};
  }
}

}  // namespace welkin::probes
