// SPDX-License-Identifier: Apache-2.0
// The dome behind a scene, with depth test and multisampling, as in a game's own pass.
#include <catch2/catch.hpp>

#include "render/runtime_sky.h"
#include "render/views.h"
#include "test_sky.h"

namespace welkin::tests {
namespace {

constexpr uint32_t kEdge = 8;
constexpr VkFormat kDepthFormat = VK_FORMAT_D16_UNORM;  // every device can draw into it

/// An attachment of kEdge x kEdge with its own memory.
class Attachment {
 public:
  Attachment(const render::VulkanDevice& device, VkFormat format, VkImageUsageFlags usage, VkImageAspectFlags aspect,
             VkSampleCountFlagBits samples)
      : device_(device.device()), aspect_(aspect) {
    VkImageCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO;
    info.imageType = VK_IMAGE_TYPE_2D;
    info.format = format;
    info.extent = {kEdge, kEdge, 1};
    info.mipLevels = 1;
    info.arrayLayers = 1;
    info.samples = samples;
    info.usage = usage;
    render::require(vkCreateImage(device_, &info, nullptr, &image), "vkCreateImage");
    VkMemoryRequirements needs;
    vkGetImageMemoryRequirements(device_, image, &needs);
    VkMemoryAllocateInfo allocate{};
    allocate.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
    allocate.allocationSize = needs.size;
    allocate.memoryTypeIndex = device.memoryType(needs.memoryTypeBits, 0);
    render::require(vkAllocateMemory(device_, &allocate, nullptr, &memory_), "vkAllocateMemory");
    render::require(vkBindImageMemory(device_, image, memory_, 0), "vkBindImageMemory");
    VkImageViewCreateInfo view_info{};
    view_info.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO;
    view_info.image = image;
    view_info.viewType = VK_IMAGE_VIEW_TYPE_2D;
    view_info.format = format;
    view_info.subresourceRange = {aspect, 0, 1, 0, 1};
    render::require(vkCreateImageView(device_, &view_info, nullptr, &view), "vkCreateImageView");
  }
  ~Attachment() {
    vkDestroyImageView(device_, view, nullptr);
    vkDestroyImage(device_, image, nullptr);
    vkFreeMemory(device_, memory_, nullptr);
  }
  Attachment(const Attachment&) = delete;
  Attachment& operator=(const Attachment&) = delete;

  /// A full barrier is enough here: a transition between everything before and everything after.
  void transition(VkCommandBuffer commands, VkImageLayout from, VkImageLayout to) const {
    VkImageMemoryBarrier2 barrier{};
    barrier.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2;
    barrier.srcStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    barrier.srcAccessMask = VK_ACCESS_2_MEMORY_WRITE_BIT;
    barrier.dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    barrier.dstAccessMask = VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT;
    barrier.oldLayout = from;
    barrier.newLayout = to;
    barrier.srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.image = image;
    barrier.subresourceRange = {aspect_, 0, 1, 0, 1};
    VkDependencyInfo dependency{};
    dependency.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO;
    dependency.imageMemoryBarrierCount = 1;
    dependency.pImageMemoryBarriers = &barrier;
    vkCmdPipelineBarrier2(commands, &dependency);
  }

  VkImage image = VK_NULL_HANDLE;
  VkImageView view = VK_NULL_HANDLE;

 private:
  VkDevice device_;
  VkImageAspectFlags aspect_;
  VkDeviceMemory memory_ = VK_NULL_HANDLE;
};

/// Alpha of the middle pixel after drawing the dome at `depth` with 4 samples over depth 0.5. It is 1 where the dome
/// was drawn.
float drawnAlpha(render::VulkanDevice& device, const Sky& sky, VkCompareOp compare, float depth) {
  constexpr VkFormat kFormat = VK_FORMAT_R32G32B32A32_SFLOAT;
  WelkinVulkanCreateInfo info = render::createInfo(device, 1);
  info.colour_format = kFormat;
  info.depth_format = kDepthFormat;
  info.depth_compare = compare;
  info.samples = VK_SAMPLE_COUNT_4_BIT;
  WelkinVulkanSky* object = nullptr;
  REQUIRE(welkin_vulkan_create(&info, sky.get(), &object, nullptr) == WELKIN_OK);
  WelkinSkySample sample;
  REQUIRE(sky.sample(10.0, sample));
  REQUIRE(welkin_vulkan_update(object, 0, &sample) == WELKIN_OK);
  WelkinVulkanView view{};
  view.projection = WELKIN_VULKAN_FISHEYE;
  view.aspect = 1.0F;
  view.depth = depth;

  const Attachment colour(device, kFormat, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT, VK_IMAGE_ASPECT_COLOR_BIT,
                          VK_SAMPLE_COUNT_4_BIT);
  const Attachment resolved(device, kFormat, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT,
                            VK_IMAGE_ASPECT_COLOR_BIT, VK_SAMPLE_COUNT_1_BIT);
  const Attachment depths(device, kDepthFormat, VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT, VK_IMAGE_ASPECT_DEPTH_BIT,
                          VK_SAMPLE_COUNT_4_BIT);
  const render::Buffer readback(device, VkDeviceSize{16} * kEdge * kEdge, VK_BUFFER_USAGE_TRANSFER_DST_BIT);
  device.execute([&](VkCommandBuffer commands) {
    CHECK(welkin_vulkan_record_upload(object, commands) == WELKIN_OK);
    colour.transition(commands, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL);
    resolved.transition(commands, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL);
    depths.transition(commands, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL);
    VkRenderingAttachmentInfo colours{};
    colours.sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO;
    colours.imageView = colour.view;
    colours.imageLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
    colours.resolveMode = VK_RESOLVE_MODE_AVERAGE_BIT;
    colours.resolveImageView = resolved.view;
    colours.resolveImageLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
    colours.loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR;
    colours.storeOp = VK_ATTACHMENT_STORE_OP_DONT_CARE;
    VkRenderingAttachmentInfo depth_info{};
    depth_info.sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO;
    depth_info.imageView = depths.view;
    depth_info.imageLayout = VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL;
    depth_info.loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR;
    depth_info.storeOp = VK_ATTACHMENT_STORE_OP_DONT_CARE;
    depth_info.clearValue.depthStencil.depth = 0.5F;
    VkRenderingInfo rendering{};
    rendering.sType = VK_STRUCTURE_TYPE_RENDERING_INFO;
    rendering.renderArea.extent = {kEdge, kEdge};
    rendering.layerCount = 1;
    rendering.colorAttachmentCount = 1;
    rendering.pColorAttachments = &colours;
    rendering.pDepthAttachment = &depth_info;
    vkCmdBeginRendering(commands, &rendering);
    const VkViewport viewport{0.0F, 0.0F, float{kEdge}, float{kEdge}, 0.0F, 1.0F};
    vkCmdSetViewport(commands, 0, 1, &viewport);
    vkCmdSetScissor(commands, 0, 1, &rendering.renderArea);
    CHECK(welkin_vulkan_draw_dome(object, commands, 0, &view) == WELKIN_OK);
    vkCmdEndRendering(commands);
    resolved.transition(commands, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
    VkBufferImageCopy region{};
    region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    region.imageExtent = {kEdge, kEdge, 1};
    vkCmdCopyImageToBuffer(commands, resolved.image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, readback.handle(), 1,
                           &region);
  });
  const float alpha = readback.as<float>()[4 * (kEdge / 2 * kEdge + kEdge / 2) + 3];
  welkin_vulkan_destroy(object);
  return alpha;
}

}  // namespace

TEST_CASE("VulkanDome, IsDepthTestedUnderMultisampling", "[vulkan]") {
  const auto bytes = testSkyFile({});
  const Sky sky = openTestSky(bytes);
  render::VulkanDevice device(true);
  CHECK(drawnAlpha(device, sky, VK_COMPARE_OP_LESS_OR_EQUAL, 1.0F) == 0.0F);
  CHECK(drawnAlpha(device, sky, VK_COMPARE_OP_LESS_OR_EQUAL, 0.25F) == 1.0F);
  CHECK(drawnAlpha(device, sky, VK_COMPARE_OP_GREATER_OR_EQUAL, 1.0F) == 1.0F);
  CHECK(drawnAlpha(device, sky, VK_COMPARE_OP_GREATER_OR_EQUAL, 0.0F) == 0.0F);
  CHECK(device.messageCount() == 0);
}

}  // namespace welkin::tests
