// SPDX-License-Identifier: Apache-2.0
#include "render/float_texture.h"

#include <cstring>

namespace welkin::render {

FloatTexture::FloatTexture(VulkanDevice& device, const FloatImage& image)
    : image_(device, Offscreen::kFormat, {image.width, image.height},
             VK_IMAGE_USAGE_TRANSFER_DST_BIT | VK_IMAGE_USAGE_SAMPLED_BIT) {
  const Buffer staging(device, image.rgba.size() * sizeof(float), VK_BUFFER_USAGE_TRANSFER_SRC_BIT);
  std::memcpy(staging.as<float>(), image.rgba.data(), image.rgba.size() * sizeof(float));
  device.execute([&](VkCommandBuffer commands) {
    image_.use(commands, kCopiedTo, true);
    VkBufferImageCopy region{};
    region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    region.imageExtent = {image.width, image.height, 1};
    vkCmdCopyBufferToImage(commands, staging.handle(), image_.handle(), VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1,
                           &region);
    image_.use(commands, kSampled);
  });
}

}  // namespace welkin::render
