// SPDX-License-Identifier: Apache-2.0
#include "format/key_segment.h"

#include <algorithm>
#include <cmath>

namespace welkin::format {
namespace {
constexpr double kPi = 3.14159265358979323846;
constexpr double kHalfTurnSlack = 1e-9;  // radians: recognises half a turn despite the rounding of degrees and offsets
}  // namespace

double wrapOutside(double time_h) {
  const double wrapped = time_h - kDay_h * std::floor(time_h / kDay_h);
  return wrapped >= 0.0 && wrapped < kDay_h ? wrapped : 0.0;  // rounding of a tiny negative time, or of a huge one
}

KeySegment findSegment(std::span<const double> key_time_h, double time_h) {
  const std::size_t count = key_time_h.size();
  if (count == 1) return {0, 0, 0.0};
  const double t = wrapTime(time_h);
  const auto after = std::upper_bound(key_time_h.begin(), key_time_h.end(), t);
  const std::size_t second = after == key_time_h.end() ? 0 : static_cast<std::size_t>(after - key_time_h.begin());
  const std::size_t first = (second == 0 ? count : second) - 1;
  double since = t - key_time_h[first];
  if (since < 0.0) since += kDay_h;
  double length = key_time_h[second] - key_time_h[first];
  if (length <= 0.0) length += kDay_h;
  const double weight = since / length;
  return weight < 1.0 ? KeySegment{first, second, weight} : KeySegment{second, second, 0.0};
}

void interpolate(std::span<const double> key_time_h, std::span<const double> value, double time_h,
                 std::span<double> out) {
  const KeySegment s = findSegment(key_time_h, time_h);
  const std::size_t n = out.size();
  for (std::size_t i = 0; i < n; ++i)
    out[i] = (1.0 - s.weight) * value[s.first * n + i] + s.weight * value[s.second * n + i];
}

double interpolateAngle(double first_rad, double second_rad, double weight) {
  double turn = std::remainder(second_rad - first_rad, 2.0 * kPi);
  if (turn <= -kPi + kHalfTurnSlack) turn += 2.0 * kPi;
  return first_rad + weight * turn;
}

SkyAngles interpolatePath(std::span<const double> key_time_h, std::span<const double> azimuth_rad,
                          std::span<const double> elevation_rad, double time_h) {
  const KeySegment s = findSegment(key_time_h, time_h);
  return {interpolateAngle(azimuth_rad[s.first], azimuth_rad[s.second], s.weight),
          (1.0 - s.weight) * elevation_rad[s.first] + s.weight * elevation_rad[s.second]};
}

bool areKeyTimes(std::span<const double> key_time_h) {
  if (key_time_h.empty() || !(key_time_h.front() >= 0.0) || !(key_time_h.back() < kDay_h)) return false;
  for (std::size_t i = 1; i < key_time_h.size(); ++i)
    if (!(key_time_h[i] > key_time_h[i - 1])) return false;
  return true;
}

}  // namespace welkin::format
