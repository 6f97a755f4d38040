// SPDX-License-Identifier: Apache-2.0
#include "format/cell_cuts.h"

#include "format/domain_check.h"

namespace welkin::format {

CellCuts cutsOf(const Cuts& c) {
  CellCuts cuts;
  cuts.cell = spanOf(c.cell());
  cuts.tree = spanOf(c.tree());
  cuts.node = spanOf(c.node());
  if (const auto* planes = c.plane(); planes != nullptr && planes->size() > 0)
    cuts.plane = {reinterpret_cast<const CutPlane*>(planes->Data()), planes->size()};
  cuts.mask = spanOf(c.mask());
  return cuts;
}

CutWay cutWay(const CellCuts& cuts, std::size_t cell, std::uint8_t uncut, const FromCorner& p,
              const FromCorner& direction) {
  CutWay result;
  result.leaf = {uncut, kAllOpen};
  const auto tree = cuts.empty() ? std::nullopt : treeOf(cuts, cell);
  if (!tree) return result;
  result.leaf = leafAt(cuts, *tree, p, [&](const CutPlane& plane, float above) {
    const FromCorner n = normalOf(plane);
    const float rise = n[0] * direction[0] + n[1] * direction[1] + n[2] * direction[2];
    const bool crosses = above > 0.0F ? rise < 0.0F : rise > 0.0F;
    if (crosses) result.way_m = std::min(result.way_m, -above / rise);
  });
  return result;
}

}  // namespace welkin::format
