// SPDX-License-Identifier: Apache-2.0
// Makes the trees and bricks of one sector's cells along walls and about rooms.
#include <algorithm>
#include <bit>
#include <bitset>
#include <cmath>
#include <optional>

#include "probes/volume_cuts.h"

namespace welkin::probes {
namespace {

constexpr std::uint32_t kBrickBit = 0x40000000;  ///< of a cell or leaf

constexpr std::uint32_t kRisingDoor = 4;  ///< of a door's axis: the room is below its face

using Cells4096 = std::bitset<format::kGridCells>;

/// Marks the cells of the middle sector that touch a box, in cells from its corner.
void markCells(const std::array<double, 3>& low, const std::array<double, 3>& high, Cells4096& near) {
  int first[3], end[3];
  for (std::size_t a = 0; a < 3; ++a) {
    first[a] = static_cast<int>(std::clamp(std::floor(low[a]) - 1.0, 0.0, 16.0));
    end[a] = static_cast<int>(std::clamp(std::ceil(high[a]) + 1.0, 0.0, 16.0));
  }
  for (int k = first[2]; k < end[2]; ++k)
    for (int j = first[1]; j < end[1]; ++j)
      for (int i = first[0]; i < end[0]; ++i) near.set(static_cast<std::size_t>(i + 16 * (j + 16 * k)));
}

/// Marks the cells of the middle sector that are cut or in a room, or touch such a cell.
Cells4096 cellsNearCuts(const BrickSectors& sectors) {
  Cells4096 near;
  const format::GridView& home = *sectors.sector[4].grid;
  const auto rows = [&](double y) { return (y - home.low_y) / home.cell_height_m; };
  for (int s = 0; s < 9; ++s) {
    const BrickSector& sector = sectors.sector[static_cast<std::size_t>(s)];
    if (sector.grid == nullptr) continue;
    const int x0 = 16 * (s % 3 - 1), z0 = 16 * (s / 3 - 1);
    for (const std::uint16_t cell : sector.grid->cuts.cell) {
      const double x = x0 + cell % 16, z = z0 + cell / 256;
      const double y = sector.grid->low_y + sector.grid->cell_height_m * (cell / 16 % 16);
      markCells({x, rows(y), z}, {x + 1.0, rows(y + sector.grid->cell_height_m), z + 1.0}, near);
    }
    for (std::uint32_t r = 1; r <= roomsOf(*sector.sector); ++r) {
      const format::Room& room = *sector.sector->file->room()->Get(r - 1);
      constexpr double kCell_m = format::kCellWidth_m;
      markCells(
          {x0 + double{room.low_x()} / kCell_m, rows(double{room.low_y()}), z0 + double{room.low_z()} / kCell_m},
          {x0 + double{room.high_x()} / kCell_m, rows(double{room.high_y()}), z0 + double{room.high_z()} / kCell_m},
          near);
    }
  }
  if (const auto* doors = sectors.sector[4].sector->file->door())
    for (const format::Door* door : *doors) {
      constexpr double kCell_m = format::kCellWidth_m;
      markCells({double{door->low_x()} / kCell_m, rows(double{door->low_y()}), double{door->low_z()} / kCell_m},
                {double{door->high_x()} / kCell_m, rows(double{door->high_y()}), double{door->high_z()} / kCell_m},
                near);
    }
  return near;
}

/// Low corner of a cell, metres from the sector's.
format::FromCorner cornerOf(const format::CellPlace& cell) {
  return {static_cast<float>(format::kCellWidth_m * (cell.x & 15)),
          static_cast<float>(cell.grid->low_y + cell.grid->cell_height_m * cell.row),
          static_cast<float>(format::kCellWidth_m * (cell.z & 15))};
}

/// A plane of a sector's cuts, for a cell with that low corner.
NodePlane planeOf(const format::CutPlane& plane, const format::FromCorner& low) {
  const format::FromCorner n = format::normalOf(plane);
  const auto whole = [](float v) { return static_cast<std::int32_t>(std::lround(v * 32767.0F)); };
  double offset = double{plane.offset()};
  for (std::size_t a = 0; a < 3; ++a) offset -= double{n[a]} * double{low[a]};
  return {whole(n[0]), whole(n[2]), n[1] < 0.0F, offset};
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

/// Adds the leaf of a part with its brick's word: 0 where the volume's own texels serve.
std::uint32_t VolumeCuts::addLeaf(BrickCell& cell, const BrickPart& part) {
  BrickProbes probes;
  if (!brickOf(cell.sectors, cell.place, part, probes)) return cell.tree.addLeaf(0);
  cell.has_brick = true;
  const auto last = cell.brick.begin() + static_cast<std::ptrdiff_t>(cell.bricks);
  const auto same = std::find_if(cell.brick.begin(), last, [&](std::uint32_t b) { return brick_.get()[b] == probes; });
  if (same != last) return cell.tree.addLeaf(brickWord(*same));
  std::uint32_t word = 0;
  if (!addBrick(cell.slot, probes, word)) return CutWords::kFull;
  if (cell.bricks < cell.brick.size()) cell.brick[cell.bricks++] = next_brick_ - 1;
  return cell.tree.addLeaf(word);
}

/// Adds the nodes of a part of a cell: its walls' tree, or one leaf.
std::uint32_t VolumeCuts::addTree(BrickCell& cell, const RoomPart& part) {
  const WelkinSector& sector = *slot_.get()[cell.slot].sector;
  const format::CellCuts& cuts = sector.grid.cuts;
  const double x = kSector_m * sector.x, z = kSector_m * sector.z;
  const auto inWorld = [&](const format::FromCorner& p) {
    return format::InWorld{double{p[0]} + x, double{p[1]}, double{p[2]} + z};
  };
  const std::optional<std::size_t> tree = cuts.empty() ? std::nullopt : format::treeOf(cuts, cell.place.index());
  if (!tree) {
    format::FromCorner middle;
    for (std::size_t a = 0; a < 3; ++a) middle[a] = part.low[a] + 0.5F * part.size[a];
    return addLeaf(cell, {{sector.grid.grid[cell.place.index()], format::kAllOpen}, part.room, inWorld(middle)});
  }
  const std::size_t first = *tree, end = format::afterTree(cuts.node, first);
  std::array<format::FromCorner, format::kMostTreeNodes> place;
  placesInLeaves(sector, first, part, place);
  std::array<std::uint8_t, format::kMostTreeNodes> size{};
  std::array<std::uint32_t, format::kMostTreeNodes> added{};
  for (std::size_t i = end; i-- > first;) {
    std::uint32_t& node = added[i - first];
    if (format::isLeaf(cuts.node[i])) {
      size[i - first] = 1;
      node = addLeaf(cell, {format::leafOf(cuts, cuts.node[i]), part.room, inWorld(place[i - first])});
      if (node == CutWords::kFull) return node;
      continue;
    }
    const std::size_t below = i - first + 1, above = below + size[below];
    size[i - first] = static_cast<std::uint8_t>(1 + size[below] + size[above]);
    node = cell.tree.addPlane(planeOf(cuts.plane[cuts.node[i]], cornerOf(cell.place)));
    if (node == CutWords::kFull) return node;
    cell.tree.setBelow(node, added[below]);
    cell.tree.setAbove(node, added[above]);
  }
  return added[0];
}

/// Writes the doors that reach into a cell to the slot's nodes, and adds a node for them above the root.
bool VolumeCuts::addDoors(const BrickCell& cell, std::uint32_t& nodes, std::uint32_t& root) const {
  const format::Sector& sector = *slot_.get()[cell.slot].sector->file;
  if (sector.door() == nullptr) return true;
  const format::FromCorner low = cornerOf(cell.place);
  const double height_m = cell.place.grid->cell_height_m;
  const std::uint32_t first = nodes;
  std::uint32_t doors = 0;
  for (const format::Door* door : *sector.door()) {
    const format::DoorWay way = format::doorWayOf(format::boxOf(*door, *sector.room()->Get(door->room())));
    bool touches = true;
    for (std::size_t a = 0; a < 3; ++a)
      touches = touches && way.low[a] <= double{low[a]} + (a == 1 ? height_m : format::kCellWidth_m) &&
                way.high[a] >= double{low[a]};
    if (!touches) continue;
    if (nodes + kDoorNodes > kMostCutNodesPlaced) return false;
    const auto word = [](double v) { return std::bit_cast<std::uint32_t>(static_cast<float>(v)); };
    const auto from = [&](double v, std::size_t a) { return word(v - double{low[a]}); };
    const std::uint32_t axis = static_cast<std::uint32_t>(way.axis) + (way.rises ? kRisingDoor : 0U);
    const std::uint32_t face = word(cell.tree.written(way.face - double{low[way.axis]}));
    const std::array<std::uint32_t, kDoorNodes * kNodeWords> words{
        from(way.low[0], 0),      from(way.low[1], 1),       from(way.low[2], 2),      axis,
        from(way.high[0], 0),     from(way.high[1], 1),      from(way.high[2], 2),     face,
        from(way.fade_low[0], 0), from(way.fade_high[0], 0), from(way.fade_low[2], 2), from(way.fade_high[2], 2)};
    std::copy(words.begin(), words.end(), blockOf(cell.slot) + kCellWords + kNodeWords * nodes);
    nodes += kDoorNodes;
    ++doors;
  }
  if (doors > 0) root = cell.tree.addDoors(first, doors, root);
  return root != CutWords::kFull;
}

/// Adds the nodes of a cell from a room on: the faces of the first room in it that cross it, then the room's part, and
/// what is outside of the room above each face.
std::uint32_t VolumeCuts::addParts(BrickCell& cell, std::uint32_t room_from) {
  const WelkinSector& sector = *slot_.get()[cell.slot].sector;
  const format::FromCorner low = cornerOf(cell.place);
  const format::FromCorner size{static_cast<float>(format::kCellWidth_m), static_cast<float>(sector.grid.cell_height_m),
                                static_cast<float>(format::kCellWidth_m)};
  for (std::uint32_t r = room_from; r <= roomsOf(sector); ++r) {
    const format::Room& room = *sector.file->room()->Get(r - 1);
    const format::FromCorner room_low{room.low_x(), room.low_y(), room.low_z()};
    const format::FromCorner room_high{room.high_x(), room.high_y(), room.high_z()};
    RoomPart part{low, {}, r};
    bool touches = true;
    for (std::size_t a = 0; a < 3; ++a) {
      part.low[a] = std::max(low[a], room_low[a]);
      part.size[a] = std::min(low[a] + size[a], room_high[a]) - part.low[a];
      touches = touches && part.size[a] > 0.0F;
    }
    if (!touches) continue;
    std::array<std::uint32_t, 6> face{};
    std::size_t faces = 0;
    for (std::size_t a = 0; a < 3; ++a)
      for (const bool is_high : {false, true}) {
        if (is_high ? room_high[a] >= low[a] + size[a] : room_low[a] <= low[a]) continue;
        const std::int32_t along = is_high ? 32767 : -32767;
        const double offset = double{is_high ? room_high[a] : room_low[a]} - double{low[a]};
        face[faces] = cell.tree.addPlane(
            {a == 0 ? along : 0, a == 2 ? along : 0, a == 1 && !is_high, is_high ? offset : -offset});
        if (face[faces++] == CutWords::kFull) return CutWords::kFull;
      }
    const std::uint32_t inside = addTree(cell, part);
    if (inside == CutWords::kFull || faces == 0) return inside;  // or all of the cell is in the room
    const std::uint32_t outside = addParts(cell, r + 1);
    if (outside == CutWords::kFull) return outside;
    for (std::size_t i = 0; i < faces; ++i) {
      cell.tree.setBelow(face[i], i + 1 < faces ? face[i + 1] : inside);
      cell.tree.setAbove(face[i], outside);
    }
    return face[0];
  }
  return addTree(cell, {low, size, 0});
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
  CutWords tree;
  std::uint32_t nodes = 0;
  for (std::uint32_t i = 0; i < format::kGridCells; ++i) {
    if (!near[i]) continue;
    BrickCell cell{sectors, {}, slot, tree};
    cell.place.sector_x = s.sector->x;
    cell.place.sector_z = s.sector->z;
    cell.place.x = static_cast<int>(i % 16) + 16 * s.sector->x;
    cell.place.row = static_cast<int>(i / 16 % 16);
    cell.place.z = static_cast<int>(i / 256) + 16 * s.sector->z;
    cell.place.grid = &s.sector->grid;
    tree.begin(std::max(format::kCellWidth_m, s.sector->grid.cell_height_m));
    std::uint32_t root = addParts(cell, 1);
    const std::uint32_t without_doors = root;
    const bool is_made = root != CutWords::kFull && addDoors(cell, nodes, root);
    const bool is_needed = is_made && (cell.has_brick || root != without_doors);
    if (!is_made || (is_needed && !tree.write(root, cells + kNodeWords * i, cells + kCellWords, nodes))) {
      lacks_bricks = next_brick_ == brick_count_;
      clear(slot);
      s.failed = true;
      return false;
    }
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
