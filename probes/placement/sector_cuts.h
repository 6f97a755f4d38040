// SPDX-License-Identifier: Apache-2.0
// The cuts of a sector's cells as a bake makes them: the arrays of table Cuts of runtime/format/welkin.fbs.
#pragma once

#include <cstdint>
#include <vector>

#include "format/cell_cuts.h"

namespace welkin::placement {

struct SectorCuts {
  std::vector<std::uint16_t> cell, tree, node;
  std::vector<format::CutPlane> plane;
  std::vector<std::uint32_t> mask;

  bool empty() const { return cell.empty(); }

  /// Bytes in a sector's file.
  std::size_t bytes() const {
    return 2 * (cell.size() + tree.size() + node.size()) + sizeof(format::CutPlane) * plane.size() + 4 * mask.size();
  }

  /// A view that the object must outlive.
  format::CellCuts view() const { return {cell, tree, node, plane, mask}; }
};

}  // namespace welkin::placement
