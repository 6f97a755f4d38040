// SPDX-License-Identifier: Apache-2.0
#include "render/level_occlusion.h"

#include <cstdint>

#include "render/graphics_pipeline.h"
#include "render/level_pipelines.h"
#include "render/offscreen.h"
#include "spirv/kFullscreenVert.h"
#include "spirv/kLevelOcclusionDenoiseFrag.h"
#include "spirv/kLevelOcclusionFrag.h"

namespace welkin::render {
namespace {

constexpr VkImageUsageFlags kOcclusionUsage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT;

}  // namespace

OcclusionImages::OcclusionImages(const VulkanDevice& device, VkExtent2D extent)
    : noisy(device, LevelOcclusion::kFormat, extent, kOcclusionUsage),
      visibility(device, LevelOcclusion::kFormat, extent, kOcclusionUsage) {}

LevelOcclusion::LevelOcclusion(const VulkanDevice& device, VkPipelineLayout layout)
    : device_(device.device()), layout_(layout) {
  // The full-screen triangle has depth 0, less than any surface.
  const auto create = [&](std::span<const uint32_t> fragment, VkFormat format) {
    return createGraphicsPipeline(device_, {.layout = layout_,
                                            .vertex = kFullscreenVert,
                                            .fragment = fragment,
                                            .colours = {format},
                                            .depth = LevelPipelines::kDepthFormat,
                                            .depth_compare = VK_COMPARE_OP_LESS});
  };
  try {
    find_ = create(kLevelOcclusionFrag, kFormat);
    denoise_ = create(kLevelOcclusionDenoiseFrag, kFormat);
    denoise_alone_ = create(kLevelOcclusionDenoiseFrag, Offscreen::kFormat);
  } catch (...) {
    destroy();
    throw;
  }
}

void LevelOcclusion::destroy() {
  for (VkPipeline pipeline : {find_, denoise_, denoise_alone_}) vkDestroyPipeline(device_, pipeline, nullptr);
}

void LevelOcclusion::recordPass(VkCommandBuffer commands, VkDescriptorSet set, Image& depth, Image& to, float clear,
                                VkPipeline pipeline) const {
  depth.use(commands, kTestedDepth);
  to.use(commands, kDrawnColour, true);
  VkRenderingAttachmentInfo colour = attachmentOf(to, kDrawnColour.layout, VK_ATTACHMENT_LOAD_OP_CLEAR);
  colour.clearValue.color.float32[0] = clear;
  const VkRenderingAttachmentInfo tested = attachmentOf(depth, kTestedDepth.layout, VK_ATTACHMENT_LOAD_OP_LOAD);
  beginRendering(commands, to.extent(), 1, &colour, &tested);
  if (pipeline != VK_NULL_HANDLE) {
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline);
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout_, 1, 1, &set, 0, nullptr);
    vkCmdDraw(commands, 3, 1, 0, 0);
  }
  vkCmdEndRendering(commands);
}

void LevelOcclusion::record(VkCommandBuffer commands, VkDescriptorSet set, Image& depth, OcclusionImages& images,
                            bool on) const {
  if (on) {
    recordPass(commands, set, depth, images.noisy, 1.0F, find_);
    images.noisy.use(commands, kSampled);
  }
  recordPass(commands, set, depth, images.visibility, 1.0F, on ? denoise_ : VkPipeline{VK_NULL_HANDLE});
  images.visibility.use(commands, kSampled);
}

void LevelOcclusion::recordAlone(VkCommandBuffer commands, VkDescriptorSet set, Image& depth, OcclusionImages& images,
                                 Image& picture) const {
  recordPass(commands, set, depth, images.noisy, 1.0F, find_);
  images.noisy.use(commands, kSampled);
  recordPass(commands, set, depth, picture, 0.0F, denoise_alone_);
}

}  // namespace welkin::render
