// SPDX-License-Identifier: Apache-2.0
// The part of the C interface that reads the volume: the shader's constants, and its irradiance on the CPU.
#include <welkin/volume_constants.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>

#include "core/floats.h"
#include "probes/cut_reader.h"
#include "probes/volume.h"
#include "shared.h"

namespace welkin::probes {
namespace {

/// A surface is on the side of its cell's walls where a point so far off it is. Where walls meet, small parts of a cell
/// have no leaf of their own, and points on the surface may lie in them.
constexpr double kOffWalls_m = 0.25;

WelkinVolumeConstants constantsOf(const WelkinVolume& volume) {
  WelkinVolumeConstants out{};
  const auto set = [](WelkinFloat4& to, const std::array<double, 3>& v, double w) {
    to = {core::toFloat(v[0]), core::toFloat(v[1]), core::toFloat(v[2]), core::toFloat(w)};
  };
  std::array<double, 3> low, size;
  for (std::size_t a = 0; a < 3; ++a) {
    size[a] = volume.count[a] * volume.texel_m[a];
    low[a] = static_cast<double>(volume.first[a]) * volume.texel_m[a];
  }
  set(out.low, low, double{volume.scale});
  set(out.camera, volume.camera, kPush_m);
  set(out.size, size, volume.count[2]);
  set(out.texel, volume.texel_m, 1.0 / (2.0 * *std::max_element(volume.texel_m.begin(), volume.texel_m.end())));
  const auto& mask = volume.cuts.mask();
  set(out.cuts, {1.0 * mask[0], 1.0 * mask[1], kOffWalls_m}, 1.0 / volume.depth);
  const FarMap& map = volume.far_map;
  set(out.far_map, {map.low_m(0), map.low_m(1), map.edge_m()}, map.fade_m());
  set(out.far_share, {map.reach_m(), 1.0 / map.border_m(), 0.0}, 0.0);
  return out;
}

/// A place among the texels, in texels from the first one's corner.
struct TexelPlace {
  std::array<double, 3> at;
  bool repeats;  ///< along z; else it is in a brick
};

/// The volume's own texels for a place where a surface looks up its light, metres.
TexelPlace ownPlace(const WelkinVolume& volume, const std::array<double, 3>& looked_up) {
  TexelPlace place{{}, true};
  for (std::size_t a = 0; a < 3; ++a) {
    const double first = static_cast<double>(volume.first[a]), end = first + volume.count[a];
    place.at[a] = std::clamp(looked_up[a] / volume.texel_m[a], first + 0.5, end - 0.5);
  }
  return place;
}

/// The texels that cuts lead to, or the volume's own.
TexelPlace placeOf(const WelkinVolume& volume, f32::CutReader& cuts, const f32::CutReader::CutBrick& found,
                   TexelPlace place) {
  if (found.brick == 0) return place;
  const auto corner = cuts.cutBrickCorner(found.brick);
  for (int a = 0; a < 3; ++a)
    place.at[static_cast<std::size_t>(a)] = 3.0 * double{corner[a]} + std::clamp(double{found.at[a]}, 0.5, 2.5);
  place.at[2] += volume.count[2] + 1.0;
  place.repeats = false;
  return place;
}

/// Places from where a surface has its light, with their shares: one, and in a door one more.
struct LightPlaces {
  TexelPlace place[2];
  double share[2];
};

LightPlaces placesOf(const WelkinVolume& volume, const float position[3], const float normal[3]) {
  std::array<double, 3> looked_up;
  bool is_inside = true;
  for (std::size_t a = 0; a < 3; ++a) {
    const double first = static_cast<double>(volume.first[a]), p = double{position[a]} / volume.texel_m[a];
    is_inside = is_inside && p > first && p < first + volume.count[a];
    looked_up[a] = double{position[a]} + kPush_m * double{normal[a]};
  }
  LightPlaces places{{ownPlace(volume, looked_up), {}}, {1.0, 0.0}};
  if (!is_inside) return places;
  f32::CutReader cuts(volume.cuts.words(), volume.cuts.mask());
  const f32::Number3 at(position[0], position[1], position[2]), n(normal[0], normal[1], normal[2]);
  const f32::Number3 p = at + n * static_cast<float>(kOffWalls_m), place = at + n * static_cast<float>(kPush_m);
  const auto found = cuts.cutBrickAt(p, place);
  places.place[0] = placeOf(volume, cuts, found, places.place[0]);
  if (found.doors == 0) return places;
  const auto beyond = cuts.cutDoorOf(found, p, place);
  if (!(beyond.share > 0.0F)) return places;
  places.share[0] = 1.0 - double{beyond.share};
  places.share[1] = double{beyond.share};
  const f32::Number3& there = beyond.place;
  places.place[1] = placeOf(volume, cuts, cuts.cutBrickAt(beyond.p, there),
                            ownPlace(volume, {double{there.x}, double{there.y}, double{there.z}}));
  return places;
}

/// Texel numbers of one channel at a place, filtered as a GPU does.
std::array<double, kDirections> filtered(const WelkinVolume& volume, std::size_t channel, const TexelPlace& place) {
  std::array<std::size_t, 3> index[2];
  std::array<double, 3> share;
  for (std::size_t a = 0; a < 3; ++a) {
    const double at = place.at[a] - 0.5;
    share[a] = at - std::floor(at);
    const auto n = static_cast<std::int64_t>(place.repeats || a < 2 ? volume.count[a] : volume.depth);
    for (std::int64_t i = 0; i < 2; ++i)
      index[i][a] = static_cast<std::size_t>(((static_cast<std::int64_t>(std::floor(at)) + i) % n + n) % n);
  }
  std::array<double, kDirections> sum{};
  for (unsigned i = 0; i < 8; ++i) {
    double weight = 1.0;
    std::array<std::size_t, 3> at{};
    for (std::size_t a = 0; a < 3; ++a) {
      const bool second = (i >> a & 1) != 0;
      weight *= second ? share[a] : 1.0 - share[a];
      at[a] = index[second ? 1 : 0][a];
    }
    const std::size_t texel = at[0] + volume.count[0] * (at[1] + volume.count[1] * at[2]);
    std::uint64_t word = 0;
    std::memcpy(&word, volume.texels[channel].get() + texel * volume.texel_bytes, volume.texel_bytes);
    const auto numbers = unpackTexel(word, volume.format, volume.scale);
    for (std::size_t b = 0; b < kDirections; ++b) sum[b] += weight * double{numbers[b]};
  }
  return sum;
}

}  // namespace
}  // namespace welkin::probes

using namespace welkin::core;
using namespace welkin::probes;

WelkinResult welkin_volume_constants(const WelkinVolume* volume, WelkinVolumeConstants* constants, size_t size) {
  if (const auto r = nonNull(__func__, {{"volume", volume}, {"constants", constants}})) return r;
  constexpr size_t kWithoutFarMap = offsetof(WelkinVolumeConstants, far_map);
  if (size != sizeof *constants && size != kWithoutFarMap)
    return refuse(__func__, "size is %zu, must be %zu or %zu", size, sizeof *constants, kWithoutFarMap);
  const WelkinVolumeConstants all = constantsOf(*volume);
  std::memcpy(static_cast<void*>(constants), &all, size);
  return WELKIN_OK;
}

WelkinResult welkin_volume_irradiance(const WelkinVolume* volume, const float position[3], const float normal[3],
                                      float irradiance[3], float* inside) {
  if (const auto r = nonNull(__func__, {{"volume", volume}, {"position", position}, {"irradiance", irradiance}}))
    return r;
  if (const auto r = unit(__func__, "normal", normal)) return r;
  if (volume->format == WELKIN_VOLUME_DEVICE)
    return refuse(__func__, "the volume's format is WELKIN_VOLUME_DEVICE, so only the device has its texels");
  double margin = 1e30;
  for (std::size_t a = 0; a < 3; ++a) {
    if (!(std::abs(position[a]) <= 1e7F))
      return refuse(__func__, "position[%zu] is %g, must be within 1e7 m", a, double{position[a]});
    const double reach = (0.5 * volume->count[a] - 1.5) * volume->texel_m[a] - kPush_m;
    margin = std::min(margin, reach - std::abs(double{position[a]} - volume->camera[a]));
  }
  const LightPlaces places = placesOf(*volume, position, normal);
  const welkin::f64::TransferWeights weight = welkin::f64::transferWeights(load(normal));
  for (std::size_t c = 0; c < kChannels; ++c) {
    double sum = 0.0;
    for (const std::size_t i : {0, 1}) {
      if (!(places.share[i] > 0.0)) continue;
      const auto light = filtered(*volume, c, places.place[i]);
      for (std::size_t b = 0; b < kDirections; ++b) sum += places.share[i] * weight.v[b] * light[b];
    }
    irradiance[c] = toFloat(std::max(sum, 0.0));
  }
  const double widest = *std::max_element(volume->texel_m.begin(), volume->texel_m.end());
  if (inside != nullptr) *inside = static_cast<float>(std::clamp(margin / (2.0 * widest), 0.0, 1.0));
  return WELKIN_OK;
}
