// SPDX-License-Identifier: Apache-2.0
// The life of welkin_vulkan.h's object: its refusals, its contents, and the separation of frames in flight.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <new>

#include "allocations.h"
#include "object.h"
#include "render/views.h"
#include "test_sky.h"

namespace {
std::size_t allocations = 0;
}

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)  // The sanitizers replace these themselves.
constexpr bool kCountsAllocations = false;
#else
constexpr bool kCountsAllocations = true;
// Counts this program's allocations, including those of the library.
void* operator new(std::size_t bytes) {
  ++allocations;
  if (void* p = std::malloc(bytes == 0 ? 1 : bytes)) return p;
  throw std::bad_alloc();
}
void operator delete(void* p) noexcept {
  std::free(p);
}
void operator delete(void* p, std::size_t) noexcept {
  std::free(p);
}
#endif

namespace welkin::tests {

std::size_t allocationCount() {
  return allocations;
}

namespace {

std::string refusal(const WelkinVulkanCreateInfo& info, const Sky& sky, WelkinResult expected) {
  WelkinVulkanSky* object = nullptr;
  WelkinMessage message{};
  CHECK(welkin_vulkan_create(&info, sky.get(), &object, &message) == expected);
  CHECK(object == nullptr);
  return message.text;
}

}  // namespace

TEST_CASE("VulkanSky, RefusesBadCreateInfo", "[vulkan]") {
  const auto bytes = testSkyFile({});
  const Sky sky = openTestSky(bytes);
  render::VulkanDevice device(true);
  const WelkinVulkanCreateInfo good = createInfo(device, 2);
  WelkinVulkanCreateInfo info = good;
  info.struct_size = 8;
  CHECK_THAT(refusal(info, sky, WELKIN_ERROR_ARGUMENT), Catch::Contains("struct_size is 8"));
  info = good;
  info.frames_in_flight = 0;
  CHECK_THAT(refusal(info, sky, WELKIN_ERROR_ARGUMENT), Catch::Contains("frames_in_flight is 0"));
  info.frames_in_flight = WELKIN_VULKAN_MAX_FRAMES_IN_FLIGHT + 1;
  CHECK_THAT(refusal(info, sky, WELKIN_ERROR_ARGUMENT), Catch::Contains("must be 1 to 16"));
  info = good;
  info.device = VK_NULL_HANDLE;
  CHECK_THAT(refusal(info, sky, WELKIN_ERROR_ARGUMENT), Catch::Contains("must be given"));
  info = good;
  info.api_version = VK_API_VERSION_1_2;
  CHECK_THAT(refusal(info, sky, WELKIN_ERROR_DEVICE), Catch::Contains("1.3 is needed"));
  info = good;
  info.colour_format = VK_FORMAT_D32_SFLOAT;
  CHECK_THAT(refusal(info, sky, WELKIN_ERROR_DEVICE), Catch::Contains("colour_format"));
  info = good;
  info.get_instance_proc_addr = [](VkInstance instance, const char* name) -> PFN_vkVoidFunction {
    return std::string(name) == "vkGetDeviceProcAddr" ? nullptr : vkGetInstanceProcAddr(instance, name);
  };
  CHECK_THAT(refusal(info, sky, WELKIN_ERROR_DEVICE), Catch::Contains("vkGetDeviceProcAddr"));
  CHECK(welkin_vulkan_create(nullptr, sky.get(), nullptr, nullptr) == WELKIN_ERROR_ARGUMENT);
  welkin_vulkan_destroy(nullptr);
  CHECK(device.messageCount() == 0);
}

TEST_CASE("VulkanSky, FramesInFlightAreIndependent", "[vulkan]") {
  constexpr uint32_t kSize = 16;
  const auto bytes = testSkyFile({});
  const Sky sky = openTestSky(bytes);
  render::VulkanDevice device(true);
  const double hours[3] = {4.0, 12.0, 21.5};  // three different pairs of cubemaps
  for (const auto source : {WELKIN_VULKAN_ANALYTIC, WELKIN_VULKAN_CUBEMAP}) {
    std::vector<render::FloatImage> expected;
    {
      render::Views views(device, sky, source);
      for (const double time_h : hours) {
        views.setTime(time_h);
        expected.push_back(views.dome(kSize, kSize, false));
      }
    }
    const WelkinVulkanCreateInfo info = createInfo(device, 3);
    WelkinVulkanSky* object = nullptr;
    REQUIRE(welkin_vulkan_create(&info, sky.get(), &object, nullptr) == WELKIN_OK);
    device.execute(
        [&](VkCommandBuffer commands) { CHECK(welkin_vulkan_record_upload(object, commands) == WELKIN_OK); });
    welkin_vulkan_free_staging(object);
    for (uint32_t frame = 0; frame < 3; ++frame) {
      WelkinSkySample sample;
      REQUIRE(sky.sample(hours[frame], sample));
      REQUIRE(welkin_vulkan_update(object, frame, &sample) == WELKIN_OK);
    }
    render::Offscreen target(device, kSize, kSize);
    const WelkinVulkanView view = fisheye(source);
    for (uint32_t frame = 0; frame < 3; ++frame) {
      const render::FloatImage image = target.render([&](VkCommandBuffer commands) {
        CHECK(welkin_vulkan_draw_dome(object, commands, frame, &view) == WELKIN_OK);
      });
      CHECK(image.rgba == expected[frame].rgba);
    }
    CHECK(expected[0].rgba != expected[1].rgba);
    CHECK(expected[1].rgba != expected[2].rgba);
    welkin_vulkan_destroy(object);
  }
  CHECK(device.messageCount() == 0);
}

TEST_CASE("VulkanSky, RefusesCallsOutOfOrder", "[vulkan]") {
  const auto bytes = testSkyFile({.cubemaps = false});
  const Sky sky = openTestSky(bytes);
  render::VulkanDevice device(true);
  const WelkinVulkanCreateInfo info = createInfo(device, 2);
  WelkinVulkanSky* object = nullptr;
  REQUIRE(welkin_vulkan_create(&info, sky.get(), &object, nullptr) == WELKIN_OK);
  WelkinSkySample sample;
  REQUIRE(sky.sample(12.0, sample));
  const WelkinVulkanView view = fisheye(WELKIN_VULKAN_ANALYTIC);
  render::Offscreen target(device, 4, 4);
  const auto draw = [&](uint32_t frame, const WelkinVulkanView& v) {
    WelkinResult result = WELKIN_OK;
    target.render([&](VkCommandBuffer commands) { result = welkin_vulkan_draw_dome(object, commands, frame, &v); });
    return result;
  };
  CHECK(welkin_vulkan_update(object, 0, &sample) == WELKIN_OK);
  CHECK(draw(0, view) == WELKIN_ERROR_ARGUMENT);  // nothing uploaded
  device.execute([&](VkCommandBuffer commands) {
    CHECK(welkin_vulkan_record_upload(object, commands) == WELKIN_OK);
    CHECK(welkin_vulkan_record_upload(object, commands) == WELKIN_ERROR_ARGUMENT);
  });
  CHECK(draw(0, view) == WELKIN_OK);
  CHECK(draw(1, view) == WELKIN_ERROR_ARGUMENT);                            // not updated
  CHECK(draw(2, view) == WELKIN_ERROR_ARGUMENT);                            // no such frame
  CHECK(draw(0, fisheye(WELKIN_VULKAN_CUBEMAP)) == WELKIN_ERROR_ARGUMENT);  // the file has none
  WelkinVulkanView bad = view;
  bad.aspect = 0.0F;
  CHECK(draw(0, bad) == WELKIN_ERROR_ARGUMENT);
  bad = view;
  bad.depth = 1.5F;
  CHECK(draw(0, bad) == WELKIN_ERROR_ARGUMENT);
  CHECK(welkin_vulkan_update(object, 2, &sample) == WELKIN_ERROR_ARGUMENT);
  sample.cubemap[1] = 1;
  CHECK(welkin_vulkan_update(object, 0, &sample) == WELKIN_ERROR_ARGUMENT);
  CHECK(welkin_vulkan_descriptor_set(object, 2) == VK_NULL_HANDLE);
  CHECK(welkin_vulkan_descriptor_set(object, 1) != VK_NULL_HANDLE);

  WelkinVulkanMemory memory;
  REQUIRE(welkin_vulkan_memory(object, &memory) == WELKIN_OK);
  CHECK(memory.images >= (5 * 4 + 7 * 3) * 16);
  CHECK(memory.uniforms >= 2 * 560);
  CHECK(memory.staging > 0);
  welkin_vulkan_free_staging(object);
  REQUIRE(welkin_vulkan_memory(object, &memory) == WELKIN_OK);
  CHECK(memory.staging == 0);
  welkin_vulkan_destroy(object);
  CHECK(device.messageCount() == 0);
}

TEST_CASE("VulkanSky, FrameAllocatesNothing", "[vulkan]") {
  const auto bytes = testSkyFile({});
  const Sky sky = openTestSky(bytes);
  render::VulkanDevice device(false);  // the validation layer allocates in every call
  render::Views views(device, sky, WELKIN_VULKAN_CUBEMAP);
  const WelkinVulkanView view = fisheye(WELKIN_VULKAN_CUBEMAP);
  auto* object = const_cast<WelkinVulkanSky*>(views.runtime());
  render::Offscreen target(device, 4, 4);
  std::size_t during = 1;
  target.render([&](VkCommandBuffer commands) {
    const std::size_t before = allocations;
    CHECK((before > 0) == kCountsAllocations);
    for (int i = 0; i < 24; ++i) {
      WelkinSkySample sample;
      sky.sample(i, sample);
      welkin_vulkan_update(object, 0, &sample);
    }
    welkin_vulkan_draw_dome(object, commands, 0, &view);
    during = allocations - before;
  });
  CHECK(during == 0);
}

}  // namespace welkin::tests
