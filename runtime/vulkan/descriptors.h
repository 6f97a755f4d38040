// SPDX-License-Identifier: Apache-2.0
// The descriptor set of the sky (welkin/sky_bindings.h), one for every frame in flight.
#pragma once

#include "vulkan/memory.h"

namespace welkin::vulkan {

struct Descriptors {
  VkSampler fetch = VK_NULL_HANDLE;   ///< gradients, which shaders fetch without a filter
  VkSampler filter = VK_NULL_HANDLE;  ///< cubemaps and modes
  VkSampler wrap = VK_NULL_HANDLE;    ///< the star map, whose columns wrap
  VkDescriptorSetLayout layout = VK_NULL_HANDLE;
  VkDescriptorPool pool = VK_NULL_HANDLE;
  VkDescriptorSet sets[WELKIN_VULKAN_MAX_FRAMES_IN_FLIGHT] = {};
};

/// Creates samplers, layout, pool and `frames` sets.
WelkinResult createDescriptors(const Device& device, uint32_t frames, Descriptors& descriptors, WelkinMessage* message);
void destroy(const Device& device, Descriptors& descriptors);

/// Points a set at its slice of the uniform buffer, the two gradients, the star map and the modes' map. Called once.
void writeFixedBindings(const Device& device, const Descriptors& descriptors, uint32_t frame,
                        const VkDescriptorBufferInfo& constants, VkImageView gradient_sun, VkImageView gradient_anti,
                        VkImageView stars, VkImageView modes);

/// Points a set at its two cubemaps; the frame must not be in use.
void writeCubemaps(const Device& device, const Descriptors& descriptors, uint32_t frame, VkImageView first,
                   VkImageView second);

}  // namespace welkin::vulkan
