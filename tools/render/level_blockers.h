// SPDX-License-Identifier: Apache-2.0
// A level's triangles in a tree of boxes on the device, in which shaders look for what stands before a lamp.
#pragma once

#include <vector>

#include "probes/level/scene.h"
#include "render/buffer.h"

namespace welkin::render {

/// A node of the tree as level_blockers.glsl reads it. A node's first child comes next.
struct LevelBox {
  float low[3];
  std::int32_t after;  ///< the node that follows where the box is missed or done
  float high[3];
  std::int32_t
      leaf;  ///< 8 x the index of the first triangle, plus the number of triangles, 1 to 4; -1: it has children
};

struct LevelTriangle {
  float corner[3][3];  ///< world axes, metres
};

struct LevelTree {
  std::vector<LevelBox> boxes;  ///< never empty
  std::vector<LevelTriangle> triangles;
};

/// The tree of all triangles that stop a lamp's light in pictures: neither water nor surfaces that light passes.
LevelTree levelTree(const level::Scene& scene);

class LevelBlockers {
 public:
  /// Throws Error(file) if the device takes no buffer of that size.
  LevelBlockers(const VulkanDevice& device, const LevelTree& tree);

  VkBuffer boxes() const { return boxes_.handle(); }
  VkBuffer triangles() const { return triangles_.handle(); }

 private:
  Buffer boxes_;
  Buffer triangles_;  ///< never empty
};

}  // namespace welkin::render
