// SPDX-License-Identifier: Apache-2.0
// Directions for the paths of a replicate: well spread over the sphere, about each bounce's normal and over the lights.
// They need no transcendental function per ray.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "probes/geometry/random.h"
#include "probes/transfer/sequence.h"
#include "shared.h"

namespace welkin::transfer {

using f64::Number3;

/// Cosine and sine of the middle of one of kCircle equal arcs.
struct UnitVector2 {
  double x, y;
};
inline constexpr std::size_t kCircle = 1024;
class CircleTable {
 public:
  CircleTable();
  /// The middle of the arc that holds the fraction t / 2^32 of the circle.
  const UnitVector2& at(std::uint32_t t) const { return point_[t >> 22]; }

 private:
  std::array<UnitVector2, kCircle> point_;
};
static_assert(kCircle == 1U << (32 - 22));

/// Points of one replicate of one probe. Azimuths come from the table and are turned by a random angle of the
/// replicate.
class PathPoints {
 public:
  /// `key` combines sector, probe and replicate. There are directions for `bounces` bounces. `circle` must outlive the
  /// object.
  PathPoints(const CircleTable& circle, std::uint64_t key, int bounces);

  /// The first direction of path i.
  Number3 onSphere(std::uint32_t i) const;
  /// Direction of path i after bounce 0..bounces - 1, with density cosine / pi about the unit normal.
  Number3 aboutNormal(int bounce, std::uint32_t i, const Number3& normal) const;
  /// Offset, in (0, 1), of the vertex's light samples within the first step of the lights.
  double lightOffset(int bounce, std::uint32_t i) const;
  /// Random numbers of path i, for surfaces that it may pass or not.
  geometry::Random choicesOf(std::uint32_t i) const { return geometry::Random(choices_, i); }

 private:
  struct Stream {
    Sequence sequence;
    UnitVector2 turn;
  };
  UnitVector2 azimuth(const Stream& stream, std::uint32_t t) const;
  Stream streamOf(std::uint64_t key) const;

  const CircleTable* circle_;
  Stream first_;
  std::uint64_t choices_;
  std::vector<Stream> bounce_;
  std::vector<Sequence> light_;
};

}  // namespace welkin::transfer
