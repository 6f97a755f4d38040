// SPDX-License-Identifier: Apache-2.0
// A test device's WelkinVulkanSky that is ready to draw, destroyed at the end of its scope.
#pragma once

#include <catch2/catch.hpp>

#include "render/offscreen.h"
#include "render/runtime_sky.h"
#include "render/vulkan_device.h"
#include "welkin/welkin.hpp"
#include "welkin/welkin_vulkan.h"

namespace welkin::tests {

inline WelkinVulkanView fisheye(WelkinVulkanSource source) {
  WelkinVulkanView view{};
  view.source = source;
  view.projection = WELKIN_VULKAN_FISHEYE;
  view.aspect = 1.0F;
  return view;
}

/// Uploads the sky on construction.
class SkyObject {
 public:
  SkyObject(render::VulkanDevice& device, const Sky& sky, const WelkinVulkanCreateInfo& info) {
    WelkinMessage message{};
    const WelkinResult result = welkin_vulkan_create(&info, sky.get(), &object_, &message);
    INFO(message.text);
    REQUIRE(result == WELKIN_OK);
    device.execute([&](VkCommandBuffer c) { REQUIRE(welkin_vulkan_record_upload(object_, c) == WELKIN_OK); });
    welkin_vulkan_free_staging(object_);
  }
  SkyObject(const SkyObject&) = delete;
  SkyObject& operator=(const SkyObject&) = delete;
  ~SkyObject() { welkin_vulkan_destroy(object_); }

  WelkinVulkanSky* get() const { return object_; }

 private:
  WelkinVulkanSky* object_ = nullptr;
};

}  // namespace welkin::tests
