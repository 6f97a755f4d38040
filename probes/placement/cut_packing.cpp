// SPDX-License-Identifier: Apache-2.0
#include "probes/placement/cut_packing.h"

#include <algorithm>
#include <bit>

namespace welkin::placement {

std::optional<std::size_t> CutPacker::planeIndex(const format::CutPlane& plane) {
  const std::array<float, 3> key{static_cast<float>(plane.u()), static_cast<float>(plane.v()), plane.offset()};
  const auto [found, is_new] = plane_.emplace(key, cuts_.plane.size());
  if (is_new && cuts_.plane.size() == format::kMostCutPlanes) {
    plane_.erase(found);
    return std::nullopt;
  }
  if (is_new) cuts_.plane.push_back(plane);
  return found->second;
}

std::size_t CutPacker::maskIndex(std::uint32_t open, std::uint32_t any) {
  std::vector<std::uint32_t>& mask = cuts_.mask;
  if (mask.empty()) mask.push_back(format::kOwnOpen);  // serves every leaf if there is no room
  const std::uint32_t needed = open & ~any;
  const auto lost = [&](std::uint32_t m) { return std::popcount(needed & ~m); };
  std::size_t best = 0;
  for (std::size_t i = 1; i < mask.size(); ++i)
    if ((mask[i] & ~open) == 0 && lost(mask[i]) < lost(mask[best])) best = i;
  if (lost(mask[best]) == 0 || mask.size() == format::kMostCutMasks) return best;
  mask.push_back(open);
  return mask.size() - 1;
}

bool CutPacker::append(const CutTree& tree, std::size_t node, std::vector<std::uint16_t>& nodes) {
  const CutNode& n = tree[node];
  if (!n.plane) {
    nodes.push_back(static_cast<std::uint16_t>(format::kCutLeaf | maskIndex(n.open, n.any) << 8 | n.probe));
    return true;
  }
  const auto plane = planeIndex(*n.plane);
  if (!plane) return false;
  nodes.push_back(static_cast<std::uint16_t>(*plane));
  return append(tree, n.below, nodes) && append(tree, n.above, nodes);
}

void CutPacker::add(std::size_t cell, const CutTree& tree) {
  std::vector<std::uint16_t> nodes;
  if (!append(tree, 0, nodes)) return;
  const auto [found, is_new] = tree_.emplace(nodes, cuts_.node.size());
  if (is_new) {
    if (cuts_.node.size() + nodes.size() > format::kMostCutNodes) {
      tree_.erase(found);
      return;
    }
    cuts_.node.insert(cuts_.node.end(), nodes.begin(), nodes.end());
  }
  cuts_.cell.push_back(static_cast<std::uint16_t>(cell));
  cuts_.tree.push_back(static_cast<std::uint16_t>(found->second));
}

}  // namespace welkin::placement
