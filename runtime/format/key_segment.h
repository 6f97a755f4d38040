// SPDX-License-Identifier: Apache-2.0
// Piecewise linear interpolation over the time of day, periodic. Bakes and the runtime share it.
#pragma once

#include <cstddef>
#include <span>

namespace welkin::format {

inline constexpr double kDay_h = 24.0;

/// A finite time in hours, wrapped into [0, 24).
double wrapOutside(double time_h);
inline double wrapTime(double time_h) {
  return time_h >= 0.0 && time_h < kDay_h ? time_h : wrapOutside(time_h);
}

/// The two keys around a time: value = (1 - weight) value[first] + weight value[second], weight in [0, 1).
struct KeySegment {
  std::size_t first;
  std::size_t second;
  double weight;
};

/// Finds the keys around a time. `key_time_h`: at least one key, strictly ascending, in [0, 24). After the last key
/// follows the first, on the next day.
KeySegment findSegment(std::span<const double> key_time_h, double time_h);

/// Interpolates between keys of `components` numbers each, key-major in `value`. Writes `components` numbers to `out`.
void interpolate(std::span<const double> key_time_h, std::span<const double> value, double time_h,
                 std::span<double> out);

/// Interpolates angles in radians the short way round; keys half a turn apart go clockwise (growing azimuth).
double interpolateAngle(double first_rad, double second_rad, double weight);

/// A direction as two angles.
struct SkyAngles {
  double azimuth_rad;
  double elevation_rad;
};
/// The angles of a light whose path was drawn by hand. The three spans hold one number per key.
SkyAngles interpolatePath(std::span<const double> key_time_h, std::span<const double> azimuth_rad,
                          std::span<const double> elevation_rad, double time_h);

/// Whether there is at least one time, and all are finite, strictly ascending and in [0, 24).
bool areKeyTimes(std::span<const double> key_time_h);

}  // namespace welkin::format
