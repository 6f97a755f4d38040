// SPDX-License-Identifier: Apache-2.0
// A baked sector as the bytes of a .welkin file (table Sector of runtime/format/welkin.fbs).
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "probes/placement/counts.h"
#include "probes/placement/sector_cuts.h"
#include "probes/transfer/encoding_error.h"
#include "probes/transfer/local_encoding.h"
#include "probes/transfer/relight.h"
#include "sky/base/hash.h"

namespace welkin::sectors {

/// Errors of a sector's numbers.
struct SectorError {
  double sampling = 0.0;  ///< TransferEffort::error of the worst probe
  std::size_t sampling_probe = 0;
  transfer::EncodingError encoding;
  transfer::SunModesError modes;  ///< error of leaving out further modes
};

/// The error of a sector's distant light: sampling and, for the worse of sky and sun, modes and encoding, added as if
/// independent.
inline double totalOf(const SectorError& e) {
  const double sun = std::hypot(e.modes.worst_row, e.encoding.sun);
  return std::hypot(e.sampling, std::max(e.encoding.sky, sun));
}

/// Sampling error of a sector's local transfer before thinning, and its cost.
struct LocalSampling {
  double error = 0.0;  ///< LocalProbe::error of the worst probe
  std::size_t probe = 0;
  std::uint64_t rays = 0;
};

/// A sector's local transfer as it was baked.
struct BakedLocal {
  transfer::EncodedLocal encoded;
  LocalSampling sampling;
  transfer::LocalEncodingError encoding;
  transfer::LocalThinning thinning;
};

/// The error of a sector's local transfer, before thinning.
inline double totalOf(const BakedLocal& l) {
  return std::hypot(l.sampling.error, l.encoding.radiance);
}

/// Hashes of everything that a sector's bake reads.
struct BakedFrom {
  base::Hash128 all;  ///< the others, and the method and format used
  base::Hash128 surfaces;
  base::Hash128 settings;
  base::Hash128 light_paths;
  bool operator==(const BakedFrom&) const = default;
};

/// Rooms, named places, cuts, places of `settings` and lights of `local` count from the sector's corner.
struct SectorFile : geometry::SectorGrid {
  geometry::SectorId id;
  transfer::SunTransfer sun = transfer::SunTransfer::none;
  transfer::EncodedProbes probes;
  std::string settings;  ///< JSON: the settings of level.toml for this sector
  BakedFrom baked_from;
  placement::PlacementCounts placement;
  std::uint64_t rays = 0;
  SectorError error;
  std::optional<BakedLocal> local;  ///< empty if level.toml has no dynamic lights
  placement::SectorCuts cuts;       ///< planes count from the sector's corner
  std::size_t unlit = 0;            ///< probes that no ray connects to sky, sun, moon or emission
};

std::vector<std::byte> encodeSector(const SectorFile& sector);

/// Checks and reads a sector. `name` is for messages. Throws Error(content) for bytes that are cut, damaged, foreign or
/// out of their domain.
SectorFile decodeSector(std::span<const std::byte> bytes, const std::string& name);

}  // namespace welkin::sectors
