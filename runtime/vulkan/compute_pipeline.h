// SPDX-License-Identifier: Apache-2.0
// Creates a compute pipeline.
#pragma once

#include <span>

#include "vulkan/device.h"

namespace welkin::vulkan {

/// `words` is the shader's SPIR-V, whose entry point is main.
WelkinResult createComputePipeline(const Device& device, std::span<const uint32_t> words, VkPipelineCache cache,
                                   const char* name, VkPipelineLayout layout, VkPipeline& pipeline,
                                   WelkinMessage* message);

}  // namespace welkin::vulkan
