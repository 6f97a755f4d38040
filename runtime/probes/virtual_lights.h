// SPDX-License-Identifier: Apache-2.0
// The virtual lights of all resident sectors. A light that stands in the lists of several sectors counts once, and
// every list shows its colour. What results depends on the resident sectors alone, not on the order of their arrival.
#pragma once

#include <welkin/level.h>

#include <array>
#include <cstdint>
#include <span>

#include "core/host_memory.h"

namespace welkin::probes {

/// A light of a resident sector's list: the sector's number times 65536, and the light's index.
using LightHandle = std::uint32_t;
inline constexpr LightHandle kNoLight = 0xffffffff;

inline constexpr double kSameLight_m = 1e-3;      ///< lists hold floats from each corner, rounded by less than 0.02 mm
inline constexpr double kFarthestLight_m = 64.0;  ///< a virtual light sees no lamp beyond

using Place = std::array<double, 3>;  ///< metres

/// A light of a list, and its links to other lists while its sector is resident.
struct VirtualLight {
  LightHandle first;      ///< the same light in the first list that has it; lists ascend in x, then z
  LightHandle same;       ///< the same light in the next list
  LightHandle next;       ///< of a first one: another one of its bucket
  std::uint32_t touched;  ///< of a first one: 1 while it gets its colour anew
  float colour[3];        ///< radiant intensity
};

/// The list of one sector.
struct SectorLights {
  std::uint32_t count = 0;
  std::uint32_t number = 0;  ///< of the sector while it is resident
  Place low{}, high{};       ///< box of the lights
  bool is_lit = false;       ///< WelkinSector::fixed holds light of them
  bool is_changed = false;   ///< one of them gets its colour anew
  core::HostArray<VirtualLight> light;
};

/// The first ones of all lists, in buckets by their place in x and z.
struct LightTable {
  core::HostArray<WelkinSector*> sector;  ///< by number; null where a number is free
  std::uint32_t capacity = 0;
  std::uint32_t lowest_free = 0;        ///< no number below is free
  core::HostArray<LightHandle> bucket;  ///< the first light of each
  std::uint32_t mask = 0;
};

/// Memory for the lights of at most `sectors` sectors. False when there is none.
bool openTable(const core::HostMemory& memory, std::uint32_t sectors, LightTable& table);
/// Memory for a sector's list. The sector has its place and its file. False when there is none.
bool openLights(WelkinSector& sector);

VirtualLight& lightAt(const LightTable& table, LightHandle handle);
Place placeOf(const LightTable& table, LightHandle handle);

/// Joins a sector's list to the others. Its lights get the colours of the others'.
void linkLights(LightTable& table, WelkinSector& sector);
/// Takes a sector's list away. Until releaseNumber, `first` of its lights is the same light in another list, or
/// kNoLight.
void unlinkLights(LightTable& table, WelkinSector& sector);
void releaseNumber(LightTable& table, WelkinSector& sector);

/// A virtual light near a place. Their order is by distance, then by place, then by index.
struct NearLight {
  double distance_m;
  Place place;
  LightHandle light;
};

/// The next ones after `after`, or the nearest if that is null: as many as `out` holds and kFarthestLight_m allows, in
/// order. Returns their number.
std::size_t nearestLights(const LightTable& table, const Place& place, const NearLight* after,
                          std::span<NearLight> out);

}  // namespace welkin::probes
