// SPDX-License-Identifier: Apache-2.0
// The device's time of each pass of a picture, by timestamps.
#pragma once

#include <string>
#include <vector>

#include "render/vulkan_device.h"

namespace welkin::render {

struct PassTime {
  std::string name;
  double milliseconds = 0.0;
};

class PassTimes {
 public:
  /// On a device without timestamps nothing is measured.
  explicit PassTimes(const VulkanDevice& device);
  ~PassTimes();
  PassTimes(const PassTimes&) = delete;
  PassTimes& operator=(const PassTimes&) = delete;

  /// Begins a picture; before its first pass, outside of rendering.
  void begin(VkCommandBuffer commands);
  /// Ends a pass that began at the last call; outside of rendering. Of more than 15 passes the last are left out.
  void end(VkCommandBuffer commands, const char* name);
  /// The passes of the picture, once its commands have run.
  std::vector<PassTime> read() const;

 private:
  VkDevice device_;
  double period_ns_ = 0.0;
  VkQueryPool pool_ = VK_NULL_HANDLE;
  std::vector<std::string> names_;
};

}  // namespace welkin::render
