// SPDX-License-Identifier: Apache-2.0
#include "render/level_blockers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>

#include "sky/base/error.h"

namespace welkin::render {
namespace {

constexpr std::size_t kMostInLeaf = 4;
constexpr float kFar = std::numeric_limits<float>::max();

float middleOf(const LevelTriangle& t, int axis) {
  return t.corner[0][axis] + t.corner[1][axis] + t.corner[2][axis];
}

/// Divides the triangles at the median of their middles along the longest axis, so the depth is logarithmic.
class TreeBuilder {
 public:
  explicit TreeBuilder(LevelTree& tree) : tree_(tree) { add(0, tree.triangles.size()); }

 private:
  void add(std::size_t first, std::size_t end) {
    const std::size_t node = tree_.boxes.size();
    tree_.boxes.push_back(boxOf(first, end));
    if (end - first > kMostInLeaf) {
      const std::size_t half = first + (end - first) / 2;
      const auto at = [&](std::size_t i) { return tree_.triangles.begin() + static_cast<std::ptrdiff_t>(i); };
      const int axis = longestAxis(first, end);
      std::nth_element(at(first), at(half), at(end), [axis](const LevelTriangle& a, const LevelTriangle& b) {
        return middleOf(a, axis) < middleOf(b, axis);
      });
      add(first, half);
      add(half, end);
    } else {
      tree_.boxes[node].leaf = static_cast<std::int32_t>(8 * first + (end - first));
    }
    tree_.boxes[node].after = static_cast<std::int32_t>(tree_.boxes.size());
  }

  LevelBox boxOf(std::size_t first, std::size_t end) const {
    LevelBox box{{kFar, kFar, kFar}, 0, {-kFar, -kFar, -kFar}, -1};
    for (std::size_t i = first; i < end; ++i)
      for (const auto& corner : tree_.triangles[i].corner)
        for (int axis = 0; axis < 3; ++axis) {
          box.low[axis] = std::min(box.low[axis], corner[axis]);
          box.high[axis] = std::max(box.high[axis], corner[axis]);
        }
    return box;
  }

  int longestAxis(std::size_t first, std::size_t end) const {
    std::array<float, 3> length{};
    for (int axis = 0; axis < 3; ++axis) {
      const auto [low, high] = std::minmax_element(
          tree_.triangles.begin() + static_cast<std::ptrdiff_t>(first),
          tree_.triangles.begin() + static_cast<std::ptrdiff_t>(end),
          [axis](const LevelTriangle& a, const LevelTriangle& b) { return middleOf(a, axis) < middleOf(b, axis); });
      length[static_cast<std::size_t>(axis)] = middleOf(*high, axis) - middleOf(*low, axis);
    }
    return static_cast<int>(std::max_element(length.begin(), length.end()) - length.begin());
  }

  LevelTree& tree_;
};

template <typename T>
Buffer bufferOf(const VulkanDevice& device, const std::vector<T>& list) {
  const std::size_t bytes = std::max<std::size_t>(list.size(), 1) * sizeof(T);
  const std::size_t most = device.properties().limits.maxStorageBufferRange;
  if (bytes > most)
    throw base::Error(base::ExitStatus::file,
                      fmt::format("the shadows of the level's lamps take {} bytes; the device allows {}", bytes, most));
  return Buffer(device, bytes, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
}

}  // namespace

LevelTree levelTree(const level::Scene& scene) {
  LevelTree tree;
  for (const level::Draw& draw : scene.draws) {
    if (draw.role == geometry::Role::water || scene.materials[draw.material].surface.letsLightThrough()) continue;
    for (uint32_t i = 0; i < draw.instance_count; ++i) {
      const auto& row = scene.instances[draw.first_instance + i].row;
      for (uint32_t index = 0; index < draw.index_count; ++index) {
        if (index % 3 == 0) tree.triangles.emplace_back();
        const std::int64_t vertex = std::int64_t{draw.vertex_offset} + scene.indices[draw.first_index + index];
        const float(&p)[3] = scene.vertices[static_cast<std::size_t>(vertex)].position;
        for (int axis = 0; axis < 3; ++axis)
          tree.triangles.back().corner[index % 3][axis] =
              row[axis][0] * p[0] + row[axis][1] * p[1] + row[axis][2] * p[2] + row[axis][3];
      }
    }
  }
  constexpr std::size_t kMost = std::numeric_limits<std::int32_t>::max() / 8 - 1;
  if (tree.triangles.size() > kMost)
    throw base::Error(
        base::ExitStatus::content,
        fmt::format("{} triangles under the level's lamps; at most {} are allowed", tree.triangles.size(), kMost));
  TreeBuilder{tree};
  return tree;
}

LevelBlockers::LevelBlockers(const VulkanDevice& device, const LevelTree& tree)
    : boxes_(bufferOf(device, tree.boxes)), triangles_(bufferOf(device, tree.triangles)) {
  std::memcpy(boxes_.as<LevelBox>(), tree.boxes.data(), tree.boxes.size() * sizeof(LevelBox));
  if (!tree.triangles.empty())
    std::memcpy(triangles_.as<LevelTriangle>(), tree.triangles.data(), tree.triangles.size() * sizeof(LevelTriangle));
}

}  // namespace welkin::render
