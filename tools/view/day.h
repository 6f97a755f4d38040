// SPDX-License-Identifier: Apache-2.0
// The day of a baked sky: its keys, sunrise and sunset, and curves of what changes.
#pragma once

#include <array>
#include <optional>
#include <vector>
#include <welkin/welkin.hpp>

namespace welkin::view {

/// Samples of a curve, evenly over 24 hours from midnight.
inline constexpr std::size_t kDaySamples = 97;

struct Day {
  std::vector<float> key_h;                 ///< keys of the table
  std::vector<double> sunrise_h, sunset_h;  ///< when the sun's middle crosses the horizon, to a second
  /// Of the sky at intensity, tint's luminance, saturation, sun's elevation in degrees, luminance of the irradiance of
  /// level ground by the open sky.
  std::array<float, kDaySamples> intensity{}, tint{}, saturation{}, elevation_deg{}, irradiance{};
};

Day dayOf(const Sky& sky);

}  // namespace welkin::view
