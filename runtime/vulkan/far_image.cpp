// SPDX-License-Identifier: Apache-2.0
#include "vulkan/far_image.h"

#include <cstring>

#include "vulkan/barriers.h"

namespace welkin::vulkan {

bool fitsFarMap(const WelkinVulkanVolume& o, const WelkinFarBox& box) {
  for (int a = 0; a < 2; ++a)
    if (box.size[a] == 0 || box.first[a] >= o.far_edge || box.size[a] > o.far_edge - box.first[a]) return false;
  return true;
}

void recordFarMap(WelkinVulkanVolume& o, VkCommandBuffer commands, uint32_t frame, const WelkinVolume& volume,
                  const WelkinVolumeUpdate* update) {
  WelkinFarBox box[WELKIN_VOLUME_MAX_FAR_BOXES];
  uint32_t count = 0;
  std::size_t texels = 0;
  for (; update != nullptr && count < update->far_box_count; ++count) {
    box[count] = update->far_box[count];
    texels += std::size_t{box[count].size[0]} * box[count].size[1];
  }
  const bool is_whole = !o.far_recorded || update == nullptr || 4 * texels > o.farBytes();
  if (is_whole) {
    count = 1;
    box[0] = {{0, 0}, {o.far_edge, o.far_edge}};
  }
  if (count == 0) return;
  VkBufferImageCopy regions[WELKIN_VOLUME_MAX_FAR_BOXES]{};
  VkDeviceSize offset = frame * o.frame_bytes + o.farStaging();
  for (uint32_t b = 0; b < count; ++b) {
    const auto& [first, size] = box[b];
    regions[b].bufferOffset = offset;
    regions[b].imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    regions[b].imageOffset = {static_cast<int32_t>(first[0]), static_cast<int32_t>(first[1]), 0};
    regions[b].imageExtent = {size[0], size[1], 1};
    const VkDeviceSize row = VkDeviceSize{4} * size[0];
    for (uint32_t z = first[1]; z < first[1] + size[1]; ++z, offset += row)
      std::memcpy(o.staging.mapped + offset, volume.far_map.texels() + first[0] + std::size_t{o.far_edge} * z, row);
  }
  const VkImage image = o.images[o.farMap()];
  const auto before =
      imageBarrier(image, o.far_recorded ? kShaders : VK_PIPELINE_STAGE_2_NONE, VK_ACCESS_2_NONE,
                   is_whole ? VK_IMAGE_LAYOUT_UNDEFINED : VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL,
                   VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
  const auto after = imageBarrier(image, VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
                                  VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, kShaders, VK_ACCESS_2_SHADER_SAMPLED_READ_BIT,
                                  VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
  recordBarriers(o.device, commands, &before, 1);
  o.device.fn.CmdCopyBufferToImage(commands, o.staging.buffer, image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, count,
                                   regions);
  recordBarriers(o.device, commands, &after, 1);
  o.far_recorded = true;
}

}  // namespace welkin::vulkan
