// SPDX-License-Identifier: Apache-2.0
// Makes the trees and bricks of one sector's cells along walls.
#include <algorithm>
#include <bit>
#include <bitset>
#include <cmath>

#include "probes/volume_cuts.h"

namespace welkin::probes {
namespace {

constexpr std::uint32_t kNodeWords = 4;
constexpr std::uint32_t kTreeBit = 0x80000000;   ///< of a cell
constexpr std::uint32_t kBrickBit = 0x40000000;  ///< of a cell or leaf
constexpr std::uint32_t kDownBit = 0x100;        ///< of a node: its plane's normal points down

using Cells4096 = std::bitset<format::kGridCells>;

/// Marks the cells of the middle sector that are cut or touch a cut cell.
Cells4096 cellsNearCuts(const BrickSectors& sectors) {
  Cells4096 near;
  const format::GridView& home = *sectors.sector[4].grid;
  for (int s = 0; s < 9; ++s) {
    const format::GridView* grid = sectors.sector[static_cast<std::size_t>(s)].grid;
    if (grid == nullptr) continue;
    for (const std::uint16_t cell : grid->cuts.cell) {
      const int x = cell % 16 + 16 * (s % 3 - 1), z = cell / 256 + 16 * (s / 3 - 1);
      if (x < -1 || x > 16 || z < -1 || z > 16) continue;
      const double low = (grid->low_y + grid->cell_height_m * (cell / 16 % 16) - home.low_y) / home.cell_height_m;
      const double high = low + grid->cell_height_m / home.cell_height_m;
      const int first = static_cast<int>(std::clamp(std::floor(low) - 1.0, 0.0, 16.0));
      const int end = static_cast<int>(std::clamp(std::ceil(high) + 1.0, 0.0, 16.0));
      for (int k = std::max(z - 1, 0); k <= std::min(z + 1, 15); ++k)
        for (int j = first; j < end; ++j)
          for (int i = std::max(x - 1, 0); i <= std::min(x + 1, 15); ++i)
            near.set(static_cast<std::size_t>(i + 16 * (j + 16 * k)));
    }
  }
  return near;
}

}  // namespace

std::uint32_t VolumeCuts::brickWord(std::uint32_t brick) const {
  const std::uint32_t in_layer = brick % perLayer();
  return kBrickBit | (in_layer % across_[0]) << 19 | (in_layer / across_[0]) << 11 | brick / perLayer();
}

bool VolumeCuts::addBrick(std::uint32_t slot, const BrickProbes& probes, std::uint32_t& word) {
  while (next_brick_ < brick_count_) {
    const std::uint32_t b = next_brick_++;
    if (owner_.get()[b] != 0) continue;
    owner_.get()[b] = slot + 1;
    brick_.get()[b] = probes;
    lit_.get()[b / perLayer()] = 0;
    ++used_;
    word = brickWord(b);
    return true;
  }
  return false;
}

/// Writes a cut cell's tree after the slot's `nodes` nodes, with a brick for each leaf. `word` becomes the cell's.
bool VolumeCuts::addTree(std::uint32_t slot, const BrickSectors& sectors, const format::CellPlace& cell,
                         std::uint32_t& nodes, std::uint32_t& word) {
  const format::CellCuts& cuts = cell.grid->cuts;
  const std::size_t first = *format::treeOf(cuts, cell.index()), end = format::afterTree(cuts.node, first);
  if (nodes + (end - first) > kMostCutNodesPlaced) return false;
  const double side_m = 16 * format::kCellWidth_m;
  const format::FromCorner low{static_cast<float>(format::kCellWidth_m * (cell.x & 15)),
                               static_cast<float>(cell.grid->low_y + cell.grid->cell_height_m * cell.row),
                               static_cast<float>(format::kCellWidth_m * (cell.z & 15))};
  std::array<format::FromCorner, format::kMostTreeNodes> place;
  placesInLeaves(cuts, first, low, static_cast<float>(cell.grid->cell_height_m), place);
  std::uint32_t* to = blockOf(slot) + kCellWords;
  std::array<std::uint8_t, format::kMostTreeNodes> size{};
  std::array<std::uint32_t, format::kMostTreeNodes> own{};  // bricks of this cell
  std::size_t count = 0;
  bool has_brick = false;
  for (std::size_t i = end; i-- > first;) {
    std::uint32_t* node = to + kNodeWords * (nodes + (i - first));
    std::fill_n(node, kNodeWords, 0U);
    if (format::isLeaf(cuts.node[i])) {
      size[i - first] = 1;
      const format::FromCorner& p = place[i - first];
      const format::InWorld at{double{p[0]} + side_m * cell.sector_x, double{p[1]},
                               double{p[2]} + side_m * cell.sector_z};
      BrickProbes probes;
      if (!brickOf(sectors, cell, format::leafOf(cuts, cuts.node[i]), at, probes)) continue;
      has_brick = true;
      const auto last = own.begin() + static_cast<std::ptrdiff_t>(count);
      const auto same = std::find_if(own.begin(), last, [&](std::uint32_t b) { return brick_.get()[b] == probes; });
      if (same != last) {
        node[0] = brickWord(*same);
        continue;
      }
      if (!addBrick(slot, probes, node[0])) return false;
      own[count++] = next_brick_ - 1;
      continue;
    }
    const std::uint8_t below = size[i - first + 1];
    size[i - first] = static_cast<std::uint8_t>(1 + below + size[i - first + 1 + below]);
    const format::CutPlane& plane = cuts.plane[cuts.node[i]];
    const format::FromCorner n = format::normalOf(plane);
    node[0] = std::bit_cast<std::uint32_t>(n[0]);
    node[1] = std::bit_cast<std::uint32_t>(n[2]);
    node[2] = std::bit_cast<std::uint32_t>(plane.offset());
    node[3] = 1U + below + (n[1] < 0.0F ? kDownBit : 0U);
  }
  if (!has_brick) return true;
  word = kTreeBit | nodes;
  nodes += static_cast<std::uint32_t>(end - first);
  return true;
}

/// Makes the bricks and trees of a slot's sector. False where there is no room; then it has none, for a lack of bricks
/// or of nodes.
bool VolumeCuts::build(std::uint32_t slot, bool& lacks_bricks) {
  Slot& s = slot_.get()[slot];
  clear(slot);
  s.stale = s.failed = false;
  const BrickSectors sectors = sectorsAbout(*s.sector);
  const Cells4096 near = cellsNearCuts(sectors);
  std::uint32_t* cells = blockOf(slot);
  std::uint32_t nodes = 0;
  for (std::uint32_t i = 0; i < format::kGridCells; ++i) {
    if (!near[i]) continue;
    format::CellPlace cell;
    cell.sector_x = s.sector->x;
    cell.sector_z = s.sector->z;
    cell.x = static_cast<int>(i % 16) + 16 * s.sector->x;
    cell.row = static_cast<int>(i / 16 % 16);
    cell.z = static_cast<int>(i / 256) + 16 * s.sector->z;
    cell.grid = &s.sector->grid;
    std::uint32_t word = 0;
    bool fits = true;
    if (hasCuts(s.sector) && (s.sector->cut.get()[i / 64] >> (i % 64) & 1) != 0) {
      fits = addTree(slot, sectors, cell, nodes, word);
    } else {
      const format::InWorld middle{format::kCellWidth_m * (cell.x + 0.5),
                                   cell.grid->low_y + cell.grid->cell_height_m * (cell.row + 0.5),
                                   format::kCellWidth_m * (cell.z + 0.5)};
      BrickProbes probes;
      if (brickOf(sectors, cell, {cell.grid->grid[i], format::kAllOpen}, middle, probes))
        fits = addBrick(slot, probes, word);
    }
    if (!fits) {
      lacks_bricks = next_brick_ == brick_count_;
      clear(slot);
      s.failed = true;
      return false;
    }
    cells[i] = word;
  }
  return true;
}

/// Builds a sector. Where there is no room, farther ones yield their bricks, the farthest first.
bool VolumeCuts::buildOrYield(std::uint32_t wanted) {
  const Wanted* all = wanted_.get();
  for (std::uint32_t last = wanted_count_;;) {
    bool lacks_bricks = false;
    if (build(all[wanted].slot, lacks_bricks)) return true;
    if (!lacks_bricks) return false;
    do {
      if (--last <= wanted) return false;
    } while (slot_.get()[all[last].slot].failed);
    clear(all[last].slot);
    slot_.get()[all[last].slot].failed = true;
    slot_.get()[all[last].slot].stale = false;
  }
}

}  // namespace welkin::probes
