// SPDX-License-Identifier: Apache-2.0
// Packs the trees of a sector's cells into the arrays of its file.
#pragma once

#include <map>

#include "probes/placement/cut_tree.h"
#include "probes/placement/sector_cuts.h"

namespace welkin::placement {

/// Trees come in the order of cells. Equal planes, masks and trees are stored once, and a leaf takes a mask that is
/// there if it differs only where it may. Past kMostCutMasks it takes the one that shuts fewest more cells. A tree that
/// finds no room is left out.
class CutPacker {
 public:
  void add(std::size_t cell, const CutTree& tree);
  SectorCuts finish() { return std::move(cuts_); }

 private:
  bool append(const CutTree& tree, std::size_t node, std::vector<std::uint16_t>& nodes);
  std::optional<std::size_t> planeIndex(const format::CutPlane& plane);
  std::size_t maskIndex(std::uint32_t open, std::uint32_t any);

  SectorCuts cuts_;
  std::map<std::array<float, 3>, std::size_t> plane_;
  std::map<std::vector<std::uint16_t>, std::size_t> tree_;
};

}  // namespace welkin::placement
