// SPDX-License-Identifier: Apache-2.0
#include "format/cell_cuts.h"
#include "format/check_parts.h"
#include "format/domain_check.h"

namespace welkin::format {
namespace {

/// Whether a whole tree starts at a node, with planes, masks and probes that are there.
bool isTree(const CellCuts& cuts, std::size_t first, std::size_t probes) {
  std::size_t open = 1;
  for (std::size_t i = first; open > 0; ++i) {
    if (i >= cuts.node.size() || i - first >= kMostTreeNodes) return false;
    const std::uint16_t node = cuts.node[i];
    if (!isLeaf(node)) {
      if (node >= cuts.plane.size()) return false;
      ++open;
      continue;
    }
    const std::size_t probe = node & 0xffU;
    if (((node >> 8) & 0x7fU) >= cuts.mask.size() || (probe != kNoProbe && probe >= probes)) return false;
    --open;
  }
  return true;
}

bool isPlane(const CutPlane& plane) {
  const int u = plane.u(), v = plane.v();
  return u >= -32767 && v >= -32767 && within(double{plane.offset()}, -kFarthest_m, kFarthest_m);
}

}  // namespace

void checkCuts(Check& check, const Cuts& c, std::size_t probes) {
  constexpr const char* kName = "the cuts";
  if (!check.that(c.plane() == nullptr || reinterpret_cast<std::uintptr_t>(c.plane()->Data()) % alignof(CutPlane) == 0,
                  kName, "are misaligned"))
    return;
  const CellCuts cuts = cutsOf(c);
  check.that(!cuts.cell.empty() && cuts.cell.size() <= kGridCells, kName, "must be of 1 to 4096 cells");
  for (std::size_t i = 0; i < cuts.cell.size(); ++i)
    check.that(cuts.cell[i] < kGridCells && (i == 0 || cuts.cell[i] > cuts.cell[i - 1]), kName,
               "must have ascending cells that are there");
  check.that(cuts.node.size() <= kMostCutNodes && cuts.plane.size() <= kMostCutPlanes, kName,
             "must have at most 65535 nodes and 32768 planes");
  check.that(cuts.mask.size() <= kMostCutMasks, kName, "must have at most 128 masks");
  for (const std::uint32_t mask : cuts.mask)
    check.that((mask & kOwnOpen) != 0 && (mask & ~kAllOpen) == 0, kName,
               "must have masks of 27 cells, each open to its own");
  for (const CutPlane& plane : cuts.plane) check.that(isPlane(plane), kName, "have a plane out of its domain");
  if (!check.that(cuts.tree.size() == cuts.cell.size(), kName, "must have a tree for every cell")) return;
  for (const std::uint16_t tree : cuts.tree)
    if (!check.that(isTree(cuts, tree, probes), kName,
                    "must have whole trees of planes, masks and probes that are there"))
      return;
}

}  // namespace welkin::format
