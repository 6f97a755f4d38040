// SPDX-License-Identifier: Apache-2.0
// Buffers, images and their memory.
#include "vulkan/memory.h"

namespace welkin::vulkan {
namespace {

constexpr uint32_t kNoMemoryType = ~0U;

/// First memory type of `allowed` with all of `needed`; one with `preferred` too where there is one.
uint32_t findMemoryType(const Device& device, uint32_t allowed, VkMemoryPropertyFlags needed,
                        VkMemoryPropertyFlags preferred) {
  uint32_t found = kNoMemoryType;
  for (uint32_t i = 0; i < device.memory.memoryTypeCount; ++i) {
    const VkMemoryPropertyFlags flags = device.memory.memoryTypes[i].propertyFlags;
    if ((allowed & (1U << i)) == 0 || (flags & needed) != needed) continue;
    if ((flags & preferred) == preferred) return i;
    if (found == kNoMemoryType) found = i;
  }
  return found;
}

WelkinResult allocate(const Device& device, VkDeviceSize bytes, uint32_t type, const char* what, VkDeviceMemory& memory,
                      WelkinMessage* message) {
  if (type == kNoMemoryType) return fail(message, WELKIN_ERROR_DEVICE, "no memory type fits %s", what);
  VkMemoryAllocateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
  info.allocationSize = bytes;
  info.memoryTypeIndex = type;
  return check(device.fn.AllocateMemory(device.handle, &info, device.allocator, &memory), what, message);
}

}  // namespace

WelkinResult createMapped(const Device& device, VkDeviceSize bytes, VkBufferUsageFlags usage, const char* name,
                          MappedBuffer& buffer, WelkinMessage* message) {
  VkBufferCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
  info.size = bytes;
  info.usage = usage;
  info.sharingMode = VK_SHARING_MODE_EXCLUSIVE;
  if (const auto r =
          check(device.fn.CreateBuffer(device.handle, &info, device.allocator, &buffer.buffer), name, message))
    return r;
  VkMemoryRequirements needs;
  device.fn.GetBufferMemoryRequirements(device.handle, buffer.buffer, &needs);
  const VkMemoryPropertyFlags preferred =
      (usage & VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT) != 0 ? VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT : 0;
  const uint32_t type =
      findMemoryType(device, needs.memoryTypeBits,
                     VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT, preferred);
  if (const auto r = allocate(device, needs.size, type, name, buffer.memory, message)) return r;
  buffer.bytes = needs.size;
  if (const auto r = check(device.fn.BindBufferMemory(device.handle, buffer.buffer, buffer.memory, 0), name, message))
    return r;
  void* mapped = nullptr;
  if (const auto r =
          check(device.fn.MapMemory(device.handle, buffer.memory, 0, VK_WHOLE_SIZE, 0, &mapped), name, message))
    return r;
  buffer.mapped = static_cast<unsigned char*>(mapped);
  device.name(VK_OBJECT_TYPE_BUFFER, buffer.buffer, name);
  device.name(VK_OBJECT_TYPE_DEVICE_MEMORY, buffer.memory, name);
  return WELKIN_OK;
}

void destroy(const Device& device, MappedBuffer& buffer) {
  device.fn.DestroyBuffer(device.handle, buffer.buffer, device.allocator);
  device.fn.FreeMemory(device.handle, buffer.memory, device.allocator);  // unmaps it
  buffer = {};
}

namespace {

WelkinResult createImage(const Device& device, Image& image, WelkinMessage* message) {
  const bool cube = image.layers == 6;
  const uint32_t limit =
      cube ? device.properties.limits.maxImageDimensionCube : device.properties.limits.maxImageDimension2D;
  if (image.extent.width > limit || image.extent.height > limit)
    return fail(message, WELKIN_ERROR_DEVICE, "a %s of %u x %u texels: the device allows %u",
                cube ? "cubemap" : "gradient", image.extent.width, image.extent.height, limit);
  VkImageCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO;
  info.flags = cube ? VkImageCreateFlags{VK_IMAGE_CREATE_CUBE_COMPATIBLE_BIT} : 0;
  info.imageType = VK_IMAGE_TYPE_2D;
  info.format = image.format;
  info.extent = {image.extent.width, image.extent.height, 1};
  info.mipLevels = 1;
  info.arrayLayers = image.layers;
  info.samples = VK_SAMPLE_COUNT_1_BIT;
  info.tiling = VK_IMAGE_TILING_OPTIMAL;
  info.usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
  info.sharingMode = VK_SHARING_MODE_EXCLUSIVE;
  info.initialLayout = VK_IMAGE_LAYOUT_UNDEFINED;
  return check(device.fn.CreateImage(device.handle, &info, device.allocator, &image.image), "vkCreateImage", message);
}

WelkinResult createView(const Device& device, Image& image, WelkinMessage* message) {
  VkImageViewCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO;
  info.image = image.image;
  info.viewType = image.layers == 6 ? VK_IMAGE_VIEW_TYPE_CUBE : VK_IMAGE_VIEW_TYPE_2D;
  info.format = image.format;
  info.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, image.layers};
  const char* name = image.layers == 6 ? "welkin cubemap" : "welkin gradient";
  device.name(VK_OBJECT_TYPE_IMAGE, image.image, name);
  return check(device.fn.CreateImageView(device.handle, &info, device.allocator, &image.view), name, message);
}

}  // namespace

WelkinResult createImages(const Device& device, Image* images, uint32_t count, VkDeviceMemory& memory,
                          VkDeviceSize& memory_bytes, WelkinMessage* message) {
  uint32_t allowed = ~0U;
  VkDeviceSize total = 0;
  for (uint32_t i = 0; i < count; ++i) {
    if (const auto r = createImage(device, images[i], message)) return r;
    VkMemoryRequirements needs;
    device.fn.GetImageMemoryRequirements(device.handle, images[i].image, &needs);
    allowed &= needs.memoryTypeBits;
    total = (total + needs.alignment - 1) / needs.alignment * needs.alignment + needs.size;
  }
  const uint32_t type = findMemoryType(device, allowed, 0, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT);
  if (const auto r = allocate(device, total, type, "the memory of the images", memory, message)) return r;
  memory_bytes = total;
  device.name(VK_OBJECT_TYPE_DEVICE_MEMORY, memory, "welkin images");
  VkDeviceSize offset = 0;
  for (uint32_t i = 0; i < count; ++i) {
    VkMemoryRequirements needs;
    device.fn.GetImageMemoryRequirements(device.handle, images[i].image, &needs);
    offset = (offset + needs.alignment - 1) / needs.alignment * needs.alignment;
    if (const auto r = check(device.fn.BindImageMemory(device.handle, images[i].image, memory, offset),
                             "vkBindImageMemory", message))
      return r;
    offset += needs.size;
    if (const auto r = createView(device, images[i], message)) return r;
  }
  return WELKIN_OK;
}

void destroy(const Device& device, Image& image) {
  device.fn.DestroyImageView(device.handle, image.view, device.allocator);
  device.fn.DestroyImage(device.handle, image.image, device.allocator);
  image = {};
}

namespace {

void recordTransition(const Device& device, VkCommandBuffer commands, const Image& image,
                      VkImageMemoryBarrier2 barrier) {
  barrier.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2;
  barrier.srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  barrier.image = image.image;
  barrier.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, image.layers};
  VkDependencyInfo dependency{};
  dependency.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO;
  dependency.imageMemoryBarrierCount = 1;
  dependency.pImageMemoryBarriers = &barrier;
  device.fn.CmdPipelineBarrier2(commands, &dependency);
}

}  // namespace

void recordImageUpload(const Device& device, VkCommandBuffer commands, VkBuffer staging, const Image* images,
                       uint32_t count) {
  VkImageMemoryBarrier2 to_copy{};
  to_copy.srcStageMask = VK_PIPELINE_STAGE_2_NONE;
  to_copy.dstStageMask = VK_PIPELINE_STAGE_2_COPY_BIT;
  to_copy.dstAccessMask = VK_ACCESS_2_TRANSFER_WRITE_BIT;
  to_copy.oldLayout = VK_IMAGE_LAYOUT_UNDEFINED;
  to_copy.newLayout = VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL;
  VkImageMemoryBarrier2 to_read{};
  to_read.srcStageMask = VK_PIPELINE_STAGE_2_COPY_BIT;
  to_read.srcAccessMask = VK_ACCESS_2_TRANSFER_WRITE_BIT;
  // All commands: the same commands are then valid on a queue family that has no graphics stages.
  to_read.dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
  to_read.dstAccessMask = VK_ACCESS_2_SHADER_SAMPLED_READ_BIT;
  to_read.oldLayout = VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL;
  to_read.newLayout = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
  for (uint32_t i = 0; i < count; ++i) {
    recordTransition(device, commands, images[i], to_copy);
    VkBufferImageCopy region{};
    region.bufferOffset = images[i].staging_offset;
    region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, images[i].layers};
    region.imageExtent = {images[i].extent.width, images[i].extent.height, 1};
    device.fn.CmdCopyBufferToImage(commands, staging, images[i].image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1,
                                   &region);
    recordTransition(device, commands, images[i], to_read);
  }
}

}  // namespace welkin::vulkan
