// SPDX-License-Identifier: Apache-2.0
// Finds likely mistakes in a hand-drawn path: a light that never rises, or a light that lies on the horizon for hours
// because no key takes it below.
#pragma once

#include <string>
#include <vector>

#include "sky/model/light.h"

namespace welkin::model {

/// The highest point of a light over the day.
struct Culmination {
  double time_h;         ///< [0, 24); the first of several equal highest times
  double elevation_rad;  ///< [-pi/2, pi/2]; negative: it never rises
};

/// For a frozen declination d at latitude l the elevation is pi/2 - |l - d|, at the transit. For a hand-drawn path it
/// is the highest key, because elevation is linear between keys.
Culmination culminationOf(const LightPath& path);

/// A period in which a hand-drawn path stays within kHorizonBand of the horizon.
struct HorizonStretch {
  double from_h;    ///< [0, 24), a key
  double length_h;  ///< more than kLongestOnHorizon, less than 24
};

inline constexpr double kHorizonBand_deg = 0.5;     ///< about a disc's diameter
inline constexpr double kLongestOnHorizon_h = 1.0;  ///< between two keys; a rising or setting light takes minutes

/// Finds stretches between consecutive keys that are both within the band and more than kLongestOnHorizon apart, and
/// joins neighbours. Returns none for a place, since a polar sun does stand there. Returns none when every key is in
/// the band, since the artist then means it.
std::vector<HorizonStretch> horizonStretchesOf(const LightPath& path);

/// A valid setting that is probably a mistake.
struct Warning {
  std::string id;         ///< identifier for programs
  std::size_t count = 1;  ///< number of occurrences
  std::string message;
};

/// Warnings about the path of `light`, "sun" or "moon": "never-rises" and "on-horizon". None for a place, where a polar
/// night is no mistake.
std::vector<Warning> pathWarningsOf(const LightPath& path, const std::string& light);

}  // namespace welkin::model
