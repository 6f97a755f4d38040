// SPDX-License-Identifier: Apache-2.0
#include "probes/transfer/path_points.h"

#include <cmath>

#include "probes/geometry/directions.h"
#include "sh/deterministic.h"

namespace welkin::transfer {
namespace {

/// Streams of a replicate: one for the first direction, one for choices, then two for each bounce.
enum : std::uint64_t { kFirst = 0, kBounce = 1, kLight = 2, kChoices = 3 };

std::uint64_t keyOf(std::uint64_t key, std::uint64_t stream, int bounce) {
  return geometry::mixed(geometry::mixed(key ^ stream) ^ static_cast<std::uint64_t>(bounce));
}

}  // namespace

CircleTable::CircleTable() {
  for (std::size_t i = 0; i < kCircle; ++i) {
    const double angle = det::kTwoPi * ((static_cast<double>(i) + 0.5) / double{kCircle});
    point_[i] = {det::cos(angle), det::sin(angle)};
  }
}

PathPoints::PathPoints(const CircleTable& circle, std::uint64_t key, int bounces)
    : circle_(&circle), first_(streamOf(keyOf(key, kFirst, 0))), choices_(keyOf(key, kChoices, 0)) {
  for (int i = 0; i < bounces; ++i) {
    bounce_.push_back(streamOf(keyOf(key, kBounce, i)));
    light_.emplace_back(keyOf(key, kLight, i));
  }
}

PathPoints::Stream PathPoints::streamOf(std::uint64_t key) const {
  geometry::Random random(key);
  const double angle = det::kTwoPi * random.unit();
  return {Sequence(key), {det::cos(angle), det::sin(angle)}};
}

UnitVector2 PathPoints::azimuth(const Stream& stream, std::uint32_t t) const {
  const UnitVector2& p = circle_->at(t);
  const UnitVector2& q = stream.turn;
  return {p.x * q.x - p.y * q.y, p.x * q.y + p.y * q.x};
}

Number3 PathPoints::onSphere(std::uint32_t i) const {
  const Sequence::Point point = first_.sequence.point(i);
  const UnitVector2 at = azimuth(first_, point.t);
  const double y = 1.0 - 2.0 * fractionOf(point.s);
  const double across = det::sineFromCosine(y);
  return {across * at.y, y, across * at.x};
}

Number3 PathPoints::aboutNormal(int bounce, std::uint32_t i, const Number3& normal) const {
  const Stream& stream = bounce_[static_cast<std::size_t>(bounce)];
  const Sequence::Point point = stream.sequence.point(i);
  const UnitVector2 at = azimuth(stream, point.t);
  const double s = fractionOf(point.s);
  const double radius = std::sqrt(s);
  return geometry::inFrameOf(normal, radius * at.x, radius * at.y, std::sqrt(1.0 - s));
}

double PathPoints::lightOffset(int bounce, std::uint32_t i) const {
  return fractionOf(light_[static_cast<std::size_t>(bounce)].value(i));
}

}  // namespace welkin::transfer
