/* SPDX-License-Identifier: Apache-2.0
 * A Vulkan device for dump_vulkan.c, memory from it, and an image that the host reads. */
#pragma once

#include <vulkan/vulkan.h>
#include <welkin/welkin_vulkan.h>

#include "guard.h"

#define SIZE 32
#define REQUIRE(call)                      \
  do {                                     \
    if ((call) != VK_SUCCESS) fail(#call); \
  } while (0)

static VkInstance instance;
static VkPhysicalDevice physical;
static VkDevice device;
static VkQueue queue;
static VkCommandBuffer commands;

static void makeDevice(void) {
  const float priority = 1.0F;
  uint32_t count = 1;
  VkApplicationInfo application = {VK_STRUCTURE_TYPE_APPLICATION_INFO, NULL, NULL, 0, NULL, 0, VK_API_VERSION_1_3};
  VkInstanceCreateInfo instance_info = {VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO, NULL, 0, NULL, 0, NULL, 0, NULL};
  VkPhysicalDeviceVulkan13Features features;
  VkDeviceQueueCreateInfo queues = {VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO, NULL, 0, 0, 1, NULL};
  VkDeviceCreateInfo info = {VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO, NULL, 0, 1, NULL, 0, NULL, 0, NULL, NULL};
  VkCommandPoolCreateInfo pool_info = {VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO, NULL,
                                       VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT, 0};
  VkCommandBufferAllocateInfo buffers = {VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO, NULL, VK_NULL_HANDLE,
                                         VK_COMMAND_BUFFER_LEVEL_PRIMARY, 1};
  instance_info.pApplicationInfo = &application;
  REQUIRE(vkCreateInstance(&instance_info, NULL, &instance));
  if (vkEnumeratePhysicalDevices(instance, &count, &physical) < 0 || count == 0) fail("a Vulkan device");
  memset(&features, 0, sizeof features);
  features.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES;
  features.dynamicRendering = features.synchronization2 = VK_TRUE;
  queues.pQueuePriorities = &priority;
  info.pNext = &features;
  info.pQueueCreateInfos = &queues;
  REQUIRE(vkCreateDevice(physical, &info, NULL, &device));
  vkGetDeviceQueue(device, 0, 0, &queue);
  REQUIRE(vkCreateCommandPool(device, &pool_info, NULL, &buffers.commandPool));
  REQUIRE(vkAllocateCommandBuffers(device, &buffers, &commands));
}

static void begin(void) {
  VkCommandBufferBeginInfo info = {VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO, NULL, 0, NULL};
  REQUIRE(vkBeginCommandBuffer(commands, &info));
}

static void submit(void) {
  VkSubmitInfo info = {VK_STRUCTURE_TYPE_SUBMIT_INFO, NULL, 0, NULL, NULL, 1, &commands, 0, NULL};
  REQUIRE(vkEndCommandBuffer(commands));
  REQUIRE(vkQueueSubmit(queue, 1, &info, VK_NULL_HANDLE));
  REQUIRE(vkQueueWaitIdle(queue));
}

/* The caller's allocator. `user` counts the pieces that live. It never writes past its own struct's end. */
static VkResult allocate(void* user, const VkMemoryRequirements* needs, VkMemoryPropertyFlags required,
                         VkMemoryPropertyFlags preferred, WelkinVulkanAllocation* allocation) {
  VkPhysicalDeviceMemoryProperties properties;
  VkMemoryAllocateInfo info = {VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO, NULL, needs->size, 0};
  WelkinVulkanAllocation made;
  (void)preferred;
  memset(&made, 0, sizeof made);
  vkGetPhysicalDeviceMemoryProperties(physical, &properties);
  while (!(needs->memoryTypeBits & (1U << info.memoryTypeIndex)) ||
         (properties.memoryTypes[info.memoryTypeIndex].propertyFlags & required) != required)
    if (++info.memoryTypeIndex == properties.memoryTypeCount) return VK_ERROR_OUT_OF_DEVICE_MEMORY;
  REQUIRE(vkAllocateMemory(device, &info, NULL, &made.memory));
  if (required & VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT)
    REQUIRE(vkMapMemory(device, made.memory, 0, VK_WHOLE_SIZE, 0, &made.mapped));
  made.user = user;
  *allocation = made;
  ++*(int*)user;
  return VK_SUCCESS;
}

static void release(void* user, const WelkinVulkanAllocation* allocation) {
  if (allocation->user != user) fail("an allocation's user");
  vkFreeMemory(device, allocation->memory, NULL);
  --*(int*)user;
}

/* A linear image of SIZE x SIZE floats of four that the host reads. */
static const float* makeTarget(VkImage* image, VkImageView* view) {
  void* mapped = NULL;
  int pieces = 0;
  VkMemoryRequirements needs;
  WelkinVulkanAllocation memory;
  VkImageCreateInfo info = {VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO,
                            NULL,
                            0,
                            VK_IMAGE_TYPE_2D,
                            VK_FORMAT_R32G32B32A32_SFLOAT,
                            {SIZE, SIZE, 1},
                            1,
                            1,
                            VK_SAMPLE_COUNT_1_BIT,
                            VK_IMAGE_TILING_LINEAR,
                            VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT,
                            VK_SHARING_MODE_EXCLUSIVE,
                            0,
                            NULL,
                            VK_IMAGE_LAYOUT_UNDEFINED};
  VkImageViewCreateInfo view_info = {VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO,
                                     NULL,
                                     0,
                                     VK_NULL_HANDLE,
                                     VK_IMAGE_VIEW_TYPE_2D,
                                     VK_FORMAT_R32G32B32A32_SFLOAT,
                                     {0, 0, 0, 0},
                                     {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1}};
  VkImageSubresource part = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0};
  VkSubresourceLayout layout;
  REQUIRE(vkCreateImage(device, &info, NULL, image));
  vkGetImageMemoryRequirements(device, *image, &needs);
  REQUIRE(allocate(&pieces, &needs, VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT, 0,
                   &memory));
  mapped = memory.mapped;
  REQUIRE(vkBindImageMemory(device, *image, memory.memory, 0));
  view_info.image = *image;
  REQUIRE(vkCreateImageView(device, &view_info, NULL, view));
  vkGetImageSubresourceLayout(device, *image, &part, &layout);
  if (layout.rowPitch != SIZE * 16 || layout.offset != 0) fail("rows of the target");
  return mapped;
}
