// SPDX-License-Identifier: Apache-2.0
// What an artist may not have meant by a hand-drawn path: a light that never rises, or that lies on the horizon for
// hours because no key takes it below.
#pragma once

#include <string>
#include <vector>

#include "sky/model/light.h"

namespace welkin::model {

/// Where a light stands highest over the day.
struct Culmination {
  double time_h;         ///< [0, 24); the first, where several are as high
  double elevation_rad;  ///< [-pi/2, pi/2]; negative: it never rises
};

/// Of a frozen declination d at latitude l, pi/2 - |l - d| at the transit; by hand the highest key, as elevation is
/// linear between keys.
Culmination culminationOf(const LightPath& path);

/// A time along which a hand-drawn path stays within kHorizonBand of the horizon.
struct HorizonStretch {
  double from_h;    ///< [0, 24), a key
  double length_h;  ///< more than kLongestOnHorizon, less than 24
};

inline constexpr double kHorizonBand_deg = 0.5;     ///< about a disc's diameter
inline constexpr double kLongestOnHorizon_h = 1.0;  ///< between two keys; a rising or setting light takes minutes

/// Stretches between consecutive keys that are both within the band and more than kLongestOnHorizon apart, neighbours
/// joined. None for a place, where it is how a polar sun stands, and none when every key is in the band: a light that
/// is never anywhere else is meant.
std::vector<HorizonStretch> horizonStretchesOf(const LightPath& path);

/// Something valid that is likely a mistake.
struct Warning {
  std::string id;         ///< for machines
  std::size_t count = 1;  ///< how many of it
  std::string message;
};

/// Warnings of the path of `light`, "sun" or "moon": "never-rises" and "on-horizon"; none for a place, whose polar
/// night is no mistake.
std::vector<Warning> pathWarningsOf(const LightPath& path, const std::string& light);

}  // namespace welkin::model
