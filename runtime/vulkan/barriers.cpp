// SPDX-License-Identifier: Apache-2.0
#include "vulkan/barriers.h"

namespace welkin::vulkan {

VkImageMemoryBarrier2 imageBarrier(VkImage image, VkPipelineStageFlags2 from, VkAccessFlags2 written,
                                   VkImageLayout old_layout, VkPipelineStageFlags2 to, VkAccessFlags2 access,
                                   VkImageLayout layout) {
  VkImageMemoryBarrier2 b{};
  b.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2;
  b.srcStageMask = from;
  b.srcAccessMask = written;
  b.dstStageMask = to;
  b.dstAccessMask = access;
  b.oldLayout = old_layout;
  b.newLayout = layout;
  b.srcQueueFamilyIndex = b.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  b.image = image;
  b.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
  return b;
}

void recordBarriers(const Device& device, VkCommandBuffer commands, const VkImageMemoryBarrier2* barriers,
                    uint32_t count) {
  VkDependencyInfo info{};
  info.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO;
  info.imageMemoryBarrierCount = count;
  info.pImageMemoryBarriers = barriers;
  device.fn.CmdPipelineBarrier2(commands, &info);
}

void recordBarrier(const Device& device, VkCommandBuffer commands, VkBuffer buffer, VkPipelineStageFlags2 from,
                   VkAccessFlags2 written, VkPipelineStageFlags2 to, VkAccessFlags2 access) {
  VkBufferMemoryBarrier2 b{};
  b.sType = VK_STRUCTURE_TYPE_BUFFER_MEMORY_BARRIER_2;
  b.srcStageMask = from;
  b.srcAccessMask = written;
  b.dstStageMask = to;
  b.dstAccessMask = access;
  b.srcQueueFamilyIndex = b.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  b.buffer = buffer;
  b.size = VK_WHOLE_SIZE;
  VkDependencyInfo info{};
  info.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO;
  info.bufferMemoryBarrierCount = 1;
  info.pBufferMemoryBarriers = &b;
  device.fn.CmdPipelineBarrier2(commands, &info);
}

}  // namespace welkin::vulkan
