// SPDX-License-Identifier: Apache-2.0
// Vectors, frames and integer hashes of the island's generator. All operations give the same bits on every machine.
#pragma once

#include <cstdint>

#include "sh/deterministic.h"

namespace welkin::island {

using Vec3 = det::Number3;
using Colour = det::Number3;  ///< linear, Rec. 709

inline constexpr double kTau = 6.283185307179586;

inline double length(const Vec3& v) {
  return det::sqrt(dot(v, v));
}

/// `v` must not be zero.
inline Vec3 normalise(const Vec3& v) {
  return v / length(v);
}

inline double mix(double a, double b, double t) {
  return a + (b - a) * t;
}

/// Hermite step from 0 at `low` to 1 at `high`.
inline double smoothStep(double low, double high, double x) {
  const double t = clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

/// The larger of two numbers, smoothed where they differ by less than `width`.
inline double smoothMax(double a, double b, double width) {
  const double overlap = max(width - (a < b ? b - a : a - b), 0.0) / width;
  return max(a, b) + overlap * overlap * width * 0.25;
}

inline double smoothMin(double a, double b, double width) {
  return -smoothMax(-a, -b, width);
}

/// A mixing function of 32 bits (Wellons, "Prospecting for Hash Functions", 2018: lowbias32).
constexpr uint32_t hash(uint32_t x) {
  x ^= x >> 16;
  x *= 0x7feb352dU;
  x ^= x >> 15;
  x *= 0x846ca68bU;
  return x ^ (x >> 16);
}

/// A pseudo-random number in [0, 1) for the pair; the same pair gives the same number.
constexpr double random(uint32_t stream, uint32_t index) {
  return hash(hash(stream) + index) / 4294967296.0;
}

constexpr double random(uint32_t stream, uint32_t index, double low, double high) {
  return low + (high - low) * random(stream, index);
}

/// A rigid frame: origin and axes of a part.
struct Frame {
  Vec3 origin;
  Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};

  Vec3 operator()(const Vec3& p) const { return origin + x * p.x + y * p.y + z * p.z; }
};

/// A frame whose -z looks along the azimuth, clockwise from north.
inline Frame frameAt(const Vec3& origin, double azimuth_rad) {
  const double s = det::sin(azimuth_rad);
  const double c = det::cos(azimuth_rad);
  return {origin, {c, 0, s}, {0, 1, 0}, {-s, 0, c}};
}

/// A frame whose z points along `axis`; its x is horizontal.
inline Frame frameAlong(const Vec3& origin, const Vec3& axis) {
  const Vec3 z = normalise(axis);
  const Vec3 side = cross(Vec3{0, 1, 0}, z);
  const Vec3 x = dot(side, side) > 1e-12 ? normalise(side) : Vec3{1, 0, 0};
  return {origin, x, cross(z, x), z};
}

}  // namespace welkin::island
