// SPDX-License-Identifier: Apache-2.0
#include "probes/build/level_hints.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "probes/geometry/directions.h"
#include "probes/geometry/tracer.h"

namespace welkin::build {
namespace {

using f64::Number3;

struct Extent {
  Number3 low{std::numeric_limits<double>::infinity()};
  Number3 high{-std::numeric_limits<double>::infinity()};

  void add(const Number3& p) {
    for (int i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], p[i]);
      high[i] = std::max(high[i], p[i]);
    }
  }
  void add(const Extent& e) {
    if (!(e.low.x <= e.high.x)) return;
    add(e.low);
    add(e.high);
  }
};

Number3 cornerOf(const geometry::Surfaces& s, const geometry::Triangle& t, std::size_t i) {
  const auto& p = s.position[t.vertex[i]];
  return {double{p[0]}, double{p[1]}, double{p[2]}};
}

bool isFixed(const geometry::Surfaces& s, const geometry::Triangle& t) {
  return s.object[t.object].role == geometry::Role::fixed;
}

/// Whether the outer box exceeds the inner one by a tenth of its extent to the four sides and above.
bool encloses(const Extent& outer, const Extent& inner) {
  constexpr double kShare = 0.1;
  const Number3 size = inner.high - inner.low;
  const double room = kShare * std::max({size.x, size.y, size.z});
  return size.x >= 0.0 && outer.low.x + room <= inner.low.x && outer.low.z + room <= inner.low.z &&
         inner.high.x + room <= outer.high.x && inner.high.z + room <= outer.high.z &&
         inner.high.y + room <= outer.high.y;
}

/// Share of the rays upward from a point that an object stops, both its sides counted.
double shareStopped(const geometry::Surfaces& level, std::uint32_t object, const Number3& from) {
  constexpr int kRays = 64;
  geometry::Surfaces alone = level;
  std::erase_if(alone.triangle, [&](const geometry::Triangle& t) { return t.object != object; });
  const geometry::Tracer tracer(alone);
  int stopped = 0;
  for (int i = 0; i < kRays; ++i) {
    constexpr double kGolden = 0.6180339887498949;
    const double turn = i * kGolden;
    const Number3 direction = geometry::sphereDirection((i + 0.5) / (2.0 * kRays), turn - std::floor(turn));
    stopped += tracer.occluded(from, direction, std::numeric_limits<double>::infinity()) ? 1 : 0;
  }
  return static_cast<double>(stopped) / kRays;
}

}  // namespace

std::optional<std::string> domeAround(const geometry::Surfaces& level) {
  constexpr double kHidden = 0.9;
  std::vector<Extent> of(level.object.size());
  for (const geometry::Triangle& t : level.triangle)
    for (std::size_t i = 0; i < 3; ++i) of[t.object].add(cornerOf(level, t, i));
  // Only the widest object may enclose all others.
  std::uint32_t widest = 0;
  const auto width = [&](std::uint32_t o) { return of[o].high.x - of[o].low.x; };
  for (std::uint32_t o = 1; o < of.size(); ++o)
    if (width(o) > width(widest)) widest = o;
  Extent rest;
  for (std::uint32_t o = 0; o < of.size(); ++o)
    if (o != widest) rest.add(of[o]);
  if (of.empty() || level.object[widest].role != geometry::Role::fixed || !encloses(of[widest], rest))
    return std::nullopt;
  const Number3 middle((rest.low.x + rest.high.x) / 2.0, rest.high.y, (rest.low.z + rest.high.z) / 2.0);
  if (shareStopped(level, widest, middle) < kHidden) return std::nullopt;
  return level.object[widest].name;
}

bool seemsInCentimetres(const geometry::Surfaces& level, std::size_t sectors) {
  constexpr std::size_t kMany = 256;
  constexpr double kLong_m = 30.0;
  if (sectors < kMany) return false;
  std::size_t fixed = 0;
  std::size_t long_ones = 0;
  for (const geometry::Triangle& t : level.triangle) {
    if (!isFixed(level, t)) continue;
    ++fixed;
    for (std::size_t i = 0; i < 3; ++i) {
      const Number3 side = cornerOf(level, t, (i + 1) % 3) - cornerOf(level, t, i);
      if (dot(side, side) < kLong_m * kLong_m) continue;
      ++long_ones;
      break;
    }
  }
  return 2 * long_ones >= fixed;
}

}  // namespace welkin::build
