// SPDX-License-Identifier: Apache-2.0
// Memory and images owned by the caller: the pictures are the same, the library allocates nothing, and everything is
// given back.
#include <vector>

#include "object.h"
#include "test_sky.h"

namespace welkin::tests {
namespace {

/// Hands out one VkDeviceMemory for each allocation, at an offset of one alignment, and counts them.
struct Arena {
  render::VulkanDevice& device;
  int live = 0;
  int total = 0;

  static VkResult allocate(void* user, const VkMemoryRequirements* needs, VkMemoryPropertyFlags required,
                           VkMemoryPropertyFlags, WelkinVulkanAllocation* out) {
    auto& arena = *static_cast<Arena*>(user);
    VkMemoryAllocateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
    info.allocationSize = needs->size + needs->alignment;
    info.memoryTypeIndex = arena.device.memoryType(needs->memoryTypeBits, required);
    const VkResult result = vkAllocateMemory(arena.device.device(), &info, nullptr, &out->memory);
    if (result != VK_SUCCESS) return result;
    out->offset = needs->alignment;
    if ((required & VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT) != 0) {
      void* base = nullptr;
      vkMapMemory(arena.device.device(), out->memory, 0, VK_WHOLE_SIZE, 0, &base);
      out->mapped = static_cast<char*>(base) + out->offset;
    }
    ++arena.live;
    ++arena.total;
    return VK_SUCCESS;
  }
  static void free(void* user, const WelkinVulkanAllocation* allocation) {
    auto& arena = *static_cast<Arena*>(user);
    vkFreeMemory(arena.device.device(), allocation->memory, nullptr);
    --arena.live;
  }
};

std::vector<float> draw(render::VulkanDevice& device, const Sky& sky, const WelkinVulkanCreateInfo& info) {
  const SkyObject object(device, sky, info);
  WelkinSkySample sample{};
  REQUIRE(sky.sample(10.0, sample));
  REQUIRE(welkin_vulkan_update(object.get(), 0, &sample) == WELKIN_OK);
  render::Offscreen target(device, 16, 16);
  std::vector<float> pixels;
  for (const auto source : {WELKIN_VULKAN_ANALYTIC, WELKIN_VULKAN_CUBEMAP}) {
    const auto view = fisheye(source);
    const auto image = target.render(
        [&](VkCommandBuffer c) { CHECK(welkin_vulkan_draw_dome(object.get(), c, 0, &view) == WELKIN_OK); });
    pixels.insert(pixels.end(), image.rgba.begin(), image.rgba.end());
  }
  return pixels;
}

}  // namespace

TEST_CASE("VulkanOwnership, CallersMemory", "[vulkan]") {
  const auto bytes = testSkyFile({});
  const Sky sky = openTestSky(bytes);
  render::VulkanDevice device(true);
  Arena arena{device};
  const WelkinVulkanMemoryCallbacks callbacks{sizeof callbacks, 0, &arena, Arena::allocate, Arena::free};
  auto info = createInfo(device, 1);
  const auto expected = draw(device, sky, info);
  info.memory = &callbacks;
  CHECK(draw(device, sky, info) == expected);
  CHECK(arena.total == 3);
  CHECK(arena.live == 0);
  CHECK(device.messageCount() == 0);
}

TEST_CASE("VulkanOwnership, FailingMemoryIsReportedAndGivenBack", "[vulkan]") {
  const auto bytes = testSkyFile({});
  const Sky sky = openTestSky(bytes);
  render::VulkanDevice device(true);
  for (int successes = 0; successes < 3; ++successes) {
    struct Limited {
      Arena arena;
      int left;
    } limited{{device}, successes};
    const WelkinVulkanMemoryCallbacks callbacks{
        sizeof callbacks, 0, &limited,
        [](void* user, const VkMemoryRequirements* needs, VkMemoryPropertyFlags required,
           VkMemoryPropertyFlags preferred, WelkinVulkanAllocation* out) {
          auto& l = *static_cast<Limited*>(user);
          if (l.left-- == 0) return VK_ERROR_OUT_OF_DEVICE_MEMORY;
          return Arena::allocate(&l.arena, needs, required, preferred, out);
        },
        [](void* user, const WelkinVulkanAllocation* a) { Arena::free(&static_cast<Limited*>(user)->arena, a); }};
    auto info = createInfo(device, 1);
    info.memory = &callbacks;
    WelkinVulkanSky* object = nullptr;
    WelkinMessage message{};
    CHECK(welkin_vulkan_create(&info, sky.get(), &object, &message) == WELKIN_ERROR_MEMORY);
    CHECK(object == nullptr);
    CHECK(limited.arena.live == 0);
  }
  CHECK(device.messageCount() == 0);
}

TEST_CASE("VulkanOwnership, CallersImages", "[vulkan]") {
  const auto bytes = testSkyFile({});
  const Sky sky = openTestSky(bytes);
  render::VulkanDevice device(true);
  auto info = createInfo(device, 1);
  const auto expected = draw(device, sky, info);
  uint32_t count = 0;
  REQUIRE(welkin_vulkan_image_infos(sky.get(), &count, nullptr) == WELKIN_OK);
  std::vector<VkImageCreateInfo> infos(count);
  REQUIRE(welkin_vulkan_image_infos(sky.get(), &count, infos.data()) == WELKIN_OK);
  REQUIRE(count == 4 + sky.info().cubemap_count);
  std::vector<VkImage> images(count);
  std::vector<VkDeviceMemory> memory(count);
  for (uint32_t i = 0; i < count; ++i) {
    render::require(vkCreateImage(device.device(), &infos[i], nullptr, &images[i]), "vkCreateImage");
    VkMemoryRequirements needs;
    vkGetImageMemoryRequirements(device.device(), images[i], &needs);
    VkMemoryAllocateInfo allocate{};
    allocate.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
    allocate.allocationSize = needs.size;
    allocate.memoryTypeIndex = device.memoryType(needs.memoryTypeBits, 0);
    render::require(vkAllocateMemory(device.device(), &allocate, nullptr, &memory[i]), "vkAllocateMemory");
    render::require(vkBindImageMemory(device.device(), images[i], memory[i], 0), "vkBindImageMemory");
  }
  info.images = images.data();
  info.image_count = count - 1;
  WelkinVulkanSky* object = nullptr;
  CHECK(welkin_vulkan_create(&info, sky.get(), &object, nullptr) == WELKIN_ERROR_ARGUMENT);
  info.image_count = count;
  CHECK(draw(device, sky, info) == expected);
  for (uint32_t i = 0; i < count; ++i) {
    vkDestroyImage(device.device(), images[i], nullptr);
    vkFreeMemory(device.device(), memory[i], nullptr);
  }
  CHECK(device.messageCount() == 0);
}

}  // namespace welkin::tests
