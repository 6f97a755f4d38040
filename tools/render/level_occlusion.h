// SPDX-License-Identifier: Apache-2.0
// The occlusion passes of the level picture: how much of its hemisphere each visible surface sees, found in screen
// space by welkin/occlusion.glsl. The light pass multiplies ambient light by it.
#pragma once

#include "render/image.h"

namespace welkin::render {

/// Visibility in [0, 1] of each pixel's surface; 1 where there is none.
struct OcclusionImages {
  OcclusionImages(const VulkanDevice& device, VkExtent2D extent);

  Image noisy;
  Image visibility;  ///< denoised
};

class LevelOcclusion {
 public:
  static constexpr VkFormat kFormat = VK_FORMAT_R8_UNORM;

  /// `layout` is that of the level's passes.
  LevelOcclusion(const VulkanDevice& device, VkPipelineLayout layout);
  ~LevelOcclusion() { destroy(); }
  LevelOcclusion(const LevelOcclusion&) = delete;
  LevelOcclusion& operator=(const LevelOcclusion&) = delete;

  /// Fills images.visibility and leaves it sampled. `set` is the level's and holds depth, normals and images.noisy.
  /// Without `on` the visibility is 1.
  void record(VkCommandBuffer commands, VkDescriptorSet set, Image& depth, OcclusionImages& images, bool on) const;

  /// Draws the visibility as grey into a picture of Offscreen::kFormat: alpha is 1 where there is a surface, else all
  /// is 0.
  void recordAlone(VkCommandBuffer commands, VkDescriptorSet set, Image& depth, OcclusionImages& images,
                   Image& picture) const;

 private:
  void recordPass(VkCommandBuffer commands, VkDescriptorSet set, Image& depth, Image& to, float clear,
                  VkPipeline pipeline) const;
  void destroy();

  VkDevice device_;
  VkPipelineLayout layout_;
  VkPipeline find_ = VK_NULL_HANDLE;
  VkPipeline denoise_ = VK_NULL_HANDLE;
  VkPipeline denoise_alone_ = VK_NULL_HANDLE;  ///< into a picture
};

}  // namespace welkin::render
