// SPDX-License-Identifier: Apache-2.0
#include "probes/cut_words.h"

#include <algorithm>
#include <cmath>

namespace welkin::probes {
namespace {

constexpr std::uint32_t kPlaneBit = 0x80000000, kDownBit = 0x40000000, kDoorBit = 0x20000000;
constexpr std::uint32_t kPairShift = 18, kCountShift = 16;
constexpr double kOffsets = 131072.0;  ///< steps of an offset on each side of 0

}  // namespace

void CutWords::begin(double edge_m) {
  count_ = 0;
  steps_a_metre_ = kOffsets / edge_m;
}

double CutWords::written(double offset) const {
  return std::round(offset * steps_a_metre_) / steps_a_metre_;
}

std::uint32_t CutWords::add(std::uint32_t x, std::uint32_t y) {
  if (count_ == node_.size()) return kFull;
  node_[count_] = {x, y, kFull, kFull, kFull};
  return count_++;
}

std::uint32_t CutWords::addLeaf(std::uint32_t word) {
  return add(word, 0);
}

std::uint32_t CutWords::addPlane(const NodePlane& plane) {
  // A plane that does not cross the cell lies beyond all of its places wherever it is.
  const double step = std::clamp(std::round(plane.offset * steps_a_metre_), 1.0 - kOffsets, kOffsets - 1.0);
  const auto sixteen = [](std::int32_t n) { return static_cast<std::uint32_t>(n) & 0xffffU; };
  return add(sixteen(plane.x) | sixteen(plane.z) << 16,
             kPlaneBit | (plane.is_down ? kDownBit : 0U) | static_cast<std::uint32_t>(step + kOffsets));
}

std::uint32_t CutWords::addDoors(std::uint32_t first, std::uint32_t doors, std::uint32_t below) {
  const std::uint32_t node = add(first | doors << kCountShift, kPlaneBit | kDoorBit);
  if (node != kFull) node_[node].below = node_[node].above = below;
  return node;
}

bool CutWords::write(std::uint32_t root, std::uint32_t* cell, std::uint32_t* nodes, std::uint32_t& used) {
  Node& node = node_[root];
  cell[0] = node.x;
  cell[1] = node.y;
  if (node.below == kFull) return true;
  const bool is_new = node.pair == kFull;
  if (is_new) {
    if (used + 2 > kMostCutNodesPlaced) return false;
    node.pair = used;
    used += 2;
  }
  cell[1] |= node.pair << kPairShift;
  if (!is_new) return true;
  std::uint32_t* pair = nodes + std::size_t{kNodeWords} * node.pair;
  return write(node.below, pair, nodes, used) && write(node.above, pair + kNodeWords, nodes, used);
}

}  // namespace welkin::probes
