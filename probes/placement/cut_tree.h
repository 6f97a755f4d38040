// SPDX-License-Identifier: Apache-2.0
// Grows the tree of planes that parts a cell's points so that one probe may stand for all points of a leaf (the greedy
// induction of Breiman et al., "Classification and Regression Trees", 1984, with Gini's impurity summed over labels).
#pragma once

#include "probes/placement/cut_candidates.h"
#include "probes/placement/cut_samples.h"

namespace welkin::placement {

struct CutNode {
  std::optional<format::CutPlane> plane;  ///< none: a leaf
  std::size_t below = 0, above = 0;       ///< nodes; they follow this one
  std::uint8_t probe = geometry::kNoProbe;
  std::uint32_t open = format::kAllOpen;  ///< cells about it, by format::openBit
  std::uint32_t any = 0;                  ///< those of them that may as well be shut
  std::vector<std::uint32_t> sample;      ///< of a leaf
};

using CutTree = std::vector<CutNode>;  ///< the first is the root

/// The leaf of a point, which counts from the sector's corner.
const CutNode& leafAt(const CutTree& tree, const format::FromCorner& p);

/// `to` beside the walls that bound the leaf of `p`, as format::besideWalls moves it.
format::FromCorner besideWalls(const CutTree& tree, const format::FromCorner& p, format::FromCorner to);

/// A point as floats from the sector's corner.
inline format::FromCorner fromCornerOf(const geometry::SectorId& id, const Number3& p) {
  const Number3 q = p - geometry::cornerOf(id);
  return {static_cast<float>(q.x), static_cast<float>(q.y), static_cast<float>(q.z)};
}

/// The tree of a cell. `probe` is the grid's, and stays that of a leaf where it may stand for all of it. Masks are
/// those of what the samples call shut.
CutTree growTree(const CutSampler& sampler, const ProbeSight& sight, const geometry::SectorId& id, std::uint8_t probe,
                 const std::vector<CutCandidate>& planes, std::vector<CutSample>& samples);

/// Whether more samples are parted than may be by chance, of all that the filter uses.
bool isMany(std::size_t parted, std::size_t all);

/// Turns planes whose leaves say the same into leaves.
CutTree simplified(const CutTree& tree);

}  // namespace welkin::placement
