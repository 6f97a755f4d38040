// SPDX-License-Identifier: Apache-2.0
// The directions of a replicate's paths: well spread over the sphere, about each bounce's normal and over the lights,
// without a transcendental function a ray.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "probes/transfer/sequence.h"
#include "shared.h"

namespace welkin::transfer {

using f64::Number3;

/// Cosine and sine of the middles of kCircle equal arcs.
struct UnitVector2 {
  double x, y;
};
inline constexpr std::size_t kCircle = 1024;
class CircleTable {
 public:
  CircleTable();
  /// Of a fraction of 2^32 of the circle, to the middle of its arc.
  const UnitVector2& at(std::uint32_t t) const { return point_[t >> 22]; }

 private:
  std::array<UnitVector2, kCircle> point_;
};
static_assert(kCircle == 1U << (32 - 22));

/// Points of one replicate of one probe. Azimuths are those of the table, turned by a random angle of the replicate.
class PathPoints {
 public:
  /// `key`: of sector, probe and replicate; directions for `bounces` bounces. `circle` outlives it.
  PathPoints(const CircleTable& circle, std::uint64_t key, int bounces);

  /// The first direction of path i.
  Number3 onSphere(std::uint32_t i) const;
  /// Its direction after bounce `bounce` = 0..bounces - 1, density cosine / pi about the unit normal.
  Number3 aboutNormal(int bounce, std::uint32_t i, const Number3& normal) const;
  /// Where in the first step of the lights its vertex samples them, in (0, 1).
  double lightOffset(int bounce, std::uint32_t i) const;

 private:
  struct Stream {
    Sequence sequence;
    UnitVector2 turn;
  };
  UnitVector2 azimuth(const Stream& stream, std::uint32_t t) const;
  Stream streamOf(std::uint64_t key) const;

  const CircleTable* circle_;
  Stream first_;
  std::vector<Stream> bounce_;
  std::vector<Sequence> light_;
};

}  // namespace welkin::transfer
