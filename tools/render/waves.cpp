// SPDX-License-Identifier: Apache-2.0
// The waves of the sea.
#include "render/waves.h"

#include <cmath>

#include "shared.h"

namespace welkin::render {
namespace {

constexpr double kGravity = 9.81;      // m/s2
constexpr double kLongest = 19.0;      // metres
constexpr double kShortest = 0.27;     // metres
constexpr double kSlope = 0.016;       // Slope of every wave. Their variance is 24 / 4 kSlope^2 along either axis.
constexpr double kWindAzimuth = 4.45;  // Direction in which the waves run: west, radians clockwise from north.
constexpr double kSpread = 0.9;        // Spread of the directions to either side, radians.
constexpr double kGolden = 0.6180339887498949;

}  // namespace

std::array<std::array<float, 4>, WELKIN_WAVE_COUNT> wavesAt(double time_h) {
  std::array<std::array<float, 4>, WELKIN_WAVE_COUNT> waves{};
  for (std::size_t i = 0; i < waves.size(); ++i) {
    const double share = (static_cast<double>(i) + 0.5) / static_cast<double>(waves.size());
    const double length = kLongest * std::pow(kShortest / kLongest, share);
    const double k = f64::kTwoPi / length;
    const double turn = std::fmod(static_cast<double>(i) * kGolden, 1.0);  // Spread evenly, with unequal neighbours.
    const double azimuth = kWindAzimuth + kSpread * (2.0 * turn - 1.0);
    const double start = f64::kTwoPi * std::fmod(static_cast<double>(i * i) * kGolden, 1.0);
    const double phase = std::fmod(start - std::sqrt(kGravity * k) * time_h * 3600.0, f64::kTwoPi);
    waves[i] = {static_cast<float>(k * std::sin(azimuth)), static_cast<float>(-k * std::cos(azimuth)),
                static_cast<float>(kSlope), static_cast<float>(phase)};
  }
  return waves;
}

}  // namespace welkin::render
