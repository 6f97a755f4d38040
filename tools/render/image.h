// SPDX-License-Identifier: Apache-2.0
// A two-dimensional image with its memory and view. It knows its last use, so the next use alone determines the
// barrier.
#pragma once

#include "render/vulkan_device.h"

namespace welkin::render {

/// How a pass uses an image: the stages and accesses that touch it, and the layout they need.
struct ImageUse {
  VkPipelineStageFlags2 stages;
  VkAccessFlags2 access;
  VkImageLayout layout;
};

inline constexpr VkPipelineStageFlags2 kDepthTests =
    VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT;

inline constexpr ImageUse kUnused{VK_PIPELINE_STAGE_2_NONE, VK_ACCESS_2_NONE, VK_IMAGE_LAYOUT_UNDEFINED};
/// The uses of attachments include reading, because a pass may load an attachment or test against it.
inline constexpr ImageUse kDrawnColour{VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT,
                                       VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT | VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT,
                                       VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL};
inline constexpr ImageUse kDrawnDepth{
    kDepthTests, VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT | VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT,
    VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL};
/// Depth that one pass both tests against and samples.
inline constexpr ImageUse kTestedDepth{
    kDepthTests | VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT,
    VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT | VK_ACCESS_2_SHADER_SAMPLED_READ_BIT,
    VK_IMAGE_LAYOUT_DEPTH_READ_ONLY_OPTIMAL};
inline constexpr ImageUse kSampled{VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT, VK_ACCESS_2_SHADER_SAMPLED_READ_BIT,
                                   VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
inline constexpr ImageUse kSampledDepth{VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT, VK_ACCESS_2_SHADER_SAMPLED_READ_BIT,
                                        VK_IMAGE_LAYOUT_DEPTH_READ_ONLY_OPTIMAL};
inline constexpr ImageUse kCopiedFrom{VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_READ_BIT,
                                      VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL};
inline constexpr ImageUse kCopiedTo{VK_PIPELINE_STAGE_2_COPY_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
                                    VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL};

class Image {
 public:
  Image(const VulkanDevice& device, VkFormat format, VkExtent2D extent, VkImageUsageFlags usage);
  ~Image() { destroy(); }
  Image(const Image&) = delete;
  Image& operator=(const Image&) = delete;

  VkImage handle() const { return image_; }
  VkImageView view() const { return view_; }
  VkFormat format() const { return format_; }
  VkExtent2D extent() const { return extent_; }

  /// Records the barrier between the last use and the next. `discard` drops the image's content.
  void use(VkCommandBuffer commands, const ImageUse& next, bool discard = false);

 private:
  void create(const VulkanDevice& device, VkImageUsageFlags usage);
  void destroy();
  VkImageAspectFlags aspect() const;

  VkDevice device_;
  VkFormat format_;
  VkExtent2D extent_;
  VkImage image_ = VK_NULL_HANDLE;
  VkDeviceMemory memory_ = VK_NULL_HANDLE;
  VkImageView view_ = VK_NULL_HANDLE;
  ImageUse last_ = kUnused;
};

/// An attachment that is cleared to 0 or loaded, and then stored.
VkRenderingAttachmentInfo attachmentOf(const Image& image, VkImageLayout layout, VkAttachmentLoadOp load);

}  // namespace welkin::render
