// SPDX-License-Identifier: Apache-2.0
// The images of a sky on the device: two gradients, the stars, the modes, then the cubemaps. A missing one is replaced
// by a black image.
#pragma once

#include "vulkan/sky_object.h"

namespace welkin::vulkan {

inline constexpr uint32_t kStars = 2;  ///< index of the image after the two gradients
inline constexpr uint32_t kModes = 3;
inline constexpr uint32_t kFixed = 4;  ///< number of images before the cubemaps

/// The least multiple of `to` that is at least `bytes`.
constexpr VkDeviceSize alignUp(VkDeviceSize bytes, VkDeviceSize to) {
  return (bytes + to - 1) / to * to;
}

/// Creates the images, or takes the caller's, and fills the staging buffer with their texels.
WelkinResult createSkyImages(WelkinVulkanSky& o, const WelkinVulkanCreateInfo& create, const WelkinSky* sky,
                             WelkinMessage* message);

}  // namespace welkin::vulkan
