// SPDX-License-Identifier: Apache-2.0
// Helpers that the tests of the transfer share: means with standard errors over independent probes at one place.
#pragma once

#include <catch2/catch.hpp>
#include <cmath>

#include "probes/geometry/directions.h"
#include "probes/transfer/trace_transfer.h"
#include "sh/deterministic.h"

namespace welkin::tests {

inline constexpr std::size_t kProbes = 32;  ///< independent probes for a standard error

inline transfer::TransferSettings settingsOf(int bounces, std::size_t rays = 256) {
  transfer::TransferSettings settings;
  settings.bounces = bounces;
  settings.rays = rays;
  return settings;
}

struct Measured {
  double mean = 0.0;
  double standard_error = 0.0;
};

/// Measures a quantity of `count` probes with separate random numbers at one position.
template <typename ProbeTracer, typename Quantity>
Measured measured(const ProbeTracer& tracer, const Number3& position, std::size_t count, const Quantity& quantity) {
  double sum = 0.0;
  double squares = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const double value = quantity(tracer.trace(position, {3, -2}, i));
    sum += value;
    squares += value * value;
  }
  const double n = static_cast<double>(count);
  const double mean = sum / n;
  return {mean, std::sqrt(std::max(squares / n - mean * mean, 0.0) / (n - 1.0))};
}

/// Allows three standard errors (one in 370 misses; the seeds are fixed) plus `bound` for rounding and the level's
/// floats.
inline void checkMeasured(const Measured& m, double expected, double bound = 1e-5) {
  CAPTURE(m.mean, m.standard_error, expected);
  CHECK(std::abs(m.mean - expected) <= 3.0 * m.standard_error + bound);
}

/// Irradiance under a uniform sky of radiance 1, direct and bounced, green.
inline double uniformSky(const transfer::ProbeTransfer& t, std::size_t b) {
  const double open = det::kPi * (1.0 + transfer::transferBasis()[b].y) / 2.0;
  return t.visibility[b] * open + t.sky[b][0].y / det::kShConstant;
}

/// Reconstruction from four directions for a normal.
inline double reconstructed(const Number3& normal, const std::array<double, transfer::kDirections>& irradiance) {
  const auto weight = transfer::shadingWeights(normal);
  double sum = 0.0;
  for (std::size_t b = 0; b < weight.size(); ++b) sum += weight[b] * irradiance[b];
  return sum;
}

/// The direction of (azimuth, elevation) in radians: away from the point, azimuth clockwise from north.
inline Number3 towards(double azimuth, double elevation) {
  return geometry::unit(
      Number3(std::cos(elevation) * std::sin(azimuth), std::sin(elevation), -std::cos(elevation) * std::cos(azimuth)));
}

}  // namespace welkin::tests
