// SPDX-License-Identifier: Apache-2.0
// An opened level and its resident sectors.
#pragma once

#include <welkin/volume.h>

#include <array>
#include <cstdint>
#include <span>

#include "core/arguments.h"
#include "core/open_file.h"
#include "format/cut_lookup.h"
#include "probes/far_map.h"
#include "probes/lamps.h"
#include "probes/local_light.h"
#include "probes/packed_probes.h"
#include "probes/sector_light.h"
#include "probes/virtual_lights.h"

namespace welkin::core {

template <>
inline constexpr std::size_t kFirstSize<WelkinLevelLimits> = 12;
template <>
inline constexpr std::size_t kFirstSize<WelkinLevelInfo> = 48;
template <>
inline constexpr std::size_t kFirstSize<WelkinLevelLight> = 32;
template <>
inline constexpr std::size_t kFirstSize<WelkinRelight> = 12;
template <>
inline constexpr std::size_t kFirstSize<WelkinLightsResult> = 20;

}  // namespace welkin::core

namespace welkin::probes {

inline constexpr double kSector_m = 64.0;
inline constexpr double kPush_m = 1.0;  ///< a surface looks up its light this far off along its normal

/// What the packed light of the resident sectors was made of. Volumes of different formats or scales pack it anew.
struct PackedLight {
  std::uint64_t version = 0;  ///< of the light; 0: nothing is packed
  WelkinVolumeFormat format = WELKIN_VOLUME_RGBA16F;
  float scale = 1.0F;
  bool operator==(const PackedLight&) const = default;
};

/// Some probes of one sector, to be relit together.
struct RelightPiece {
  WelkinSector* sector;
  std::uint32_t first;  ///< probe of the sector
  std::uint32_t start;  ///< number of the piece's first probe among all that are relit
};

}  // namespace welkin::probes

struct WelkinSector {
  welkin::core::HostMemory memory;
  const WelkinLevel* level = nullptr;
  const welkin::format::Sector* file = nullptr;  ///< checked; points into the caller's bytes
  welkin::format::GridView grid;
  std::int32_t x = 0, z = 0;
  std::uint32_t probes = 0;
  std::size_t modes = 0;
  std::size_t bytes = 0;                       ///< of the memory below
  welkin::core::HostArray<std::byte> blocks;   ///< packProbes
  welkin::core::HostArray<std::uint64_t> cut;  ///< a bit a cell of the grid that walls part; null without
  welkin::core::HostArray<float> fixed;        ///< light that does not follow the day, as `light`; null without
  std::uint64_t fixed_changes = 0;             ///< counts changes of `fixed`
  welkin::core::HostArray<float> light;        ///< [probe][channel][direction], relit
  bool has_rooms = false;
  std::array<std::uint8_t, welkin::format::kGridCells> filled{};  ///< the grid, its holes as their nearest cells
  welkin::probes::FarTile far_tile{};
  welkin::core::HostArray<std::array<std::uint64_t, 3>> packed;  ///< the light as texels of the volume
  welkin::probes::SectorLight now{};                             ///< the light of `pass`
  std::uint64_t pass = 0;      ///< WelkinLevel::instant at which the running pass began; 0: none
  std::uint32_t done = 0;      ///< probes that the running pass has relit
  std::uint64_t arrival = 0;   ///< WelkinLevel::residents when it came
  std::uint64_t complete = 0;  ///< the instant that all probes have, or a later one; 0: none
  std::uint32_t slot = 0;      ///< place among the resident sectors
  bool resident = false;
  bool fresh = false;  ///< no pass over its probes has ended since it came
  welkin::probes::SectorLights lights;
  welkin::probes::LocalTransfers transfers;
};

struct WelkinLevel {
  welkin::core::FileBytes source;
  const welkin::format::Level* index = nullptr;
  std::uint32_t capacity = 0;
  std::uint32_t count = 0;                          ///< of resident sectors
  welkin::core::HostArray<WelkinSector*> resident;  ///< in no order
  welkin::core::HostArray<std::uint32_t> table;     ///< open addressing: 1 + slot, or 0
  std::uint32_t table_mask = 0;
  std::uint32_t probes = 0;  ///< of the resident sectors
  welkin::probes::LevelLight light;
  std::uint64_t instant = 0;                                     ///< counts changes of the light; 0: none set
  std::uint64_t changes = 0;                                     ///< counts relightings and changes of the residents
  std::uint64_t residents = 0;                                   ///< counts changes of the residents
  std::uint32_t next = 0;                                        ///< slot where relighting goes on
  welkin::probes::PackedLight packed;                            ///< of WelkinSector::packed
  welkin::core::HostArray<welkin::probes::RelightPiece> pieces;  ///< of the relighting that has begun
  std::uint32_t piece_count = 0;
  std::uint32_t chosen = 0;  ///< probes of the pieces
  welkin::probes::LightTable lights;
  welkin::probes::Lamps lamps;
};

namespace welkin::probes {

/// The resident sector (x, z), or null.
WelkinSector* residentAt(const WelkinLevel& level, std::int32_t x, std::int32_t z);

}  // namespace welkin::probes
