// SPDX-License-Identifier: Apache-2.0
// The index of a level's files, DIR/level.welkin (table Level of runtime/format/welkin.fbs).
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "probes/hash.h"
#include "probes/sector.h"
#include "probes/transfer/relight.h"
#include "sky/light.h"

namespace welkin::probes {

struct SectorEntry {
  SectorId id;
  std::size_t probes = 0;
  std::uint64_t bytes = 0;  ///< of the whole file
  Hash128 checksum;         ///< of the whole file
  Hash128 baked_from;       ///< BakedFrom::all
};

/// The index, or a shard's part of it: the sectors that the shard baked.
struct LevelIndex {
  std::vector<SectorEntry> sector;      ///< ascending
  Hash128 all_sectors;                  ///< hashOf every sector of the level, also where this is a part
  std::optional<Hash128> sky_checksum;  ///< of the whole of sky.welkin; a part has none
  SunTransfer sun = SunTransfer::none;
  std::optional<sky::LightPath> sun_path;  ///< that the sun's transfer was baked along; with `directional` alone
  std::optional<sky::LightPath> moon_path;
  RelightScale scale;
  std::string settings;  ///< JSON: the bake's sections of level.toml
};

/// Of where sectors are and what they are baked from.
Hash128 hashOf(const std::vector<SectorEntry>& sectors);

std::vector<std::byte> encodeLevel(const LevelIndex& index);

/// Checks and reads an index; `name` is for messages. Throws Error(content).
LevelIndex decodeLevel(std::span<const std::byte> bytes, const std::string& name);

}  // namespace welkin::probes
