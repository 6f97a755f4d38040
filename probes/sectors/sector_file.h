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
#include "probes/transfer/encoding_error.h"
#include "probes/transfer/local_encoding.h"
#include "probes/transfer/relight.h"
#include "sky/base/hash.h"

namespace welkin::sectors {

/// What a sector's numbers are off by.
struct SectorError {
  double sampling = 0.0;  ///< TransferEffort::error of the worst probe
  std::size_t sampling_probe = 0;
  transfer::EncodingError encoding;
  transfer::SunModesError modes;  ///< of leaving out further modes
};

/// The error of a sector's distant light: sampling, modes and encoding of the worse of sky and sun, as if independent.
inline double totalOf(const SectorError& e) {
  const double sun = std::hypot(e.modes.worst_row, e.encoding.sun);
  return std::hypot(e.sampling, std::max(e.encoding.sky, sun));
}

/// How sure the local transfer of a sector is, before thinning, and what that took.
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

/// Likewise of its local transfer, before thinning.
inline double totalOf(const BakedLocal& l) {
  return std::hypot(l.sampling.error, l.encoding.radiance);
}

/// What a sector was baked from: hashes of everything that its bake reads.
struct BakedFrom {
  base::Hash128 all;  ///< the others, and what method and format they went through
  base::Hash128 surfaces;
  base::Hash128 settings;
  base::Hash128 light_paths;
  bool operator==(const BakedFrom&) const = default;
};

struct SectorFile {
  geometry::SectorId id;
  double low_y = 0.0;  ///< of the grid, as PlacedSector has it
  double cell_height_m = geometry::kCell_m;
  std::array<std::uint8_t, geometry::kCells * geometry::kCells * geometry::kCells> grid{};
  transfer::SunTransfer sun = transfer::SunTransfer::none;
  transfer::EncodedProbes probes;
  std::string settings;  ///< JSON: what of level.toml speaks of this sector
  BakedFrom baked_from;
  placement::PlacementCounts placement;
  std::uint64_t rays = 0;
  SectorError error;
  std::optional<BakedLocal> local;  ///< none where level.toml provides for no dynamic lights
  std::array<std::uint8_t, geometry::kCells * geometry::kCells> top{};  ///< as PlacedSector has these
  std::vector<geometry::Room> room;
  std::vector<std::uint8_t> in_room;
  std::size_t unlit = 0;  ///< probes that no ray joins to sky, sun, moon or emission
};

std::vector<std::byte> encodeSector(const SectorFile& sector);

/// Checks and reads a sector; `name` is for messages. Throws Error(content) for bytes that are cut, damaged, foreign or
/// out of their domain.
SectorFile decodeSector(std::span<const std::byte> bytes, const std::string& name);

}  // namespace welkin::sectors
