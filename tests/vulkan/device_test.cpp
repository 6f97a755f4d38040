// SPDX-License-Identifier: Apache-2.0
// The choice of a device, and the message when there is none.
#include <catch2/catch.hpp>

#include "render/vulkan_device.h"
#include "sky/base/error.h"

namespace welkin::tests {

TEST_CASE("VulkanDevice, WithoutDriverIsAFileError", "[no-driver][.]") {
  try {
    const render::VulkanDevice device(false);
    FAIL("there is a driver: " << device.properties().deviceName);
  } catch (const base::Error& error) {
    CHECK(error.status() == base::ExitStatus::file);
    CHECK_THAT(error.what(), Catch::Contains("no driver found") || Catch::Contains("no device can be used"));
  }
}

TEST_CASE("VulkanDevice, ValidationSeesAMissingBarrier", "[synchronisation]") {
  // Two transfers write the same bytes with nothing in between. Only synchronisation validation can detect that.
  render::VulkanDevice device(true);
  const VkDevice vk = device.device();
  VkBufferCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
  info.size = 1024;
  info.usage = VK_BUFFER_USAGE_TRANSFER_DST_BIT;
  VkBuffer buffer = VK_NULL_HANDLE;
  render::require(vkCreateBuffer(vk, &info, nullptr, &buffer), "vkCreateBuffer");
  VkMemoryRequirements needs;
  vkGetBufferMemoryRequirements(vk, buffer, &needs);
  VkMemoryAllocateInfo allocate{};
  allocate.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
  allocate.allocationSize = needs.size;
  allocate.memoryTypeIndex = device.memoryType(needs.memoryTypeBits, 0);
  VkDeviceMemory memory = VK_NULL_HANDLE;
  render::require(vkAllocateMemory(vk, &allocate, nullptr, &memory), "vkAllocateMemory");
  render::require(vkBindBufferMemory(vk, buffer, memory, 0), "vkBindBufferMemory");
  device.execute([&](VkCommandBuffer commands) {
    vkCmdFillBuffer(commands, buffer, 0, VK_WHOLE_SIZE, 1);
    vkCmdFillBuffer(commands, buffer, 0, VK_WHOLE_SIZE, 2);
  });
  vkDestroyBuffer(vk, buffer, nullptr);
  vkFreeMemory(vk, memory, nullptr);
  CHECK(device.messageCount() > 0);
}

}  // namespace welkin::tests
