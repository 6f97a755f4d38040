// SPDX-License-Identifier: Apache-2.0
// The sky's visibility from above about the camera, for light beyond the volume: a tile for each resident sector, after
// Stefanov (GDC 2012). A texel is a column of cells, and its index is the column's modulo the map's edge, so that no
// texel moves.
#pragma once

#include <welkin/volume.h>

#include <array>
#include <cstdint>

#include "core/open_file.h"
#include "format/cut_lookup.h"
#include "probes/sector_light.h"
#include "welkin_generated.h"

namespace welkin::probes {

inline constexpr std::uint32_t kTileEdge = format::kCellsAcross;  ///< texels along the edge of a sector's tile

/// A sector's columns x + 16 z, seen from above. The lower half of a word is the occlusion, the upper half occlusion
/// times height in metres, each a half.
using FarTile = std::array<std::uint32_t, std::size_t{kTileEdge} * kTileEdge>;

/// The sky's light whose share a tile states: radiance 1 over the upper hemisphere, irradiance pi.
LevelLight uniformSky();

/// The tile of a sector, which has been checked, from its probes' light under that sky: [probe][channel][direction].
/// For each column it has the share of that light, direct and bounced, that a horizontal surface lacks, and the height
/// of the probe. A fit moves light between visibility and transfer, so visibility alone does not tell it. Open for a
/// sector without probes.
FarTile farTileOf(const format::Sector& sector, const float* light);

class FarMap {
 public:
  static constexpr std::uint32_t kMostTiles = 64;  ///< along an edge

  /// For so many tiles along each edge. All of it is open. False when memory runs out.
  bool allocate(const core::HostMemory& memory, std::uint32_t tiles, double fade_m);

  /// Follows the level's sectors about a camera, metres, and says which rectangles changed; at first all of it.
  void update(const WelkinLevel& level, double x, double z, WelkinVolumeUpdate& out);

  const std::uint32_t* texels() const { return texels_.get(); }
  std::uint32_t edge() const { return tiles_ * kTileEdge; }
  /// Low corner along an axis, 0 for x and 1 for z, metres.
  double low_m(std::size_t axis) const;
  double edge_m() const;
  double fade_m() const { return fade_m_; }
  /// Distance from the camera, along x and z, at which the map's share is 0.
  double reach_m() const;
  /// Width of the border in which the share falls to 0.
  double border_m() const;
  /// Occlusion, and occlusion times height, filtered at a place as a GPU does.
  std::array<double, 2> at(double x, double z) const;

 private:
  /// Writes the tile of slot (i, j) anew. Returns whether it held another one.
  bool fill(const WelkinLevel& level, std::uint32_t i, std::uint32_t j);

  std::uint32_t tiles_ = 0;
  double fade_m_ = 0.0;
  core::HostArray<std::uint32_t> texels_;
  core::HostArray<std::uint64_t> held_;  ///< WelkinSector::arrival of each tile; 0: open
  std::array<std::int64_t, 2> first_{};  ///< sector of least indices
  std::uint64_t residents_ = 0;          ///< WelkinLevel::residents + 1 of the last update; 0: none
};

}  // namespace welkin::probes
