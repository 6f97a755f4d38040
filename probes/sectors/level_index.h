// SPDX-License-Identifier: Apache-2.0
// The index of a level's files, DIR/level.welkin (table Level of runtime/format/welkin.fbs).
#pragma once

#include <array>
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
  base::Hash128 all_sectors;                  ///< hashOf all sectors of the level, also in a part
  std::optional<base::Hash128> sky_checksum;  ///< of the whole of sky.welkin; a part has no checksum
  transfer::SunTransfer sun = transfer::SunTransfer::none;
  std::optional<model::LightPath> sun_path;  ///< path of the sun's baked transfer; only with `directional`
  std::optional<model::LightPath> moon_path;
  transfer::RelightScale scale;
  std::array<double, 3> ground_albedo{};  ///< of the sky of the bake
  std::string settings;                   ///< JSON: the bake's sections of level.toml
};

/// Hash of the sectors' ids and of their `baked_from`.
base::Hash128 hashOf(const std::vector<SectorEntry>& sectors);

std::vector<std::byte> encodeLevel(const LevelIndex& index);

/// Checks and reads an index. `name` is for messages. Throws Error(content) if the bytes are refused.
LevelIndex decodeLevel(std::span<const std::byte> bytes, const std::string& name);

}  // namespace welkin::sectors
