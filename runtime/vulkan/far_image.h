// SPDX-License-Identifier: Apache-2.0
// Records the copy of a volume's far map to its image.
#pragma once

#include "probes/volume.h"
#include "vulkan/volume_images.h"

namespace welkin::vulkan {

/// Whether a rectangle lies in the far map.
bool fitsFarMap(const WelkinVulkanVolume& o, const WelkinFarBox& box);

/// Records the copy of an update's rectangles; of the whole map at first, and where `update` is null, as that of a
/// caller who does not know of the far map.
void recordFarMap(WelkinVulkanVolume& o, VkCommandBuffer commands, uint32_t frame, const WelkinVolume& volume,
                  const WelkinVolumeUpdate* update);

}  // namespace welkin::vulkan
