// SPDX-License-Identifier: Apache-2.0
// A scene's triangles on the device.
#pragma once

#include <array>
#include <span>

#include "probes/level/scene.h"
#include "render/buffer.h"

namespace welkin::render {

class LevelMesh {
 public:
  /// `scene` must outlive the object. Its emission, cd/m2, over `luminance_unit`, cd/m2, is in scene units;
  /// without `emits` nothing glows.
  LevelMesh(const VulkanDevice& device, const level::Scene& scene, double luminance_unit, bool emits = true);

  VkBuffer instances() const { return instances_.handle(); }

  /// Records every draw but the water's and the glass. With `cull`, which needs dynamic culling, the backs of
  /// single-sided surfaces are left out. `mirrored` means that the view is a mirror image.
  void record(VkCommandBuffer commands, bool cull, bool mirrored) const;

  /// Whether light passes a surface.
  bool hasGlass() const;
  /// Records the draws of surfaces that light passes, each after its GlassPush.
  void recordGlass(VkCommandBuffer commands, VkPipelineLayout layout) const;

  static std::span<const VkVertexInputAttributeDescription> attributes();

 private:
  bool isGlass(const level::Draw& draw) const;
  void bind(VkCommandBuffer commands) const;

  const level::Scene& scene_;
  Buffer vertices_;
  Buffer indices_;
  Buffer instances_;
};

}  // namespace welkin::render
