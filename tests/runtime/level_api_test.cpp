// SPDX-License-Identifier: Apache-2.0
// The rules that level.h and volume.h keep: sizes of structs, refusals and their reasons, order of calls, the game's
// memory.
#include <welkin/volume.h>
#include <welkin/volume_constants.h>

#include <catch2/catch.hpp>
#include <cstring>
#include <limits>
#include <string>

#include "tests/runtime/check_sizes.h"
#include "tests/runtime/heap.h"
#include "tests/runtime/random_level.h"

namespace welkin::tests {
namespace {

using transfer::SunTransfer;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kOrigin[3] = {10, 5, 20}, kUp[3] = {0, 1, 0};

/// Demands a refusal, with this reason.
void refusedFor(WelkinResult result, const std::string& reason) {
  CHECK(result == WELKIN_ERROR_ARGUMENT);
  CHECK(std::string(welkin_argument_error()) == reason);
}

WelkinLevelLight lightFrom(const WelkinSkySample& sample) {
  WelkinLevelLight light{};
  light.sample = &sample;
  light.sky = light.sun_bounce = light.local = 1.0F;
  return light;
}

struct OwnedVolume {
  WelkinVolume* volume = nullptr;
  OwnedVolume() {
    WelkinVolumeSettings settings{};
    settings.texels[0] = settings.texels[1] = settings.texels[2] = 4;
    REQUIRE(welkin_volume_create(&settings, &volume) == WELKIN_OK);
  }
  OwnedVolume(const OwnedVolume&) = delete;
  OwnedVolume& operator=(const OwnedVolume&) = delete;
  ~OwnedVolume() { welkin_volume_destroy(volume); }
};

RandomLevel smallLevel() {
  return RandomLevel(2, 12, 0, SunTransfer::none, false);
}

TEST_CASE("LevelApi, StructsKeepToTheirSize") {
  const RandomLevel baked = smallLevel();
  OpenedLevel opened(baked);
  const WelkinSkySample sample = opened.relight(9.0);
  WelkinLevel* level = opened.level;
  checkSizes<WelkinLevelInfo>(48, [&](WelkinLevelInfo* out) { return welkin_level_info(level, out); });
  checkSizes<WelkinRelight>(12, [&](WelkinRelight* out) { return welkin_level_relight(level, 1, out); });
  checkSizes<WelkinRelight>(12, [&](WelkinRelight* out) { return welkin_level_relight_end(level, out); });
  checkSizes<WelkinLightsResult>(
      20, [&](WelkinLightsResult* out) { return welkin_level_set_lights(level, 0, nullptr, nullptr, nullptr, out); });
  const OwnedVolume v;
  checkSizes<WelkinVolumeUpdate>(
      320, [&](WelkinVolumeUpdate* out) { return welkin_volume_update(v.volume, level, &sample, kOrigin, 1, out); });
}

TEST_CASE("LevelApi, InputsOfAnotherSizeAreRefused") {
  const RandomLevel baked = smallLevel();
  OpenedLevel opened(baked);
  const WelkinSkySample sample = opened.sampleAt(9.0);
  WelkinLevelLight light = lightFrom(sample);
  light.struct_size = sizeof light + 8;
  refusedFor(welkin_level_set_light(opened.level, &light),
             "welkin_level_set_light: light->struct_size is 40, must be the struct's size, 32 to 32 in this library");
  light.struct_size = 28;
  CHECK(welkin_level_set_light(opened.level, &light) == WELKIN_ERROR_ARGUMENT);
  WelkinSkySample other = sample;
  other.struct_size = 936 - 4;  // below that of the first release
  light = lightFrom(other);
  CHECK(welkin_level_set_light(opened.level, &light) == WELKIN_ERROR_ARGUMENT);
  const OwnedVolume v;
  WelkinVolumeUpdate update{};
  CHECK(welkin_volume_update(v.volume, opened.level, &other, kOrigin, 1, &update) == WELKIN_ERROR_ARGUMENT);
  WelkinVolumeSettings settings{};
  settings.struct_size = 4;
  WelkinVolume* none = v.volume;
  CHECK(welkin_volume_create(&settings, &none) == WELKIN_ERROR_ARGUMENT);
  CHECK(none == nullptr);
  WelkinOpenInfo info{};
  info.data = opened.files[1].data();
  info.size = opened.files[1].size;
  WelkinLevelLimits limits{};
  limits.struct_size = 16;
  WelkinLevel* no_level = opened.level;
  WelkinMessage message{};
  CHECK(welkin_level_open(&info, opened.sky, &limits, &no_level, &message) == WELKIN_ERROR_ARGUMENT);
  CHECK(no_level == nullptr);
  CHECK(std::string(message.text) ==
        "welkin_level_open: limits->struct_size is 16, must be the struct's size, 12 to 12 in this library");
}

TEST_CASE("LevelApi, NullIsRefused") {
  const RandomLevel baked = smallLevel();
  OpenedLevel opened(baked);
  const WelkinSkySample sample = opened.relight(9.0);
  WelkinLevel* level = opened.level;
  const OwnedVolume v;
  WelkinOpenInfo info{};
  info.data = opened.files[1].data();
  info.size = opened.files[1].size;
  WelkinLevel* out = nullptr;
  WelkinMessage message{};
  CHECK(welkin_level_open(nullptr, opened.sky, nullptr, &out, &message) == WELKIN_ERROR_ARGUMENT);
  CHECK(std::string(message.text) == "welkin_level_open: info is null");
  CHECK(welkin_level_open(&info, nullptr, nullptr, &out, &message) == WELKIN_ERROR_ARGUMENT);
  CHECK(std::string(message.text) == "welkin_level_open: sky is null");
  CHECK(welkin_level_open(&info, opened.sky, nullptr, nullptr, nullptr) == WELKIN_ERROR_ARGUMENT);
  WelkinSector* sector = nullptr;
  const AlignedBytes& file = opened.files[2];
  CHECK(welkin_sector_open(nullptr, file.data(), file.size, &sector, nullptr) == WELKIN_ERROR_ARGUMENT);
  CHECK(welkin_sector_open(level, nullptr, 9, &sector, nullptr) == WELKIN_ERROR_ARGUMENT);
  CHECK(welkin_sector_open(level, file.data(), file.size, nullptr, nullptr) == WELKIN_ERROR_ARGUMENT);
  std::int32_t x = 0, z = 0;
  std::uint32_t count = 0;
  float rgb[3], sh[4][3];
  WelkinColours colours{};
  WelkinLevelInfo described{};
  WelkinSectorEntry entry{};
  WelkinVolumeUpdate update{};
  WelkinVolumeConstants constants{};
  const void* texels = nullptr;
  std::uint32_t extent[3];
  std::size_t bytes = 0;
  const WelkinLevelLight light = lightFrom(sample), dark = WelkinLevelLight{};
  const WelkinVolumeSettings settings{};
  const WelkinResult results[] = {welkin_level_info(nullptr, &described),
                                  welkin_level_info(level, nullptr),
                                  welkin_level_entry(nullptr, 0, &entry),
                                  welkin_level_entry(level, 0, nullptr),
                                  welkin_level_add(nullptr, sector),
                                  welkin_level_add(level, nullptr),
                                  welkin_level_remove(nullptr, 0, 0, &sector),
                                  welkin_level_remove(level, 0, 0, nullptr),
                                  welkin_level_farthest(nullptr, kOrigin, &x, &z),
                                  welkin_level_farthest(level, nullptr, &x, &z),
                                  welkin_level_farthest(level, kOrigin, nullptr, &z),
                                  welkin_level_farthest(level, kOrigin, &x, nullptr),
                                  welkin_level_set_light(nullptr, &light),
                                  welkin_level_set_light(level, nullptr),
                                  welkin_level_set_light(level, &dark),
                                  welkin_level_set_lights(nullptr, 0, nullptr, nullptr, nullptr, nullptr),
                                  welkin_level_set_lights(level, 1, nullptr, nullptr, nullptr, nullptr),
                                  welkin_level_relight(nullptr, 1, nullptr),
                                  welkin_level_relight_begin(nullptr, 1, &count),
                                  welkin_level_relight_begin(level, 1, nullptr),
                                  welkin_level_relight_range(nullptr, 0, 0),
                                  welkin_level_relight_end(nullptr, nullptr),
                                  welkin_level_irradiance(nullptr, 1, &kOrigin, &kUp, &rgb, nullptr),
                                  welkin_level_irradiance(level, 1, nullptr, &kUp, &rgb, nullptr),
                                  welkin_level_irradiance(level, 1, &kOrigin, nullptr, &rgb, nullptr),
                                  welkin_level_irradiance(level, 1, &kOrigin, &kUp, nullptr, nullptr),
                                  welkin_level_colours(nullptr, 1, &kOrigin, &colours, nullptr),
                                  welkin_level_colours(level, 1, nullptr, &colours, nullptr),
                                  welkin_level_colours(level, 1, &kOrigin, nullptr, nullptr),
                                  welkin_colours_irradiance(nullptr, kUp, rgb),
                                  welkin_colours_irradiance(&colours, nullptr, rgb),
                                  welkin_colours_irradiance(&colours, kUp, nullptr),
                                  welkin_colours_sh(nullptr, sh),
                                  welkin_colours_sh(&colours, nullptr),
                                  welkin_volume_create(nullptr, nullptr),
                                  welkin_volume_create(&settings, nullptr),
                                  welkin_volume_update(nullptr, level, &sample, kOrigin, 1, &update),
                                  welkin_volume_update(v.volume, nullptr, &sample, kOrigin, 1, &update),
                                  welkin_volume_update(v.volume, level, nullptr, kOrigin, 1, &update),
                                  welkin_volume_update(v.volume, level, &sample, nullptr, 1, &update),
                                  welkin_volume_update(v.volume, level, &sample, kOrigin, 1, nullptr),
                                  welkin_volume_texels(nullptr, 0, &texels, &bytes),
                                  welkin_volume_texels(v.volume, 0, nullptr, &bytes),
                                  welkin_volume_texels(v.volume, 0, &texels, nullptr),
                                  welkin_volume_cuts(nullptr, &texels, &bytes),
                                  welkin_volume_cuts(v.volume, nullptr, &bytes),
                                  welkin_volume_cuts(v.volume, &texels, nullptr),
                                  welkin_volume_extent(nullptr, extent),
                                  welkin_volume_extent(v.volume, nullptr),
                                  welkin_volume_constants(nullptr, &constants, sizeof constants),
                                  welkin_volume_constants(v.volume, nullptr, sizeof constants),
                                  welkin_volume_irradiance(nullptr, kOrigin, kUp, rgb, nullptr),
                                  welkin_volume_irradiance(v.volume, nullptr, kUp, rgb, nullptr),
                                  welkin_volume_irradiance(v.volume, kOrigin, nullptr, rgb, nullptr),
                                  welkin_volume_irradiance(v.volume, kOrigin, kUp, nullptr, nullptr)};
  for (std::size_t i = 0; i < std::size(results); ++i) {
    INFO("call " << i);
    CHECK(results[i] == WELKIN_ERROR_ARGUMENT);
  }
  welkin_level_close(nullptr);
  welkin_sector_close(nullptr);
  welkin_volume_destroy(nullptr);
  CHECK(welkin_level_irradiance(level, 0, nullptr, nullptr, nullptr, nullptr) == WELKIN_OK);  // no points, no arrays
  CHECK(welkin_level_colours(level, 0, nullptr, nullptr, nullptr) == WELKIN_OK);
}

TEST_CASE("LevelApi, NumbersOutOfTheirDomainAreRefused") {
  const RandomLevel baked = smallLevel();
  OpenedLevel opened(baked);
  const WelkinSkySample sample = opened.relight(9.0);
  WelkinLevel* level = opened.level;
  const OwnedVolume v;
  float rgb[3];
  WelkinColours colours{};
  WelkinVolumeUpdate update{};
  std::int32_t x = 0, z = 0;
  for (const float bad : {kNan, kInfinity, -kInfinity})
    for (int axis = 0; axis < 3; ++axis) {
      float position[3] = {10, 5, 20};
      position[axis] = bad;
      refusedFor(welkin_level_irradiance(level, 1, &position, &kUp, &rgb, nullptr),
                 "welkin_level_irradiance: position 0 is not finite");
      refusedFor(welkin_level_colours(level, 1, &position, &colours, nullptr),
                 "welkin_level_colours: position 0 is not finite");
      CHECK(welkin_volume_irradiance(v.volume, position, kUp, rgb, nullptr) == WELKIN_ERROR_ARGUMENT);
      CHECK(welkin_volume_update(v.volume, level, &sample, position, 1, &update) == WELKIN_ERROR_ARGUMENT);
      CHECK(welkin_level_farthest(level, position, &x, &z) == (axis == 1 ? WELKIN_OK : WELKIN_ERROR_ARGUMENT));
      float normal[3] = {0, 1, 0};
      normal[axis] = bad;
      CHECK(welkin_level_irradiance(level, 1, &kOrigin, &normal, &rgb, nullptr) == WELKIN_ERROR_ARGUMENT);
      CHECK(welkin_colours_irradiance(&colours, normal, rgb) == WELKIN_ERROR_ARGUMENT);
      CHECK(welkin_volume_irradiance(v.volume, kOrigin, normal, rgb, nullptr) == WELKIN_ERROR_ARGUMENT);
    }
  const float places[3][3] = {{10, 5, 20}, {11, 5, 20}, {12, 5, 20}};
  const float normals[3][3] = {{0, 1, 0}, {0, 1, 0}, {0, kNan, 0}};
  float lit[3][3];
  refusedFor(welkin_level_irradiance(level, 3, places, normals, lit, nullptr),
             "welkin_level_irradiance: normal 2 has the length nan, must be a unit vector");
  const float far[3] = {3e38F, -3e38F, 3e38F}, away[3] = {1.1e7F, 0, 0};
  std::uint8_t served = 2;
  CHECK(welkin_level_irradiance(level, 1, &far, &kUp, &rgb, &served) == WELKIN_OK);  // finite: nothing serves there
  CHECK((served == 0 && rgb[0] == 0.0F));
  refusedFor(welkin_volume_update(v.volume, level, &sample, away, 1, &update),
             "welkin_volume_update: camera[0] is 1.1e+07, must be within 1e7 m");
  for (const auto& normal : {std::array<float, 3>{0, 0.998F, 0}, {0, 1.0011F, 0}, {0, 0, 0}, {1, 1, 0}})
    CHECK(welkin_volume_irradiance(v.volume, kOrigin, normal.data(), rgb, nullptr) == WELKIN_ERROR_ARGUMENT);
  for (const float bad : {kNan, kInfinity, -0.5F}) {
    WelkinLevelLight light = lightFrom(sample);
    light.sun_bounce = bad;
    CHECK(welkin_level_set_light(level, &light) == WELKIN_ERROR_ARGUMENT);
    WelkinVolumeSettings settings{};
    settings.texel_height_m = bad;
    WelkinVolume* none = nullptr;
    CHECK(welkin_volume_create(&settings, &none) == WELKIN_ERROR_ARGUMENT);
  }
  WelkinLevelLight light = lightFrom(sample);
  light.sky = -1.0F;
  refusedFor(welkin_level_set_light(level, &light),
             "welkin_level_set_light: light->sky is -1, must be finite and at least 0");
  WelkinVolumeSettings settings{};
  WelkinVolume* none = nullptr;
  settings.texels[1] = 513;
  refusedFor(welkin_volume_create(&settings, &none),
             "welkin_volume_create: settings->texels[1] is 513, must be 0 or 2 to 512");
  settings.texels[1] = 1;
  CHECK(welkin_volume_create(&settings, &none) == WELKIN_ERROR_ARGUMENT);
  const void* texels = nullptr;
  std::size_t bytes = 0;
  refusedFor(welkin_volume_texels(v.volume, 3, &texels, &bytes), "welkin_volume_texels: channel is 3, must be 0 to 2");
  WelkinSectorEntry entry{};
  refusedFor(welkin_level_entry(level, 2, &entry), "welkin_level_entry: index is 2, must be below 2");
}

TEST_CASE("LevelApi, ASampleThatIsNotFiniteDoesNoHarm") {
  const RandomLevel baked(2, 12, 4, SunTransfer::directional, false);
  OpenedLevel opened(baked);
  const WelkinSkySample right = opened.relight(12.0);
  for (const float bad : {kNan, kInfinity, -kInfinity, 3e38F}) {
    WelkinSkySample sample = right;
    for (auto& coefficient : sample.ambient_sh) std::fill_n(coefficient, 3, bad);
    std::fill_n(sample.sun.normal_irradiance, 3, bad);
    const WelkinLevelLight light = lightFrom(sample);
    if (welkin_level_set_light(opened.level, &light) != WELKIN_OK) continue;
    REQUIRE(welkin_level_relight(opened.level, UINT32_MAX, nullptr) == WELKIN_OK);
    const OwnedVolume v;
    WelkinVolumeUpdate update{};
    CHECK(welkin_volume_update(v.volume, opened.level, &sample, kOrigin, UINT32_MAX, &update) == WELKIN_OK);
  }
  opened.relight(12.0);
  float wanted[3], found[3];
  OpenedLevel fresh(baked);
  fresh.relight(12.0);
  REQUIRE(welkin_level_irradiance(fresh.level, 1, &kOrigin, &kUp, &wanted, nullptr) == WELKIN_OK);
  REQUIRE(welkin_level_irradiance(opened.level, 1, &kOrigin, &kUp, &found, nullptr) == WELKIN_OK);
  CHECK(std::memcmp(wanted, found, sizeof found) == 0);
}

TEST_CASE("LevelApi, RelightingKeepsItsOrder") {
  const RandomLevel baked = smallLevel();
  OpenedLevel opened(baked);
  WelkinLevel* level = opened.level;
  std::uint32_t count = 7;
  refusedFor(welkin_level_relight_begin(level, 5, &count), "welkin_level_relight_begin: no light is set");
  refusedFor(welkin_level_relight(level, 5, nullptr), "welkin_level_relight_begin: no light is set");
  const WelkinSkySample sample = opened.sampleAt(9.0);
  const WelkinLevelLight light = lightFrom(sample);
  REQUIRE(welkin_level_set_light(level, &light) == WELKIN_OK);
  CHECK(welkin_level_relight_range(level, 0, 0) == WELKIN_OK);
  refusedFor(welkin_level_relight_range(level, 0, 1),
             "welkin_level_relight_range: the range 0 + 1 passes the 0 probes of this relighting");
  REQUIRE(welkin_level_relight_begin(level, 5, &count) == WELKIN_OK);
  CHECK(count == 5);
  CHECK(welkin_level_relight_range(level, 0, 6) == WELKIN_ERROR_ARGUMENT);
  CHECK(welkin_level_relight_range(level, 5, UINT32_MAX) == WELKIN_ERROR_ARGUMENT);
  CHECK(welkin_level_relight_range(level, UINT32_MAX, 2) == WELKIN_ERROR_ARGUMENT);
  refusedFor(welkin_level_relight_begin(level, 5, &count),
             "welkin_level_relight_begin: a relighting has begun and must end first");
  CHECK(welkin_level_relight(level, 5, nullptr) == WELKIN_ERROR_ARGUMENT);
  WelkinSector* sector = nullptr;
  refusedFor(welkin_level_remove(level, 0, 0, &sector),
             "welkin_level_remove: a relighting has begun and must end first");
  CHECK(welkin_level_relight_range(level, 2, 3) == WELKIN_OK);
  CHECK(welkin_level_relight_range(level, 0, 2) == WELKIN_OK);
  WelkinRelight result{};
  CHECK(welkin_level_relight_end(level, &result) == WELKIN_OK);
  CHECK((result.relit == 5 && result.remaining == 2 * 12 - 5));
  CHECK(welkin_level_relight_end(level, &result) == WELKIN_OK);  // nothing has begun, so nothing ends
  CHECK((result.relit == 0 && result.remaining == 2 * 12 - 5));
}

TEST_CASE("LevelApi, SectorsBelongToOneLevel") {
  const RandomLevel baked = smallLevel();
  OpenedLevel a(baked), b(baked);
  WelkinSector* sector = nullptr;
  REQUIRE(welkin_level_remove(a.level, 0, 0, &sector) == WELKIN_OK);
  REQUIRE(sector != nullptr);
  WelkinSector* kept = nullptr;
  REQUIRE(welkin_level_remove(b.level, 0, 0, &kept) == WELKIN_OK);
  refusedFor(welkin_level_add(b.level, sector), "welkin_level_add: the sector was opened for another level");
  REQUIRE(welkin_level_add(a.level, sector) == WELKIN_OK);
  refusedFor(welkin_level_add(a.level, sector), "welkin_level_add: the sector (0, 0) is already resident");
  welkin_sector_close(sector);  // it is resident, so it stays open
  a.relight(9.0);
  float rgb[3];
  std::uint8_t served = 0;
  CHECK(welkin_level_irradiance(a.level, 1, &kOrigin, &kUp, &rgb, &served) == WELKIN_OK);
  CHECK(served == 1);
  // Two objects of one file: the second is refused and stays the caller's.
  WelkinSector* twin = nullptr;
  REQUIRE(welkin_sector_open(a.level, a.files[3].data(), a.files[3].size, &twin, nullptr) == WELKIN_OK);
  CHECK(welkin_level_add(a.level, twin) == WELKIN_ERROR_ARGUMENT);
  welkin_sector_close(twin);
  welkin_level_close(b.level);  // sectors that are not resident outlive the level
  b.level = nullptr;
  welkin_sector_close(kept);
}

TEST_CASE("LevelApi, TheCapacityIsKept") {
  const RandomLevel baked = smallLevel();
  OpenedLevel opened(baked);
  WelkinOpenInfo info{};
  info.data = opened.files[1].data();
  info.size = opened.files[1].size;
  WelkinLevelLimits limits{};
  limits.sector_capacity = 65536;
  WelkinLevel* level = nullptr;
  refusedFor(welkin_level_open(&info, opened.sky, &limits, &level, nullptr),
             "welkin_level_open: limits->sector_capacity is 65536, must be 0 to 65535");
  limits.sector_capacity = 2;
  limits.light_capacity = 65537;
  refusedFor(welkin_level_open(&info, opened.sky, &limits, &level, nullptr),
             "welkin_level_open: limits->light_capacity is 65537, must be 0 to 65536");
  limits.light_capacity = 0;
  limits.sector_capacity = 1;
  REQUIRE(welkin_level_open(&info, opened.sky, &limits, &level, nullptr) == WELKIN_OK);
  std::int32_t x = 0, z = 0;
  refusedFor(welkin_level_farthest(level, kOrigin, &x, &z), "welkin_level_farthest: no sector is resident");
  WelkinSector* sector[2] = {};
  for (int i = 0; i < 2; ++i) {
    const AlignedBytes& file = opened.files[static_cast<std::size_t>(2 + i)];
    REQUIRE(welkin_sector_open(level, file.data(), file.size, &sector[i], nullptr) == WELKIN_OK);
    CHECK(welkin_level_add(level, sector[i]) == (i == 0 ? WELKIN_OK : WELKIN_ERROR_MEMORY));
  }
  welkin_sector_close(sector[1]);
  welkin_level_close(level);
}

/// Opens sky, level, sectors and volume in a heap. Returns the first error; closes all that it opened.
WelkinResult openAll(const RandomLevel& baked, Heap& heap, WelkinVolumeFormat format) {
  const WelkinAllocator allocator = heap.allocator();
  const AlignedBytes sky_bytes(baked.sky), index(sectors::encodeLevel(baked.index));
  WelkinSky* sky = nullptr;
  REQUIRE(welkin_sky_open_memory(sky_bytes.data(), sky_bytes.size, &sky, nullptr) == WELKIN_OK);
  WelkinOpenInfo info{};
  info.data = index.data();
  info.size = index.size;
  info.flags = WELKIN_OPEN_COPY;
  info.allocator = &allocator;
  WelkinLevel* level = nullptr;
  WelkinVolume* volume = nullptr;
  WelkinMessage message{};
  WelkinResult result = welkin_level_open(&info, sky, nullptr, &level, &message);
  std::vector<AlignedBytes> files;
  for (std::size_t i = 0; i < baked.sector.size() && result == WELKIN_OK; ++i) {
    files.emplace_back(baked.sectorBytes(i));
    WelkinSector* sector = nullptr;
    result = welkin_sector_open(level, files.back().data(), files.back().size, &sector, &message);
    CHECK((result == WELKIN_OK) == (sector != nullptr));
    if (result == WELKIN_OK) CHECK(welkin_level_add(level, sector) == WELKIN_OK);
  }
  if (result == WELKIN_OK) {
    WelkinLevelInfo described{};
    REQUIRE(welkin_level_info(level, &described) == WELKIN_OK);
    CHECK(described.resident_bytes < heap.bytes());
    // The rest is the level's own tables, and its lights.
    CHECK(described.resident_bytes + index.size > heap.bytes() - 8192 - 320 * described.light_capacity);
    WelkinVolumeSettings settings{};
    settings.format = format;
    settings.allocator = &allocator;
    result = welkin_volume_create(&settings, &volume);
    CHECK((result == WELKIN_OK) == (volume != nullptr));
  } else {
    CHECK(std::string(message.text) == "out of memory");
  }
  welkin_volume_destroy(volume);
  welkin_level_close(level);
  welkin_sky_close(sky);
  return result;
}

TEST_CASE("LevelApi, TheGamesMemoryServesAll") {
  RandomLevel baked(2, 12, 4, SunTransfer::directional, true);
  baked.addLocal(9, 12);
  for (const WelkinVolumeFormat format : {WELKIN_VOLUME_RGBA16F, WELKIN_VOLUME_RGBA8})
    for (std::size_t most = 0;; ++most) {
      Heap heap;
      heap.most = most;
      const WelkinResult result = openAll(baked, heap, format);
      CAPTURE(most);
      CHECK(heap.held.empty());
      if (result == WELKIN_OK) {
        // The index's copy, six tables and the level; blocks, emission, four arrays of local transfer, light, texels
        // and the object of each of two sectors; slices, three channels, six arrays of bricks, the far map's two and
        // the object of the volume.
        CHECK(heap.allocations == 8 + 2 * 9 + 13);
        break;
      }
      CHECK(result == WELKIN_ERROR_MEMORY);
      REQUIRE(most < 100);
    }
}

}  // namespace
}  // namespace welkin::tests
