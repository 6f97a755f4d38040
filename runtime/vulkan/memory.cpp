// SPDX-License-Identifier: Apache-2.0
// Buffers, images and their memory.
#include "vulkan/memory.h"

#include "vulkan/barriers.h"

namespace welkin::vulkan {
namespace {

constexpr uint32_t kNoMemoryType = ~0U;

VkDeviceSize roundUp(VkDeviceSize bytes, VkDeviceSize to) {
  return (bytes + to - 1) / to * to;
}

/// First memory type of `allowed` with all of `needed` and `preferred`; if there is none, the first with all of
/// `needed`.
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

WelkinResult allocate(const Device& device, const VkMemoryRequirements& needs, VkMemoryPropertyFlags required,
                      VkMemoryPropertyFlags preferred, const char* what, WelkinVulkanAllocation& allocation,
                      WelkinMessage* message) {
  const bool mapped = (required & VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT) != 0;
  if (device.callbacks.allocate != nullptr) {
    const VkResult result = device.callbacks.allocate(device.callbacks.user, &needs, required, preferred, &allocation);
    if (result != VK_SUCCESS) allocation = {};
    if (const auto r = check(result, what, message)) return r;
    if (allocation.memory == VK_NULL_HANDLE || (mapped && allocation.mapped == nullptr))
      return fail(message, WELKIN_ERROR_ARGUMENT, "the caller's memory for %s is null or not mapped", what);
    return WELKIN_OK;
  }
  VkMemoryAllocateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
  info.allocationSize = needs.size;
  info.memoryTypeIndex = findMemoryType(device, needs.memoryTypeBits, required, preferred);
  if (info.memoryTypeIndex == kNoMemoryType) return fail(message, WELKIN_ERROR_DEVICE, "no memory type fits %s", what);
  if (const auto r =
          check(device.fn.AllocateMemory(device.handle, &info, device.allocator, &allocation.memory), what, message))
    return r;
  device.name(VK_OBJECT_TYPE_DEVICE_MEMORY, allocation.memory, what);
  if (!mapped) return WELKIN_OK;
  return check(device.fn.MapMemory(device.handle, allocation.memory, 0, VK_WHOLE_SIZE, 0, &allocation.mapped), what,
               message);
}

}  // namespace

WelkinResult allocateImages(const Device& device, const VkMemoryRequirements& block, const char* name,
                            WelkinVulkanAllocation& allocation, WelkinMessage* message) {
  return allocate(device, block, 0, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, name, allocation, message);
}

namespace {

/// Creates a buffer and says what memory it needs.
WelkinResult createBuffer(const Device& device, VkDeviceSize bytes, VkBufferUsageFlags usage, const char* name,
                          VkBuffer& buffer, VkMemoryRequirements& needs, WelkinMessage* message) {
  VkBufferCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
  info.size = bytes;
  info.usage = usage;
  info.sharingMode = VK_SHARING_MODE_EXCLUSIVE;
  if (const auto r = check(device.fn.CreateBuffer(device.handle, &info, device.allocator, &buffer), name, message))
    return r;
  device.fn.GetBufferMemoryRequirements(device.handle, buffer, &needs);
  device.name(VK_OBJECT_TYPE_BUFFER, buffer, name);
  return WELKIN_OK;
}

}  // namespace

WelkinResult createMapped(const Device& device, VkDeviceSize bytes, VkBufferUsageFlags usage, const char* name,
                          MappedBuffer& buffer, WelkinMessage* message) {
  VkMemoryRequirements needs;
  if (const auto r = createBuffer(device, bytes, usage, name, buffer.buffer, needs, message)) return r;
  const VkMemoryPropertyFlags preferred =
      (usage & VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT) != 0 ? VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT : 0;
  constexpr VkMemoryPropertyFlags kMapped = VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
  if (const auto r = allocate(device, needs, kMapped, preferred, name, buffer.allocation, message)) return r;
  buffer.bytes = needs.size;
  buffer.mapped = static_cast<unsigned char*>(buffer.allocation.mapped);
  return check(
      device.fn.BindBufferMemory(device.handle, buffer.buffer, buffer.allocation.memory, buffer.allocation.offset),
      name, message);
}

WelkinResult createLocal(const Device& device, VkDeviceSize bytes, VkBufferUsageFlags usage, const char* name,
                         LocalBuffer& buffer, WelkinMessage* message) {
  VkMemoryRequirements needs;
  if (const auto r = createBuffer(device, bytes, usage, name, buffer.buffer, needs, message)) return r;
  if (const auto r = allocate(device, needs, 0, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, name, buffer.allocation, message))
    return r;
  buffer.bytes = needs.size;
  return check(
      device.fn.BindBufferMemory(device.handle, buffer.buffer, buffer.allocation.memory, buffer.allocation.offset),
      name, message);
}

void destroy(const Device& device, MappedBuffer& buffer) {
  device.fn.DestroyBuffer(device.handle, buffer.buffer, device.allocator);
  freeMemory(device, buffer.allocation);
  buffer = {};
}

void destroy(const Device& device, LocalBuffer& buffer) {
  device.fn.DestroyBuffer(device.handle, buffer.buffer, device.allocator);
  freeMemory(device, buffer.allocation);
  buffer = {};
}

void freeMemory(const Device& device, WelkinVulkanAllocation& allocation) {
  if (device.callbacks.allocate == nullptr)
    device.fn.FreeMemory(device.handle, allocation.memory, device.allocator);  // this also unmaps it
  else if (allocation.memory != VK_NULL_HANDLE)
    device.callbacks.free(device.callbacks.user, &allocation);
  allocation = {};
}

uint32_t mipCount(uint32_t edge) {
  uint32_t mips = 1;
  while (edge >> mips != 0) ++mips;
  return mips;
}

VkImageCreateInfo imageInfo(const Image& image) {
  const bool cube = image.layers == 6;
  VkImageCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO;
  info.flags = cube ? VkImageCreateFlags{VK_IMAGE_CREATE_CUBE_COMPATIBLE_BIT} : 0;
  info.imageType = VK_IMAGE_TYPE_2D;
  info.format = image.format;
  info.extent = {image.extent.width, image.extent.height, 1};
  info.mipLevels = image.mips;
  info.arrayLayers = image.layers;
  info.samples = VK_SAMPLE_COUNT_1_BIT;
  info.tiling = VK_IMAGE_TILING_OPTIMAL;
  info.usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
  if (image.mips > 1 && image.blits_mips) info.usage |= VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
  info.sharingMode = VK_SHARING_MODE_EXCLUSIVE;
  info.initialLayout = VK_IMAGE_LAYOUT_UNDEFINED;
  return info;
}

namespace {

WelkinResult createImage(const Device& device, Image& image, WelkinMessage* message) {
  const bool cube = image.layers == 6;
  const uint32_t limit =
      cube ? device.properties.limits.maxImageDimensionCube : device.properties.limits.maxImageDimension2D;
  if (image.extent.width > limit || image.extent.height > limit)
    return fail(message, WELKIN_ERROR_DEVICE, "a %s of %u x %u texels: the device allows %u",
                cube ? "cubemap" : "gradient", image.extent.width, image.extent.height, limit);
  const VkImageCreateInfo info = imageInfo(image);
  return check(device.fn.CreateImage(device.handle, &info, device.allocator, &image.image), "vkCreateImage", message);
}

WelkinResult createView(const Device& device, Image& image, WelkinMessage* message) {
  VkImageViewCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO;
  info.image = image.image;
  info.viewType = image.layers == 6 ? VK_IMAGE_VIEW_TYPE_CUBE
                  : image.is_array  ? VK_IMAGE_VIEW_TYPE_2D_ARRAY
                                    : VK_IMAGE_VIEW_TYPE_2D;
  info.format = image.format;
  info.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, image.mips, 0, image.layers};
  const char* name = image.layers == 6 ? "welkin cubemap" : image.is_array ? "welkin modes" : "welkin gradient";
  device.name(VK_OBJECT_TYPE_IMAGE, image.image, name);
  return check(device.fn.CreateImageView(device.handle, &info, device.allocator, &image.view), name, message);
}

}  // namespace

WelkinResult createImages(const Device& device, Image* images, uint32_t count, WelkinVulkanAllocation& allocation,
                          VkDeviceSize& memory_bytes, WelkinMessage* message) {
  VkMemoryRequirements block{0, 1, ~0U};
  for (uint32_t i = 0; i < count; ++i) {
    if (images[i].borrowed) continue;
    if (const auto r = createImage(device, images[i], message)) return r;
    VkMemoryRequirements needs;
    device.fn.GetImageMemoryRequirements(device.handle, images[i].image, &needs);
    block.memoryTypeBits &= needs.memoryTypeBits;
    block.alignment = needs.alignment > block.alignment ? needs.alignment : block.alignment;
    block.size = roundUp(block.size, needs.alignment) + needs.size;
  }
  if (block.size > 0) {
    if (const auto r = allocateImages(device, block, "welkin images", allocation, message)) return r;
  }
  memory_bytes = block.size;
  VkDeviceSize offset = 0;
  for (uint32_t i = 0; i < count; ++i) {
    if (!images[i].borrowed) {
      VkMemoryRequirements needs;
      device.fn.GetImageMemoryRequirements(device.handle, images[i].image, &needs);
      offset = roundUp(offset, needs.alignment);
      if (const auto r = check(
              device.fn.BindImageMemory(device.handle, images[i].image, allocation.memory, allocation.offset + offset),
              "vkBindImageMemory", message))
        return r;
      offset += needs.size;
    }
    if (const auto r = createView(device, images[i], message)) return r;
  }
  return WELKIN_OK;
}

void destroy(const Device& device, Image& image) {
  device.fn.DestroyImageView(device.handle, image.view, device.allocator);
  if (!image.borrowed) device.fn.DestroyImage(device.handle, image.image, device.allocator);
  image = {};
}

namespace {

/// Records a barrier for a range of mips; `barrier` holds stages, accesses and layouts.
void recordTransition(const Device& device, VkCommandBuffer commands, const Image& image, uint32_t first_mip,
                      uint32_t mips, VkImageMemoryBarrier2 barrier) {
  barrier.image = image.image;
  barrier.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, first_mip, mips, 0, image.layers};
  recordBarriers(device, commands, &barrier, 1);
}

constexpr uint32_t kMostMips = 32;  // edges have 32 bits
constexpr VkPipelineStageFlags2 kTransfer = VK_PIPELINE_STAGE_2_COPY_BIT | VK_PIPELINE_STAGE_2_BLIT_BIT;

VkImageMemoryBarrier2 barrierOf(VkPipelineStageFlags2 from, VkAccessFlags2 written, VkImageLayout before,
                                VkPipelineStageFlags2 to, VkAccessFlags2 read, VkImageLayout after) {
  return imageBarrier(VK_NULL_HANDLE, from, written, before, to, read, after);
}

/// Fills the mips after the first, each from the one before. Leaves all but the last in the layout of a transfer
/// source.
void recordMips(const Device& device, VkCommandBuffer commands, const Image& image) {
  const auto to_source =
      barrierOf(kTransfer, VK_ACCESS_2_TRANSFER_WRITE_BIT, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                VK_PIPELINE_STAGE_2_BLIT_BIT, VK_ACCESS_2_TRANSFER_READ_BIT, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
  auto edge = static_cast<int32_t>(image.extent.width);
  for (uint32_t mip = 1; mip < image.mips; ++mip) {
    recordTransition(device, commands, image, mip - 1, 1, to_source);
    const int32_t half = edge > 1 ? edge / 2 : 1;
    VkImageBlit blit{};
    blit.srcSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, mip - 1, 0, image.layers};
    blit.srcOffsets[1] = {edge, edge, 1};
    blit.dstSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, mip, 0, image.layers};
    blit.dstOffsets[1] = {half, half, 1};
    device.fn.CmdBlitImage(commands, image.image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, image.image,
                           VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &blit, VK_FILTER_LINEAR);
    edge = half;
  }
}

}  // namespace

void recordImageUpload(const Device& device, VkCommandBuffer commands, VkBuffer staging, const Image* images,
                       uint32_t count) {
  const auto to_copy = barrierOf(VK_PIPELINE_STAGE_2_NONE, 0, VK_IMAGE_LAYOUT_UNDEFINED, kTransfer,
                                 VK_ACCESS_2_TRANSFER_WRITE_BIT, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
  const auto to_read = [](VkImageLayout before) {
    return barrierOf(kTransfer, VK_ACCESS_2_TRANSFER_WRITE_BIT, before, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT,
                     VK_ACCESS_2_SHADER_SAMPLED_READ_BIT, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
  };
  for (uint32_t i = 0; i < count; ++i) {
    const Image& image = images[i];
    recordTransition(device, commands, image, 0, image.mips, to_copy);
    VkBufferImageCopy region[kMostMips]{};
    VkDeviceSize offset = image.staging_offset;
    for (uint32_t mip = 0; mip < image.stagedMips(); ++mip) {
      region[mip].bufferOffset = offset;
      region[mip].imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, mip, 0, image.layers};
      region[mip].imageExtent = {Image::edgeAt(image.extent.width, mip), Image::edgeAt(image.extent.height, mip), 1};
      offset += image.mipBytes(mip);
    }
    device.fn.CmdCopyBufferToImage(commands, staging, image.image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                                   image.stagedMips(), region);
    if (image.blits_mips) recordMips(device, commands, image);
    const uint32_t blitted = image.blits_mips ? image.mips - 1 : 0;  // mips that were the source of a blit
    if (blitted > 0)
      recordTransition(device, commands, image, 0, blitted, to_read(VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL));
    recordTransition(device, commands, image, blitted, image.mips - blitted,
                     to_read(VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL));
  }
}

}  // namespace welkin::vulkan
