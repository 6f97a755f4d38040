// SPDX-License-Identifier: Apache-2.0
#include "format/domain_check.h"

#include "format/key_segment.h"
#include "shared.h"

namespace welkin::format {

bool aligned(const flatbuffers::Vector<double>* vector) {
  return vector == nullptr || vector->size() == 0 ||
         reinterpret_cast<std::uintptr_t>(vector->Data()) % alignof(double) == 0;
}

const char* faultOf(const LightPath& path) {
  constexpr double kHalfPi = f64::kHalfPi;
  if (!aligned(path.key_time_h()) || !aligned(path.key_azimuth_rad()) || !aligned(path.key_elevation_rad()))
    return "has misaligned path keys";
  const auto times = spanOf(path.key_time_h());
  if (!times.empty()) {
    const auto azimuth = spanOf(path.key_azimuth_rad());
    const auto elevation = spanOf(path.key_elevation_rad());
    if (!areKeyTimes(times)) return "must have ascending path times in [0, 24)";
    if (azimuth.size() != times.size() || elevation.size() != times.size())
      return "must have an azimuth and an elevation for every path key";
    if (!within(azimuth, -kAny, kAny) || !within(elevation, -kHalfPi, kHalfPi))
      return "has a path key out of its domain";
  }
  if (!within(path.latitude_rad(), -kHalfPi, kHalfPi) || !within(path.declination_rad(), -kHalfPi, kHalfPi) ||
      !within(path.transit_h(), -kAny, kAny) || !within(path.north_offset_rad(), -kAny, kAny))
    return "has a path out of its domain";
  return nullptr;
}

}  // namespace welkin::format
