// SPDX-License-Identifier: Apache-2.0
// Draws into a float image and reads it back.
#include "render/offscreen.h"

#include <cstring>

namespace welkin::render {
Offscreen::Offscreen(VulkanDevice& device, uint32_t width, uint32_t height, VkImageUsageFlags more)
    : device_(device),
      image_(device, kFormat, {width, height},
             VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT | more),
      readback_(device, VkDeviceSize{16} * width * height, VK_BUFFER_USAGE_TRANSFER_DST_BIT) {}

FloatImage Offscreen::render(const std::function<void(VkCommandBuffer)>& draw) {
  return read([&](VkCommandBuffer commands) {
    image_.use(commands, kDrawnColour, true);
    const VkRenderingAttachmentInfo colour =
        attachmentOf(image_, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, VK_ATTACHMENT_LOAD_OP_CLEAR);
    beginRendering(commands, image_.extent(), 1, &colour, nullptr);
    draw(commands);
    vkCmdEndRendering(commands);
  });
}

FloatImage Offscreen::read(const std::function<void(VkCommandBuffer)>& record) {
  const VkExtent2D extent = image_.extent();
  device_.execute([&](VkCommandBuffer commands) {
    record(commands);
    image_.use(commands, kCopiedFrom);
    VkBufferImageCopy region{};
    region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    region.imageExtent = {extent.width, extent.height, 1};
    vkCmdCopyImageToBuffer(commands, image_.handle(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, readback_.handle(), 1,
                           &region);
    recordHostRead(commands, VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT);
  });
  FloatImage image{extent.width, extent.height, std::vector<float>(std::size_t{4} * extent.width * extent.height)};
  std::memcpy(image.rgba.data(), readback_.as<float>(), image.rgba.size() * sizeof(float));
  return image;
}

void beginRendering(VkCommandBuffer commands, VkExtent2D extent, uint32_t colour_count,
                    const VkRenderingAttachmentInfo* colours, const VkRenderingAttachmentInfo* depth) {
  VkRenderingInfo rendering{};
  rendering.sType = VK_STRUCTURE_TYPE_RENDERING_INFO;
  rendering.renderArea.extent = extent;
  rendering.layerCount = 1;
  rendering.colorAttachmentCount = colour_count;
  rendering.pColorAttachments = colours;
  rendering.pDepthAttachment = depth;
  vkCmdBeginRendering(commands, &rendering);
  const VkViewport viewport{0.0F, 0.0F, static_cast<float>(extent.width), static_cast<float>(extent.height),
                            0.0F, 1.0F};
  vkCmdSetViewport(commands, 0, 1, &viewport);
  vkCmdSetScissor(commands, 0, 1, &rendering.renderArea);
}

}  // namespace welkin::render
