// SPDX-License-Identifier: Apache-2.0
// The index of a level's files, DIR/level.welkin (table Level of runtime/format/welkin.fbs).
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "probes/geometry/sector.h"
#include "probes/transfer/relight.h"
#include "sky/base/hash.h"
#include "sky/model/light.h"

namespace welkin::sectors {

struct SectorEntry {
  geometry::SectorId id;
  std::size_t probes = 0;
  std::uint64_t bytes = 0;   ///< of the whole file
  base::Hash128 checksum;    ///< of the whole file
  base::Hash128 baked_from;  ///< BakedFrom::all
};

/// The index, or a shard's part of it: the sectors that the shard baked.
struct LevelIndex {
  std::vector<SectorEntry> sector;            ///< ascending
  base::Hash128 all_sectors;                  ///< hashOf every sector of the level, also where this is a part
  std::optional<base::Hash128> sky_checksum;  ///< of the whole of sky.welkin; a part has none
  transfer::SunTransfer sun = transfer::SunTransfer::none;
  std::optional<model::LightPath> sun_path;  ///< that the sun's transfer was baked along; with `directional` alone
  std::optional<model::LightPath> moon_path;
  transfer::RelightScale scale;
  std::string settings;  ///< JSON: the bake's sections of level.toml
};

/// Of where sectors are and what they are baked from.
base::Hash128 hashOf(const std::vector<SectorEntry>& sectors);

std::vector<std::byte> encodeLevel(const LevelIndex& index);

/// Checks and reads an index; `name` is for messages. Throws Error(content).
LevelIndex decodeLevel(std::span<const std::byte> bytes, const std::string& name);

}  // namespace welkin::sectors
