// SPDX-License-Identifier: Apache-2.0
#include "render/pass_times.h"

#include <array>

namespace welkin::render {
namespace {

constexpr uint32_t kMostMarks = 16;

uint32_t timestampBits(const VulkanDevice& device) {
  uint32_t count = 0;
  vkGetPhysicalDeviceQueueFamilyProperties(device.physical(), &count, nullptr);
  std::vector<VkQueueFamilyProperties> families(count);
  vkGetPhysicalDeviceQueueFamilyProperties(device.physical(), &count, families.data());
  return families[device.queueFamily()].timestampValidBits;
}

}  // namespace

PassTimes::PassTimes(const VulkanDevice& device)
    : device_(device.device()), period_ns_(double{device.properties().limits.timestampPeriod}) {
  if (timestampBits(device) < 64) return;
  VkQueryPoolCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO;
  info.queryType = VK_QUERY_TYPE_TIMESTAMP;
  info.queryCount = kMostMarks;
  require(vkCreateQueryPool(device_, &info, nullptr, &pool_), "vkCreateQueryPool");
}

PassTimes::~PassTimes() {
  vkDestroyQueryPool(device_, pool_, nullptr);
}

void PassTimes::begin(VkCommandBuffer commands) {
  names_.clear();
  if (pool_ == VK_NULL_HANDLE) return;
  vkCmdResetQueryPool(commands, pool_, 0, kMostMarks);
  vkCmdWriteTimestamp2(commands, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, pool_, 0);
}

void PassTimes::end(VkCommandBuffer commands, const char* name) {
  if (pool_ == VK_NULL_HANDLE || names_.size() + 1 >= kMostMarks) return;
  names_.emplace_back(name);
  vkCmdWriteTimestamp2(commands, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, pool_, static_cast<uint32_t>(names_.size()));
}

std::vector<PassTime> PassTimes::read() const {
  if (names_.empty()) return {};
  std::array<uint64_t, kMostMarks> ticks{};
  const auto count = static_cast<uint32_t>(names_.size() + 1);
  require(vkGetQueryPoolResults(device_, pool_, 0, count, count * sizeof(uint64_t), ticks.data(), sizeof(uint64_t),
                                VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WAIT_BIT),
          "vkGetQueryPoolResults");
  std::vector<PassTime> times;
  for (std::size_t i = 0; i < names_.size(); ++i)
    times.push_back({names_[i], static_cast<double>(ticks[i + 1] - ticks[i]) * period_ns_ * 1e-6});
  return times;
}

}  // namespace welkin::render
