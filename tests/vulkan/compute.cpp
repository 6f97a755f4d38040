// SPDX-License-Identifier: Apache-2.0
// Runs a compute shader over storage buffers.
#include "compute.h"

#include <algorithm>
#include <chrono>
#include <functional>
#include <limits>

#include "render/buffer.h"

namespace welkin::tests {

using render::Buffer;
using render::require;

namespace {

/// Prepares the shader, calls `use` with a function that runs it once and waits, and returns the output.
std::vector<float> withCompute(render::VulkanDevice& device, std::span<const uint32_t> spirv,
                               std::span<const float> input, std::size_t outputs, std::size_t per_invocation,
                               VkDescriptorSetLayout sky_layout, VkDescriptorSet sky,
                               const std::function<void(const std::function<void()>&)>& use) {
  const VkDevice vk = device.device();
  const Buffer in(device, input.size_bytes(), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
  const Buffer out(device, outputs * sizeof(float), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
  std::copy(input.begin(), input.end(), in.as<float>());

  const VkDescriptorSetLayoutBinding bindings[2] = {
      {0, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 1, VK_SHADER_STAGE_COMPUTE_BIT, nullptr},
      {1, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 1, VK_SHADER_STAGE_COMPUTE_BIT, nullptr}};
  VkDescriptorSetLayoutCreateInfo set_info{};
  set_info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
  set_info.bindingCount = 2;
  set_info.pBindings = bindings;
  VkDescriptorSetLayout layouts[2] = {VK_NULL_HANDLE, sky_layout};
  render::require(vkCreateDescriptorSetLayout(vk, &set_info, nullptr, &layouts[0]), "vkCreateDescriptorSetLayout");
  const VkDescriptorPoolSize size{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 2};
  VkDescriptorPoolCreateInfo pool_info{};
  pool_info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO;
  pool_info.maxSets = 1;
  pool_info.poolSizeCount = 1;
  pool_info.pPoolSizes = &size;
  VkDescriptorPool pool = VK_NULL_HANDLE;
  render::require(vkCreateDescriptorPool(vk, &pool_info, nullptr, &pool), "vkCreateDescriptorPool");
  VkDescriptorSetAllocateInfo allocate{};
  allocate.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO;
  allocate.descriptorPool = pool;
  allocate.descriptorSetCount = 1;
  allocate.pSetLayouts = layouts;
  VkDescriptorSet sets[2] = {VK_NULL_HANDLE, sky};
  render::require(vkAllocateDescriptorSets(vk, &allocate, sets), "vkAllocateDescriptorSets");
  const VkDescriptorBufferInfo buffers[2] = {{in.handle(), 0, VK_WHOLE_SIZE}, {out.handle(), 0, VK_WHOLE_SIZE}};
  VkWriteDescriptorSet write{};
  write.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
  write.dstSet = sets[0];
  write.descriptorCount = 2;
  write.descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
  write.pBufferInfo = buffers;
  vkUpdateDescriptorSets(vk, 1, &write, 0, nullptr);

  const uint32_t set_count = sky == VK_NULL_HANDLE ? 1 : 2;
  VkPipelineLayoutCreateInfo layout_info{};
  layout_info.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
  layout_info.setLayoutCount = set_count;
  layout_info.pSetLayouts = layouts;
  VkPipelineLayout layout = VK_NULL_HANDLE;
  render::require(vkCreatePipelineLayout(vk, &layout_info, nullptr, &layout), "vkCreatePipelineLayout");
  VkShaderModuleCreateInfo module_info{};
  module_info.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO;
  module_info.codeSize = spirv.size_bytes();
  module_info.pCode = spirv.data();
  VkShaderModule module = VK_NULL_HANDLE;
  render::require(vkCreateShaderModule(vk, &module_info, nullptr, &module), "vkCreateShaderModule");
  VkComputePipelineCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO;
  info.stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
  info.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
  info.stage.module = module;
  info.stage.pName = "main";
  info.layout = layout;
  VkPipeline pipeline = VK_NULL_HANDLE;
  render::require(vkCreateComputePipelines(vk, VK_NULL_HANDLE, 1, &info, nullptr, &pipeline),
                  "vkCreateComputePipelines");

  use([&] {
    device.execute([&](VkCommandBuffer commands) {
      vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline);
      vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, layout, 0, set_count, sets, 0, nullptr);
      vkCmdDispatch(commands, static_cast<uint32_t>((outputs / per_invocation + 63) / 64), 1, 1);
      render::recordHostRead(commands, VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT, VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT);
    });
  });
  std::vector<float> result(out.as<float>(), out.as<float>() + outputs);
  vkDestroyPipeline(vk, pipeline, nullptr);
  vkDestroyShaderModule(vk, module, nullptr);
  vkDestroyPipelineLayout(vk, layout, nullptr);
  vkDestroyDescriptorPool(vk, pool, nullptr);
  vkDestroyDescriptorSetLayout(vk, layouts[0], nullptr);
  return result;
}

}  // namespace

std::vector<float> runCompute(render::VulkanDevice& device, std::span<const uint32_t> spirv,
                              std::span<const float> input, std::size_t outputs, std::size_t per_invocation,
                              VkDescriptorSetLayout sky_layout, VkDescriptorSet sky) {
  return withCompute(device, spirv, input, outputs, per_invocation, sky_layout, sky, [](const auto& run) { run(); });
}

double computeSeconds(render::VulkanDevice& device, std::span<const uint32_t> spirv, std::span<const float> input,
                      std::size_t outputs, int runs, std::size_t per_invocation, VkDescriptorSetLayout sky_layout,
                      VkDescriptorSet sky) {
  double least_s = std::numeric_limits<double>::infinity();
  withCompute(device, spirv, input, outputs, per_invocation, sky_layout, sky, [&](const auto& run) {
    run();
    for (int i = 0; i < runs; ++i) {
      const auto start = std::chrono::steady_clock::now();
      run();
      least_s = std::min(least_s, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
  });
  return least_s;
}

}  // namespace welkin::tests
