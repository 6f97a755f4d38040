// SPDX-License-Identifier: Apache-2.0
// A scene's triangles on the device.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "probes/level/scene.h"
#include "render/buffer.h"
#include "render/coarse_mesh.h"
#include "render/view_cone.h"

namespace welkin::render {

class LevelMesh {
 public:
  /// `device` and `scene` must outlive the object. Its emission, cd/m2, over `luminance_unit`, cd/m2, is in scene
  /// units; without `emits` nothing glows.
  LevelMesh(const VulkanDevice& device, const level::Scene& scene, double luminance_unit, bool emits = true);

  VkBuffer instances() const { return instances_.handle(); }
  VkBuffer contact() const { return contact_.handle(); }

  /// Makes the simplified meshes, if there are none yet; while no command that has been recorded is to run.
  void simplify();

  /// Records every draw but the water's and the glass. With a `view`, the matrix from world to device coordinates of a
  /// perspective, instances beside it are left out, and the backs of single-sided surfaces by dynamic culling.
  /// `mirrored` means that the view is a mirror image. `coarse`: the error of simplified meshes that a view may have,
  /// as a share of the picture's height; what is smaller is left out. 0: all is
  /// drawn as it is. Else simplify() came before.
  void record(VkCommandBuffer commands, const float (*view)[16], bool mirrored, double coarse = 0.0) const;

  /// Whether light passes a surface.
  bool hasGlass() const;
  /// Records the draws of surfaces that light passes, each after its GlassPush.
  void recordGlass(VkCommandBuffer commands, VkPipelineLayout layout) const;

  static std::span<const VkVertexInputAttributeDescription> attributes();

 private:
  bool isGlass(const level::Draw& draw) const;
  void bind(VkCommandBuffer commands) const;
  /// 0: the draw itself, else one more than the coarse level; nothing where the instance is too small or out of view.
  std::optional<std::size_t> levelOf(std::size_t draw, uint32_t instance, const ViewCone* cone, double coarse) const;

  const VulkanDevice& device_;
  const level::Scene& scene_;
  std::vector<Sphere> spheres_;  ///< by instance
  Buffer vertices_;
  std::unique_ptr<Buffer> indices_;
  std::vector<std::array<CoarseDraw, kCoarseLevels>> coarse_;  ///< by draw; empty until they are needed
  Buffer instances_;
  Buffer contact_;
};

}  // namespace welkin::render
