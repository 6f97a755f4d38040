// SPDX-License-Identifier: Apache-2.0
// Barriers of the volume's textures and buffers.
#pragma once

#include "vulkan/device.h"

namespace welkin::vulkan {

/// The stages that read the volume.
inline constexpr VkPipelineStageFlags2 kShaders =
    VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT | VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT;

/// A barrier for all of an image of one mip.
VkImageMemoryBarrier2 imageBarrier(VkImage image, VkPipelineStageFlags2 from, VkAccessFlags2 written,
                                   VkImageLayout old_layout, VkPipelineStageFlags2 to, VkAccessFlags2 access,
                                   VkImageLayout layout);

void recordBarriers(const Device& device, VkCommandBuffer commands, const VkImageMemoryBarrier2* barriers,
                    uint32_t count);

/// Records a barrier for all of a buffer.
void recordBarrier(const Device& device, VkCommandBuffer commands, VkBuffer buffer, VkPipelineStageFlags2 from,
                   VkAccessFlags2 written, VkPipelineStageFlags2 to, VkAccessFlags2 access);

}  // namespace welkin::vulkan
