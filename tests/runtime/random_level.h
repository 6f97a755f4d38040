// SPDX-License-Identifier: Apache-2.0
// A level of random numbers, as files in memory and as the double reference reads them.
#pragma once

#include <welkin/level.h>

#include <cstddef>
#include <span>
#include <vector>

#include "probes/sectors/level_index.h"
#include "probes/sectors/level_light.h"
#include "probes/sectors/sector_file.h"
#include "sky/bake/sky_file.h"

namespace welkin::tests {

/// The sky that the sectors of every random level are baked for.
bake::SkyFile skyOfLevel();

/// Bytes at an address that the runtime accepts.
struct AlignedBytes {
  explicit AlignedBytes(std::span<const std::byte> bytes);
  std::vector<std::max_align_t> room;
  std::size_t size;
  const void* data() const { return room.data(); }
};

struct RandomLevel {
  std::vector<std::byte> sky;
  std::vector<sectors::SectorFile> sector;  ///< ascending
  sectors::LevelIndex index;

  /// `count` sectors in a row along x from (-1, 0), each of `probes` probes with `modes` modes of sun and moon, in a
  /// grid that names them at random, with rooms in the first two, and a door
  /// of these. Emitted light where `emits`.
  RandomLevel(int count, std::size_t probes, std::size_t modes, transfer::SunTransfer sun, bool emits,
              unsigned seed = 1);

  /// Makes the index name a sector that was changed.
  void seal(std::size_t i);
  /// Gives every sector local transfer: `lights` virtual lights a sector, within y of 0 to 6 m, and for each probe up
  /// to `transfers` of those of its sector and of the two beside it. Without rooms, so that the middle of a cell shows
  /// its probe alone.
  void addLocal(std::size_t lights, std::size_t transfers, unsigned seed = 1);

  /// Lists the sectors in the index again, after a change.
  void reindex();

  std::vector<std::byte> sectorBytes(std::size_t i) const { return sectors::encodeSector(sector[i]); }
};

/// The level opened by the runtime, with every sector resident.
struct OpenedLevel {
  explicit OpenedLevel(const RandomLevel& level, const WelkinAllocator* allocator = nullptr);
  OpenedLevel(const OpenedLevel&) = delete;
  OpenedLevel& operator=(const OpenedLevel&) = delete;
  ~OpenedLevel();

  WelkinSky* sky = nullptr;
  WelkinLevel* level = nullptr;
  std::vector<AlignedBytes> files;

  WelkinSkySample sampleAt(double time_h) const;
  /// Relights every probe for an hour. Returns the sample.
  WelkinSkySample relight(double time_h, float sky_factor = 1, float sun_factor = 1, float local = 1);
};

/// The light of a sample in double, for LevelLight.
sectors::LightOfDay lightOf(const WelkinSkySample& sample);

}  // namespace welkin::tests
