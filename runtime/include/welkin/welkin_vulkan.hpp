// SPDX-License-Identifier: Apache-2.0
// C++17 wrapper of welkin_vulkan.h, header only. It adds ownership and results with messages, nothing else.
#pragma once

#include <welkin/welkin_vulkan.h>

#include <vector>
#include <welkin/welkin.hpp>

namespace welkin {

/// Owns a WelkinVulkanSky. Movable; empty until `create` succeeds. No command buffer that uses it may be running when
/// it is destroyed.
class VulkanSky {
 public:
  VulkanSky() = default;
  VulkanSky(VulkanSky&& other) noexcept : object_(std::exchange(other.object_, nullptr)) {}
  VulkanSky& operator=(VulkanSky&& other) noexcept {
    std::swap(object_, other.object_);
    return *this;
  }
  VulkanSky(const VulkanSky&) = delete;
  VulkanSky& operator=(const VulkanSky&) = delete;
  ~VulkanSky() { welkin_vulkan_destroy(object_); }

  /// Creates the object and destroys the one held before. On an error the one held before stays.
  Status create(const WelkinVulkanCreateInfo& info, const Sky& sky) {
    WelkinVulkanSky* object = nullptr;
    WelkinMessage message{};
    const WelkinResult code = welkin_vulkan_create(&info, sky.get(), &object, &message);
    if (code != WELKIN_OK) return {code, message.text};
    welkin_vulkan_destroy(std::exchange(object_, object));
    return {};
  }
  void destroy() { welkin_vulkan_destroy(std::exchange(object_, nullptr)); }

  /// The object for the functions of welkin_vulkan.h; null before `create`.
  WelkinVulkanSky* get() const { return object_; }
  explicit operator bool() const { return object_ != nullptr; }

  Status recordUpload(VkCommandBuffer commands) { return statusOf(welkin_vulkan_record_upload(object_, commands)); }
  void freeStaging() { welkin_vulkan_free_staging(object_); }
  Status update(std::uint32_t frame, const WelkinSkySample& sample) {
    return statusOf(welkin_vulkan_update(object_, frame, &sample));
  }
  Status updateAmbient(std::uint32_t frame, const WelkinSkySample& blended) {
    return statusOf(welkin_vulkan_update_ambient(object_, frame, &blended));
  }
  Status drawDome(VkCommandBuffer commands, std::uint32_t frame, const WelkinVulkanView& view) const {
    return statusOf(welkin_vulkan_draw_dome(object_, commands, frame, &view));
  }
  VkDescriptorSetLayout descriptorSetLayout() const { return welkin_vulkan_descriptor_set_layout(object_); }
  VkDescriptorSet descriptorSet(std::uint32_t frame) const { return welkin_vulkan_descriptor_set(object_, frame); }
  /// Bytes of device memory that the object holds now; zeros before `create`.
  WelkinVulkanMemory memory() const {
    WelkinVulkanMemory memory{};
    welkin_vulkan_memory(object_, &memory);
    return memory;
  }

 private:
  WelkinVulkanSky* object_ = nullptr;
};

/// Describes the images of a sky, for a game that makes them. Empty when no sky is open.
inline std::vector<VkImageCreateInfo> imageInfos(const Sky& sky) {
  std::uint32_t count = 0;
  welkin_vulkan_image_infos(sky.get(), &count, nullptr);
  std::vector<VkImageCreateInfo> infos(count);
  welkin_vulkan_image_infos(sky.get(), &count, infos.data());
  return infos;
}

}  // namespace welkin
