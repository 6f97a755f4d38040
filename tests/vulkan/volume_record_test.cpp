// SPDX-License-Identifier: Apache-2.0
// Recording of a volume's textures, frame after frame.
#include <catch2/catch.hpp>

#include "allocations.h"
#include "device_volume.h"
#include "tests/runtime/heap.h"
#include "tests/runtime/random_level.h"

namespace welkin::tests {

/// Neither from the game's allocator nor by operator new, once the textures are made. The driver's memory is not
/// counted.
TEST_CASE("VulkanVolume, RecordsAllocateNothing", "[vulkan]") {
  const RandomLevel baked(4, 60, 6, transfer::SunTransfer::directional, false);
  OpenedLevel opened(baked);
  render::VulkanDevice device(false);
  for (const WelkinVolumeFormat format : {WELKIN_VOLUME_RGBA16F, WELKIN_VOLUME_RGBA8, WELKIN_VOLUME_DEVICE}) {
    Heap heap;
    const WelkinAllocator allocator = heap.allocator();
    WelkinVolumeSettings settings{};
    settings.format = format;
    settings.texels[0] = settings.texels[2] = 24;
    settings.texels[1] = 8;
    settings.allocator = &allocator;
    WelkinVolume* volume = nullptr;
    render::require(welkin_volume_create(&settings, &volume), "welkin_volume_create");
    const WelkinVulkanCreateInfo info = render::createInfo(device, 2);
    WelkinVulkanVolume* textures = nullptr;
    render::require(welkin_vulkan_volume_create(&info, volume, &textures, nullptr), "welkin_vulkan_volume_create");
    const std::size_t created = heap.allocations;
    CHECK(created > 0);  // the counters work
    std::size_t of_record = 0, filled = 0;
    for (std::uint32_t frame = 0; frame < 60; ++frame) {
      if (frame == 40) {
        WelkinSector* sector = nullptr;
        REQUIRE(welkin_level_remove(opened.level, 1, 0, &sector) == WELKIN_OK);
        REQUIRE(welkin_level_add(opened.level, sector) == WELKIN_OK);
      }
      const WelkinSkySample sample = opened.relight(6.0 + 0.1 * frame);
      const float camera[3] = {3.0F * static_cast<float>(frame), 4, 30};
      WelkinVolumeUpdate update{};
      render::require(welkin_volume_update(volume, opened.level, &sample, camera, UINT32_MAX, &update), "update");
      filled += update.filled;
      WelkinResult result = WELKIN_OK;
      device.execute([&](VkCommandBuffer commands) {
        const std::size_t before = allocationCount();
        result = welkin_vulkan_volume_record(textures, commands, frame % 2, volume, &update);
        of_record += allocationCount() - before;
      });
      REQUIRE(result == WELKIN_OK);
    }
    INFO("format " << format);
    CHECK(of_record == 0);
    CHECK(filled > 10000);
    CHECK(heap.allocations == created);
    welkin_vulkan_volume_destroy(textures);
    welkin_volume_destroy(volume);
  }
}

}  // namespace welkin::tests
