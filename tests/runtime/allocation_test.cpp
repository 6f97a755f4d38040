// SPDX-License-Identifier: Apache-2.0
// Counts every allocation of the process over a day of frames. There must be none after opening.
#include <welkin/engines.h>
#include <welkin/volume.h>

#include <atomic>
#include <catch2/catch.hpp>
#include <cstddef>

#include "sky/bake/encode.h"
#include "tests/runtime/random_level.h"

extern "C" void* __libc_malloc(std::size_t);
extern "C" void* __libc_calloc(std::size_t, std::size_t);
extern "C" void* __libc_realloc(void*, std::size_t);

namespace {
std::atomic<std::size_t> allocations = 0;
}

// glibc lets a program replace these functions. operator new uses them.
extern "C" void* malloc(std::size_t bytes) {
  ++allocations;
  return __libc_malloc(bytes);
}
extern "C" void* calloc(std::size_t count, std::size_t bytes) {
  ++allocations;
  return __libc_calloc(count, bytes);
}
extern "C" void* realloc(void* p, std::size_t bytes) {
  ++allocations;
  return __libc_realloc(p, bytes);
}

namespace welkin {
namespace {

/// A sky baked and opened in memory.
struct Opened {
  std::vector<std::byte> bytes;
  WelkinSky* sky = nullptr;

  Opened(bake::SkyFile file, int bands, const std::vector<double>& key_time_h) {
    file.settings = "{}";
    file.bake.key_time_h = key_time_h;
    bytes = bake::encodeSky(file, table::bakeDayTable(file.sky, bands, key_time_h, {}), {});
  }
  Opened(const Opened&) = delete;
  Opened& operator=(const Opened&) = delete;
  ~Opened() { welkin_sky_close(sky); }
  void open() { REQUIRE(welkin_sky_open_memory(bytes.data(), bytes.size(), &sky, nullptr) == WELKIN_OK); }
};

}  // namespace

TEST_CASE("Runtime, NothingAllocatesAfterOpening") {
  bake::SkyFile file;
  file.sky.sun.path.latitude_rad = 0.3;
  file.sky.moon = file.sky.sun;
  Opened opened(file, 5, {0.0, 6.0, 12.0, 18.0});
  const std::size_t before_opening = allocations;
  opened.open();
  const WelkinSky* sky = opened.sky;
  CHECK(allocations > before_opening);  // The counter works.

  WelkinSkySample first{}, second{}, blended{};
  std::size_t failures = 0;
  const std::size_t before = allocations;
  constexpr int kFrames = 24 * 60 * 60;
  for (int i = 0; i < kFrames; ++i) {
    const float direction[3] = {0.0F, 0.6F, 0.8F};
    float rgb[3];
    WelkinLight key;
    WelkinFilamentIrradianceOverPi filament;
    WelkinUnityIrradianceOverPi unity;
    WelkinRadianceSh radiance;
    WelkinFilamentRadiance filament_radiance;
    WelkinUnityProbe probe;
    WelkinUnrealIrradianceOverPi unreal;
    WelkinGodotIrradianceOverPi godot;
    const double time_h = 24.0 * i / kFrames;
    failures += welkin_sky_sample(sky, time_h, &first) != WELKIN_OK;
    failures += welkin_sky_sample(sky, time_h + 1.0, &second) != WELKIN_OK;
    failures += welkin_sample_blend(&first, &second, 0.5F, &blended) != WELKIN_OK;
    failures += welkin_sample_irradiance(&blended, direction, rgb) != WELKIN_OK;
    failures += welkin_sample_key_light(&blended, &key) != WELKIN_OK;
    failures += welkin_pack_filament(&blended, &filament) != WELKIN_OK;
    failures += welkin_pack_unity(&blended, &unity) != WELKIN_OK;
    failures += welkin_pack_radiance(&blended, WELKIN_AXES_UNREAL, &radiance) != WELKIN_OK;
    failures += welkin_pack_filament_radiance(&blended, &filament_radiance) != WELKIN_OK;
    failures += welkin_pack_unity_axes(&blended, WELKIN_AXES_UNITY, &unity) != WELKIN_OK;
    failures += welkin_pack_unity_probe(&blended, WELKIN_AXES_UNITY, &probe) != WELKIN_OK;
    failures += welkin_pack_unreal(&blended, &unreal) != WELKIN_OK;
    failures += welkin_pack_godot(&blended, &godot) != WELKIN_OK;
    failures += welkin_dome_radiance(sky, &first, direction, rgb) != WELKIN_OK;
    failures += welkin_disc_radiance(&first, direction, 0.001F, rgb) != WELKIN_OK;
    failures += welkin_star_radiance(sky, &first, direction, rgb) != WELKIN_OK;
  }
  const std::size_t after = allocations;
  CHECK(after - before == 0);
  CHECK(failures == 0);
}

TEST_CASE("Runtime, ADayOfALevelAllocatesNothing") {
  const tests::RandomLevel baked(4, 40, 6, transfer::SunTransfer::directional, true);
  const std::size_t before_opening = allocations;
  tests::OpenedLevel opened(baked);
  CHECK(allocations > before_opening);  // the counter works
  WelkinVolume* volume[2] = {};
  for (int i = 0; i < 2; ++i) {
    WelkinVolumeSettings settings{};
    settings.format = i == 0 ? WELKIN_VOLUME_RGBA16F : WELKIN_VOLUME_RGBA8;
    settings.texels[0] = settings.texels[2] = 16;
    settings.texels[1] = 4;
    REQUIRE(welkin_volume_create(&settings, &volume[i]) == WELKIN_OK);
  }
  WelkinLevel* level = opened.level;
  std::size_t failures = 0, served_points = 0;
  const std::size_t before = allocations;
  constexpr int kFrames = 24 * 60;
  for (int i = 0; i < kFrames; ++i) {
    WelkinSkySample sample{};
    WelkinLevelLight light{};
    light.sample = &sample;
    light.sky = light.sun_bounce = light.local = 1.0F;
    WelkinRelight relit{};
    failures += welkin_sky_sample(opened.sky, 24.0 * i / kFrames, &sample) != WELKIN_OK;
    failures += welkin_level_set_light(level, &light) != WELKIN_OK;
    failures += welkin_level_relight(level, 20, &relit) != WELKIN_OK;
    std::uint32_t count = 0;
    failures += welkin_level_relight_begin(level, 20, &count) != WELKIN_OK;
    failures += welkin_level_relight_range(level, 0, count) != WELKIN_OK;
    failures += welkin_level_relight_end(level, &relit) != WELKIN_OK;
    const float camera[3] = {200.0F * static_cast<float>(i) / kFrames - 70.0F, 5.0F, 30.0F},
                normal[3] = {0, 0.6F, 0.8F};
    if (i % 10 == 0) {  // the farthest sector leaves, and comes back
      std::int32_t x = 0, z = 0;
      WelkinSector* sector = nullptr;
      failures += welkin_level_farthest(level, camera, &x, &z) != WELKIN_OK;
      failures += welkin_level_remove(level, x, z, &sector) != WELKIN_OK;
      failures += welkin_level_add(level, sector) != WELKIN_OK;
    }
    float rgb[3];
    WelkinColours colours;
    std::uint8_t served = 0;
    failures += welkin_level_irradiance(level, 1, &camera, &normal, &rgb, &served) != WELKIN_OK;
    failures += welkin_level_colours(level, 1, &camera, &colours, nullptr) != WELKIN_OK;
    served_points += served;
    for (WelkinVolume* v : volume) {
      WelkinVolumeUpdate update{};
      failures += welkin_volume_update(v, level, &sample, camera, 256, &update) != WELKIN_OK;
      failures += welkin_volume_irradiance(v, camera, normal, rgb, nullptr) != WELKIN_OK;
    }
  }
  const std::size_t after = allocations;
  CHECK(after - before == 0);
  CHECK(failures == 0);
  CHECK(served_points > kFrames / 2);
  for (WelkinVolume* v : volume) welkin_volume_destroy(v);
}

TEST_CASE("Level, NothingAllocatesWhileSectorsStreamAndLightsMove") {
  tests::RandomLevel baked(3, 37, 10, transfer::SunTransfer::directional, false);
  baked.addLocal(40, 60);
  tests::OpenedLevel opened(baked);
  std::size_t failures = 0;
  const std::size_t before = allocations;
  for (int i = 0; i < 300; ++i) {
    WelkinSector* sector = nullptr;
    if (i % 10 == 0) {
      failures += welkin_level_remove(opened.level, i % 3 - 1, 0, &sector) != WELKIN_OK;
      failures += welkin_level_add(opened.level, sector) != WELKIN_OK;
    }
    WelkinPointLight lights[2] = {};
    for (WelkinPointLight& light : lights) {
      light.position[0] = 0.3F * static_cast<float>(i);
      light.position[2] = 30.0F;
      light.intensity[1] = 1.0F;
    }
    lights[1].direction[1] = -1.0F;
    lights[1].outer_rad = 0.7F;
    const auto see = [](void*, const float from[3], const float*) { return from[0] > 3.0F ? 1 : 0; };
    WelkinLightsResult result{};
    failures += welkin_level_set_lights(opened.level, 2, lights, see, nullptr, &result) != WELKIN_OK;
    failures += result.shared != 2;
    WelkinSkySample sample{};
    failures += welkin_sky_sample(opened.sky, 12.0 + i * 1e-3, &sample) != WELKIN_OK;
    WelkinLevelLight light{};
    light.sample = &sample;
    light.sky = light.sun_bounce = light.local = 1.0F;
    failures += welkin_level_set_light(opened.level, &light) != WELKIN_OK;
    failures += welkin_level_relight(opened.level, 50, nullptr) != WELKIN_OK;
    const float position[1][3] = {{10, 2, 30}}, normal[1][3] = {{0, 1, 0}};
    float irradiance[1][3];
    failures += welkin_level_irradiance(opened.level, 1, position, normal, irradiance, nullptr) != WELKIN_OK;
  }
  const std::size_t after = allocations;
  CHECK(after - before == 0);
  CHECK(failures == 0);
}

TEST_CASE("Runtime, SaysUnchanged") {
  bake::SkyFile file;
  file.sky.sun.path.latitude_rad = 0.3;
  Opened opened(file, 2, {0.0});
  opened.open();
  const WelkinSky* sky = opened.sky;
  WelkinSkySample sample{};
  REQUIRE(welkin_sky_sample(sky, 8.0, &sample) == WELKIN_OK);
  CHECK(sample.unchanged == 0);
  REQUIRE(welkin_sky_sample(sky, 32.0, &sample) == WELKIN_OK);  // the same hour of the next day
  CHECK(sample.unchanged == 1);
  REQUIRE(welkin_sky_sample(sky, 32.0, &sample) == WELKIN_OK);
  CHECK(sample.unchanged == 1);
  REQUIRE(welkin_sky_sample(sky, 8.001, &sample) == WELKIN_OK);
  CHECK(sample.unchanged == 0);
}

TEST_CASE("Runtime, LightsRiseWithoutAJump") {
  bake::SkyFile file;
  file.sky.sun.path.key_time_h = {0.0, 12.0};
  file.sky.sun.path.key_azimuth_rad = {0.0, 0.0};
  file.sky.sun.path.key_elevation_rad = {-0.1, 0.1};
  file.sky.sun.illuminance = base::Curve::constant(1.0);
  file.sky.sun.disc_radius_rad = 0.01;
  Opened opened(file, 2, {0.0});
  opened.open();
  const WelkinSky* sky = opened.sky;
  WelkinSkySample sample{};
  float last = 0.0F;
  for (int i = 0; i <= 1000; ++i) {
    REQUIRE(welkin_sky_sample(sky, 5.0 + 2.0 * i / 1000.0, &sample) == WELKIN_OK);
    REQUIRE(sample.sun.visible >= last);
    REQUIRE(sample.sun.visible - last < 0.003F);  // 1000 steps over 3.3 radii; the steepest slope is 2 / pi per radius
    last = sample.sun.visible;
  }
  CHECK(last == 1.0F);
  REQUIRE(welkin_sky_sample(sky, 6.0, &sample) == WELKIN_OK);
  CHECK(double{sample.sun.visible} == Approx(0.5).margin(1e-5));
  REQUIRE(welkin_sky_sample(sky, 5.0, &sample) == WELKIN_OK);
  CHECK(sample.sun.visible == 0.0F);
}

}  // namespace welkin
