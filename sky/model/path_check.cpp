// SPDX-License-Identifier: Apache-2.0
#include "sky/model/path_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace welkin::model {

using det::Number3;
namespace {

/// Text of a sky file's key that lies below the horizon half way along a stretch.
std::string keyBelow(const LightPath& path, const HorizonStretch& stretch) {
  const double middle_h = format::wrapTime(stretch.from_h + stretch.length_h / 2.0);
  const Number3 d = path.directionAt(middle_h);
  const long azimuth_deg = std::lround((det::atan(d.x, -d.z) - path.north_offset_rad) / det::kDegree) % 360;
  return fmt::format("[{:.4g}, {}, -30]", middle_h, (azimuth_deg + 360) % 360);
}

}  // namespace

Culmination culminationOf(const LightPath& path) {
  if (path.key_time_h.empty())
    return {format::wrapTime(path.transit_h), det::kPi / 2.0 - std::abs(path.latitude_rad - path.declination_rad)};
  const auto highest = std::max_element(path.key_elevation_rad.begin(), path.key_elevation_rad.end());
  return {path.key_time_h[static_cast<std::size_t>(highest - path.key_elevation_rad.begin())], *highest};
}

std::vector<HorizonStretch> horizonStretchesOf(const LightPath& path) {
  const std::size_t count = path.key_time_h.size();
  const auto isOnHorizon = [](double elevation_rad) {
    return std::abs(elevation_rad) <= kHorizonBand_deg * det::kDegree;
  };
  if (std::all_of(path.key_elevation_rad.begin(), path.key_elevation_rad.end(), isOnHorizon)) return {};
  const auto lengthAfter = [&](std::size_t i) {  // From key i to the next, over midnight after the last one.
    return i + 1 < count ? path.key_time_h[i + 1] - path.key_time_h[i] : path.key_time_h[0] + 24.0 - path.key_time_h[i];
  };
  const auto isStretch = [&](std::size_t i) {
    return isOnHorizon(path.key_elevation_rad[i]) && isOnHorizon(path.key_elevation_rad[(i + 1) % count]) &&
           lengthAfter(i) > kLongestOnHorizon_h;
  };
  std::vector<HorizonStretch> stretches;
  for (std::size_t i = 0; i < count; ++i) {
    if (!isStretch(i) || isStretch((i + count - 1) % count)) continue;  // Already counted from its first key.
    HorizonStretch stretch{path.key_time_h[i], 0.0};
    for (std::size_t j = i; isStretch(j); j = (j + 1) % count) stretch.length_h += lengthAfter(j);
    stretches.push_back(stretch);
  }
  return stretches;
}

std::vector<Warning> pathWarningsOf(const LightPath& path, const std::string& light) {
  std::vector<Warning> warnings;
  if (path.key_time_h.empty()) return warnings;
  if (const Culmination top = culminationOf(path); top.elevation_rad < 0.0)
    warnings.push_back({"never-rises", 1,
                        fmt::format("the {} never rises: it is highest at {:.4g} h, {:.3g} degrees below the horizon",
                                    light, top.time_h, -top.elevation_rad / det::kDegree)});
  const auto stretches = horizonStretchesOf(path);
  if (stretches.empty()) return warnings;
  std::string when;
  for (const HorizonStretch& s : stretches)
    when += fmt::format("{}from {:.4g} h to {:.4g} h ({:.3g} hours)", when.empty() ? "" : " and ", s.from_h,
                        format::wrapTime(s.from_h + s.length_h), s.length_h);
  warnings.push_back(
      {"on-horizon", stretches.size(),
       fmt::format("the {} lies on the horizon {}; if it should set, add a key below the horizon, for example {}",
                   light, when, keyBelow(path, stretches[0]))});
  return warnings;
}

}  // namespace welkin::model
