// SPDX-License-Identifier: Apache-2.0
// The tree of a cell along walls and about rooms, and its words for shaders/shared/cuts.glsl.
#pragma once

#include <array>
#include <cstdint>

#include "format/cell_cuts.h"

namespace welkin::probes {

inline constexpr std::uint32_t kNodeWords = 2;
inline constexpr std::uint32_t kMostCutNodesPlaced = 1024;  ///< of a sector
inline constexpr std::uint32_t kDoorNodes = 6;              ///< a door's

/// The plane of a node, with its normal as the file's integers, each over 32767.
struct NodePlane {
  std::int32_t x = 0, z = 0;
  bool is_down = false;  ///< whether the normal points down
  double offset = 0.0;   ///< from the cell's low corner, metres times the length of the normal
};

/// A tree of planes that is built node by node and then written. Several planes may share what is above them.
class CutWords {
 public:
  /// Begins the tree of a cell whose longest edge is so long, metres.
  void begin(double edge_m);

  /// Where a plane of an axis is written that is so far from the cell's low corner, metres.
  double written(double offset) const;

  /// Each gives the new node's index, or kFull.
  std::uint32_t addLeaf(std::uint32_t word);
  std::uint32_t addPlane(const NodePlane& plane);
  /// A node that only tells where `doors` doors are, before another.
  std::uint32_t addDoors(std::uint32_t first, std::uint32_t doors, std::uint32_t below);
  void setBelow(std::uint32_t plane, std::uint32_t node) { node_[plane].below = node; }
  void setAbove(std::uint32_t plane, std::uint32_t node) { node_[plane].above = node; }

  /// Writes the tree under a root: the root to `cell`, and the others to `nodes` from `used` on. False if there is no
  /// room for them.
  bool write(std::uint32_t root, std::uint32_t* cell, std::uint32_t* nodes, std::uint32_t& used);

  static constexpr std::uint32_t kFull = ~0U;

 private:
  struct Node {
    std::uint32_t x, y;          ///< words, without the place of the nodes below and above
    std::uint32_t below, above;  ///< kFull: none
    std::uint32_t pair;          ///< where these two are written; kFull: not yet
  };

  std::uint32_t add(std::uint32_t x, std::uint32_t y);

  std::array<Node, kMostCutNodesPlaced> node_;
  std::uint32_t count_ = 0;
  double steps_a_metre_ = 1.0;
};

}  // namespace welkin::probes
