// SPDX-License-Identifier: Apache-2.0
// The trees of planes that part a sector's cells along walls (table Cuts of welkin.fbs). A point's leaf names the probe
// of its side and the cells about it that are on its side as well. Nothing here allocates or throws.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>

#include "welkin_generated.h"

namespace welkin::format {

inline constexpr std::size_t kMostCutPlanes = 32768;  ///< per sector
inline constexpr std::size_t kMostCutMasks = 128;     ///< per sector
inline constexpr std::size_t kMostCutNodes = 65535;   ///< per sector
inline constexpr std::size_t kMostTreeNodes = 127;    ///< per tree, leaves included
inline constexpr std::uint16_t kCutLeaf = 0x8000;     ///< this bit marks a leaf

/// Bit of a cell (dx, dy, dz) away, each -1 to 1, in a mask of open cells.
constexpr std::uint32_t openBit(int dx, int dy, int dz) {
  return std::uint32_t{1} << (dx + 1 + 3 * (dy + 1) + 9 * (dz + 1));
}
inline constexpr std::uint32_t kOwnOpen = openBit(0, 0, 0);
inline constexpr std::uint32_t kAllOpen = (std::uint32_t{1} << 27) - 1;

/// A position or direction, metres from the corner of a sector: x and z from its corner, y of the world.
using FromCorner = std::array<float, 3>;

/// A part of a cell.
struct CutLeaf {
  std::uint8_t probe;  ///< stands for the cell here; kNoProbe: none
  std::uint32_t open;  ///< cells about it that it may be filtered with, by openBit; its own always
  bool operator==(const CutLeaf&) const = default;
};

/// The cuts of one sector. Views of the file's bytes.
struct CellCuts {
  std::span<const std::uint16_t> cell, tree, node;
  std::span<const CutPlane> plane;
  std::span<const std::uint32_t> mask;
  bool empty() const { return cell.empty(); }
};

/// The cuts of a file; of a checked one, everything is there.
CellCuts cutsOf(const Cuts& cuts);
/// The cuts of a checked sector; empty if it has none.
inline CellCuts cutsOf(const Sector& sector) {
  return sector.cuts() == nullptr ? CellCuts{} : cutsOf(*sector.cuts());
}

/// The plane's normal, as the file's integers, over 32767. Its three numbers' sizes add up to 1.
inline FromCorner normalOf(const CutPlane& plane) {
  const int u = plane.u(), v = plane.v();
  const int size_u = u < 0 ? -u : u, size_v = v < 0 ? -v : v;
  const int y = 32767 - size_u - size_v;
  const auto number = [](int n) { return static_cast<float>(n) / 32767.0F; };
  if (y >= 0) return {number(u), number(y), number(v)};
  return {number(u < 0 ? size_v - 32767 : 32767 - size_v), number(y), number(v < 0 ? size_u - 32767 : 32767 - size_u)};
}

/// How far a point is above a plane, in metres times the length of its normal; <= 0: below.
inline float aboveBy(const CutPlane& plane, const FromCorner& p) {
  const FromCorner n = normalOf(plane);
  return n[0] * p[0] + n[1] * p[1] + n[2] * p[2] - plane.offset();
}

inline bool isLeaf(std::uint16_t node) {
  return (node & kCutLeaf) != 0;
}

/// Index of the node after the tree that starts at `node`, in preorder. The tree must be whole.
inline std::size_t afterTree(std::span<const std::uint16_t> nodes, std::size_t node) {
  for (std::size_t open = 1; open > 0; ++node) open = isLeaf(nodes[node]) ? open - 1 : open + 1;
  return node;
}

/// The first node of a cell's tree; nothing for a cell without.
inline std::optional<std::size_t> treeOf(const CellCuts& cuts, std::size_t cell) {
  const auto found = std::lower_bound(cuts.cell.begin(), cuts.cell.end(), cell);
  if (found == cuts.cell.end() || *found != cell) return std::nullopt;
  return cuts.tree[static_cast<std::size_t>(found - cuts.cell.begin())];
}

inline CutLeaf leafOf(const CellCuts& cuts, std::uint16_t node) {
  return {static_cast<std::uint8_t>(node & 0xffU), cuts.mask[(node >> 8) & 0x7fU]};
}

/// The leaf at a point of the tree that starts at `node`. Calls passed(plane, above) for each plane on the way, with
/// aboveBy of the point.
template <typename Passed>
CutLeaf leafAt(const CellCuts& cuts, std::size_t node, const FromCorner& p, const Passed& passed) {
  while (!isLeaf(cuts.node[node])) {
    const CutPlane& plane = cuts.plane[cuts.node[node]];
    const float above = aboveBy(plane, p);
    passed(plane, above);
    node = above > 0.0F ? afterTree(cuts.node, node + 1) : node + 1;
  }
  return leafOf(cuts, cuts.node[node]);
}

/// The leaf of a cell at a point. `uncut` is the grid's probe, for a cell without a tree.
inline CutLeaf leafOfCell(const CellCuts& cuts, std::size_t cell, std::uint8_t uncut, const FromCorner& p) {
  const auto tree = cuts.empty() ? std::nullopt : treeOf(cuts, cell);
  if (!tree) return {uncut, kAllOpen};
  return leafAt(cuts, *tree, p, [](const CutPlane&, float) {});
}

/// A point moved to one side of a plane, where another point is that is `above` by aboveBy: along the normal, to a
/// millimetre off the plane or less.
inline FromCorner onSideOf(const CutPlane& plane, float above, const FromCorner& p) {
  constexpr float kOff = 1e-3F;
  const float here = aboveBy(plane, p);
  const float least = above > 0.0F ? std::min(above, kOff) : std::max(above, -kOff);
  if (above > 0.0F ? here >= least : here <= least) return p;
  const FromCorner n = normalOf(plane);
  const float by = (least - here) / (n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
  return {p[0] + n[0] * by, p[1] + n[1] * by, p[2] + n[2] * by};
}

/// `to` moved to the side of a point `p` of the planes that bound the leaf of `p`, so that it lies along the walls and
/// not behind them.
inline FromCorner besideWalls(const CellCuts& cuts, std::size_t cell, const FromCorner& p, FromCorner to) {
  const auto tree = cuts.empty() ? std::nullopt : treeOf(cuts, cell);
  if (!tree) return to;
  for (int pass = 0; pass < 2; ++pass)  // a second, for where two walls meet
    leafAt(cuts, *tree, p, [&](const CutPlane& plane, float above) { to = onSideOf(plane, above, to); });
  return to;
}

/// The leaf at a point, and the way from there along a direction to the first plane that bounds the leaf.
struct CutWay {
  CutLeaf leaf;
  float way_m = std::numeric_limits<float>::infinity();  ///< infinite if the direction leaves it through no plane
};
CutWay cutWay(const CellCuts& cuts, std::size_t cell, std::uint8_t uncut, const FromCorner& p,
              const FromCorner& direction);

}  // namespace welkin::format
