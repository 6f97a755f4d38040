// SPDX-License-Identifier: Apache-2.0
// The far map against the sectors' own tiles, closed forms, and itself filled at once.
#include <welkin/volume.h>
#include <welkin/volume_constants.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <numeric>
#include <random>

#include "probes/sectors/occlusion_tile.h"
#include "tests/runtime/random_level.h"

namespace welkin::tests {
namespace {

using transfer::SunTransfer;

/// Largest error of a half of at most 1: half a step of 2^-11 below 1, the largest step in [0, 1).
constexpr double kHalf = 1.0 / 4096.0;

struct FarVolume {
  WelkinVolume* volume = nullptr;
  explicit FarVolume(std::uint32_t far_texels = 0, float fade_m = 0.0F) {
    WelkinVolumeSettings settings{};
    settings.texels[0] = settings.texels[1] = settings.texels[2] = 4;
    settings.bricks = WELKIN_VOLUME_NO_BRICKS;
    settings.far_texels = far_texels;
    settings.far_fade_m = fade_m;
    REQUIRE(welkin_volume_create(&settings, &volume) == WELKIN_OK);
  }
  FarVolume(const FarVolume&) = delete;
  FarVolume& operator=(const FarVolume&) = delete;
  ~FarVolume() { welkin_volume_destroy(volume); }

  WelkinVolumeUpdate update(OpenedLevel& level, const WelkinSkySample& sample, float x, float z) {
    WelkinVolumeUpdate result{};
    const float camera[3] = {x, 10.0F, z};
    REQUIRE(welkin_volume_update(volume, level.level, &sample, camera, UINT32_MAX, &result) == WELKIN_OK);
    return result;
  }
  std::vector<std::uint32_t> texels() const {
    const void* first = nullptr;
    std::uint32_t edge = 0;
    REQUIRE(welkin_volume_far_map(volume, &first, &edge) == WELKIN_OK);
    const auto* words = static_cast<const std::uint32_t*>(first);
    return {words, words + std::size_t{edge} * edge};
  }
  double visibility(double x, double y, double z, const float* normal = nullptr) const {
    const float position[3] = {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)};
    float found = -1.0F;
    REQUIRE(welkin_volume_far_visibility(volume, position, normal, &found) == WELKIN_OK);
    return double{found};
  }
};

/// A level of one probe a sector, which serves everywhere: the sky's visibility in all three directions and its height.
RandomLevel evenLevel(int sectors, double visibility, double height) {
  RandomLevel level(sectors, 1, 0, SunTransfer::none, false);
  for (auto& s : level.sector) {
    s.room.clear();
    s.door.clear();
    s.in_room.clear();
    s.top.fill(0);
    s.probes.low_y = s.probes.high_y = static_cast<float>(height);
    s.probes.sky.assign(24, 0);
    s.probes.sky_side.assign(24, 0);
    s.probes.visibility.assign(3, static_cast<std::uint16_t>(std::lround(65535.0 * visibility)));
  }
  level.reindex();
  return level;
}

sectors::OcclusionTile tileOf(const sectors::SectorFile& sector) {
  return sectors::occlusionTileOf(sector.top, transfer::decodedProbes(sector.probes, sector.id)).value();
}

double fadeOf(double away, double fade_m) {
  return std::clamp(2.0 - 2.0 * std::abs(away) / fade_m, 0.0, 1.0);
}

}  // namespace

TEST_CASE("FarMap, OpenGroundIsExactlyOne") {
  const RandomLevel baked = evenLevel(4, 1.0, 1.7);
  OpenedLevel opened(baked);
  FarVolume v;
  v.update(opened, opened.relight(12.0), 40.0F, 30.0F);
  for (const double x : {-63.9, -1.0, 20.0, 63.9, 64.1, 190.0}) CHECK(v.visibility(x, 1.7, 31.0) == 1.0);
  CHECK(v.texels() == std::vector<std::uint32_t>(256 * 256, 0));
}

TEST_CASE("FarMap, ASquareCourtyardHasItsClosedForm") {
  // The ground in the middle of a square courtyard as high as wide sees 0.23946 of the sky.
  const RandomLevel baked = evenLevel(4, 0.23946, 0.0);
  OpenedLevel opened(baked);
  FarVolume v;
  v.update(opened, opened.relight(12.0), 40.0F, 30.0F);
  for (const double x : {-50.0, -1.0, 30.0, 100.0}) CHECK(v.visibility(x, 0.0, 31.0) == Approx(0.23946).margin(kHalf));
}

TEST_CASE("FarMap, TexelsAreTheTilesOfTheSectors") {
  const RandomLevel baked(4, 40, 0, SunTransfer::none, false);
  OpenedLevel opened(baked);
  FarVolume v;
  v.update(opened, opened.relight(12.0), 40.0F, 30.0F);
  double lowest = 1.0, highest = 0.0;
  for (const auto& sector : baked.sector) {
    const sectors::OcclusionTile tile = tileOf(sector);
    for (std::size_t i = 0; i < tile.sky_visibility.size(); ++i) {
      const double x = 64.0 * sector.id.x + 4.0 * static_cast<double>(i % 16) + 2.0;
      const double z = 64.0 * sector.id.z + 4.0 * static_cast<double>(i / 16) + 2.0;
      CHECK(v.visibility(x, tile.probe_y[i], z) == Approx(tile.sky_visibility[i]).margin(kHalf));
      lowest = std::min(lowest, tile.sky_visibility[i]);
      highest = std::max(highest, tile.sky_visibility[i]);
    }
  }
  CHECK(highest - lowest > 0.5);
}

TEST_CASE("FarMap, BetweenTexelsItIsBilinear") {
  RandomLevel baked(3, 40, 0, SunTransfer::none, false);
  for (auto& s : baked.sector) s.probes.low_y = s.probes.high_y = 5.0F;
  baked.reindex();
  OpenedLevel opened(baked);
  FarVolume v;
  v.update(opened, opened.relight(12.0), 40.0F, 30.0F);
  const sectors::OcclusionTile tile = tileOf(baked.sector[1]), beside = tileOf(baked.sector[2]);
  const auto& at = tile.sky_visibility;
  // Texel (5, 9) and its neighbours; 1 m is a quarter of a texel.
  CHECK(v.visibility(23.0, 5.0, 38.0) == Approx(0.75 * at[5 + 16 * 9] + 0.25 * at[6 + 16 * 9]).margin(kHalf));
  CHECK(v.visibility(22.0, 5.0, 37.0) == Approx(0.75 * at[5 + 16 * 9] + 0.25 * at[5 + 16 * 8]).margin(kHalf));
  const float east[3] = {1, 0, 0};  // a surface looks up its light 1 m off
  CHECK(v.visibility(22.0, 5.0, 38.0, east) == v.visibility(23.0, 5.0, 38.0));
  // Across the border of two sectors, at x = 64 m.
  CHECK(v.visibility(63.0, 5.0, 38.0) ==
        Approx(0.75 * at[15 + 16 * 9] + 0.25 * beside.sky_visibility[16 * 9]).margin(kHalf));
}

TEST_CASE("FarMap, TheEffectFadesAboveAndBelow") {
  const double height = 7.0, visibility = 0.4;
  const RandomLevel baked = evenLevel(4, visibility, height);
  OpenedLevel opened(baked);
  for (const float fade : {0.0F, 10.0F}) {
    FarVolume v(0, fade);
    v.update(opened, opened.relight(12.0), 40.0F, 30.0F);
    const double fade_m = fade == 0.0F ? 16.0 : double{fade};
    for (double away = -20.0; away <= 20.0; away += 0.5) {
      const double wanted = 1.0 - (1.0 - visibility) * fadeOf(away, fade_m);
      // The height is two halfs' quotient: within 2^-10 of itself, over half of the fade.
      CHECK(v.visibility(20.0, height + away, 31.0) == Approx(wanted).margin(kHalf + height / 1024.0 / (0.5 * fade_m)));
    }
    CHECK(v.visibility(20.0, height + fade_m + 0.1, 31.0) == 1.0);
    CHECK(v.visibility(20.0, height - fade_m - 0.1, 31.0) == 1.0);
  }
}

TEST_CASE("FarMap, OpenTexelsHaveNoHeight") {
  // Two sectors beside each other, one of them open and far below: halfway between them half of the other's occlusion.
  RandomLevel baked = evenLevel(3, 0.5, 200.0);
  baked.sector[2].probes.low_y = baked.sector[2].probes.high_y = 0.0F;
  baked.sector[2].probes.visibility.assign(3, 65535);
  baked.reindex();
  OpenedLevel opened(baked);
  FarVolume v;
  v.update(opened, opened.relight(12.0), 40.0F, 30.0F);
  CHECK(v.visibility(64.0, 200.0, 31.0) == Approx(0.75).margin(kHalf));
  CHECK(v.visibility(130.0, 200.0, 31.0) == 1.0);
}

TEST_CASE("FarMap, TheBorderFadesToOneWithoutSteps") {
  const double visibility = 0.2;
  const RandomLevel baked = evenLevel(12, visibility, 0.0);  // x from -64 to 704 m, z from 0 to 64 m
  OpenedLevel opened(baked);
  const WelkinSkySample sample = opened.relight(12.0);
  FarVolume v(128);  // 8 sectors; the share is 1 up to 157 m, and 0 from 221 m on
  double last[2] = {-1.0, -1.0};
  for (float camera = 300.0F; camera < 372.0F; camera += 0.5F) {
    v.update(opened, sample, camera, 32.0F);
    for (int side = 0; side < 2; ++side) {
      const double direction = side == 0 ? 1.0 : -1.0;
      double before = v.visibility(double{camera}, 0.0, 32.0);
      CHECK(before == Approx(visibility).margin(kHalf));
      for (double away = 0.5; away < 240.0; away += 0.5) {
        const double now = v.visibility(double{camera} + direction * away, 0.0, 32.0);
        CHECK(std::abs(now - before) <= (1.0 - visibility) * 0.5 / 64.0 + 1e-6);
        before = now;
      }
      CHECK(before == 1.0);
    }
    // A place that stands still sees no step while the camera moves.
    for (int i = 0; i < 2; ++i) {
      const double now = v.visibility(i == 0 ? 140.0 : 530.0, 0.0, 32.0);
      if (last[i] >= 0.0) CHECK(std::abs(now - last[i]) <= (1.0 - visibility) * 0.5 / 64.0 + 1e-6);
      last[i] = now;
    }
  }
}

TEST_CASE("FarMap, ItMovesAsIfFilledAtOnce") {
  const RandomLevel baked(9, 40, 0, SunTransfer::none, false);
  OpenedLevel opened(baked);
  const WelkinSkySample sample = opened.relight(12.0);
  std::mt19937 random(7);
  FarVolume moved(64);
  std::vector<std::uint32_t> copy(64 * 64, 0xffffffffU);
  float x = 0.0F, z = 30.0F;
  std::size_t most = 0;
  for (int i = 0; i < 80; ++i) {
    x += std::uniform_real_distribution<float>(-90, 110)(random);
    z += std::uniform_real_distribution<float>(-70, 70)(random);
    if (i % 20 == 19) x = z = -100.0F;
    if (i % 5 == 4) {  // one sector leaves, comes back, or both
      const std::int32_t at = i % 10 == 4 ? 2 : 3;
      WelkinSector* sector = nullptr;
      REQUIRE(welkin_level_remove(opened.level, at, 0, &sector) == WELKIN_OK);
      if (sector != nullptr && i % 3 != 0) {
        welkin_sector_close(sector);
      } else {
        const AlignedBytes& file = opened.files[static_cast<std::size_t>(2 + at + 1)];
        if (sector == nullptr)
          REQUIRE(welkin_sector_open(opened.level, file.data(), file.size, &sector, nullptr) == WELKIN_OK);
        REQUIRE(welkin_level_add(opened.level, sector) == WELKIN_OK);
      }
    }
    const WelkinVolumeUpdate update = moved.update(opened, sample, x, z);
    FarVolume fresh(64);
    fresh.update(opened, sample, x, z);
    const auto now = moved.texels();
    CHECK(now == fresh.texels());
    // The rectangles hold every texel that changed, once.
    CHECK(update.far_box_count <= WELKIN_VOLUME_MAX_FAR_BOXES);
    std::size_t texels = 0;
    for (std::uint32_t b = 0; b < update.far_box_count; ++b) {
      const WelkinFarBox& box = update.far_box[b];
      texels += std::size_t{box.size[0]} * box.size[1];
      for (std::uint32_t row = box.first[1]; row < box.first[1] + box.size[1]; ++row)
        std::copy_n(&now.at(box.first[0] + 64 * row), box.size[0], &copy.at(box.first[0] + 64 * row));
    }
    if (i > 0) most = std::max(most, texels);
    CHECK(texels <= std::size_t{64} * 64);
    CHECK(copy == now);
    CHECK(moved.update(opened, sample, x, z).far_box_count == 0);
    for (int p = 0; p < 20; ++p) {
      const double px = double{x} + std::uniform_real_distribution<double>(-140, 140)(random);
      const double pz = double{z} + std::uniform_real_distribution<double>(-140, 140)(random);
      CHECK(moved.visibility(px, 5.0, pz) == fresh.visibility(px, 5.0, pz));
    }
  }
  CHECK(most > 0);
}

TEST_CASE("FarMap, AnyOrderOfSectorsGivesTheSameBits") {
  const RandomLevel baked(9, 40, 0, SunTransfer::none, false);
  std::vector<std::uint32_t> wanted;
  std::vector<std::int32_t> order(9);
  std::iota(order.begin(), order.end(), -1);
  std::mt19937 random(3);
  for (int turn = 0; turn < 6; ++turn) {
    OpenedLevel opened(baked);
    const WelkinSkySample sample = opened.relight(12.0);
    FarVolume v;
    std::shuffle(order.begin(), order.end(), random);
    std::vector<WelkinSector*> out;
    for (const std::int32_t x : order) {
      REQUIRE(welkin_level_remove(opened.level, x, 0, &out.emplace_back()) == WELKIN_OK);
      if (turn % 2 == 1) v.update(opened, sample, static_cast<float>(64 * x), 30.0F);
    }
    std::shuffle(out.begin(), out.end(), random);
    for (WelkinSector* sector : out) {
      REQUIRE(welkin_level_add(opened.level, sector) == WELKIN_OK);
      if (turn % 2 == 1) v.update(opened, sample, 200.0F, 30.0F);
    }
    v.update(opened, sample, 250.0F, 30.0F);
    if (wanted.empty()) wanted = v.texels();
    CHECK(v.texels() == wanted);
  }
  // All nine have their tiles; a few of their texels are open.
  CHECK(std::count(wanted.begin(), wanted.end(), 0U) < 256 * 256 - 8 * 256);
}

TEST_CASE("FarMap, MoreRectanglesThanThereIsRoomForAreOne") {
  const RandomLevel baked(18, 8, 0, SunTransfer::none, false);
  for (const std::int32_t leaving : {8, 9}) {  // none beside another
    OpenedLevel opened(baked);
    const WelkinSkySample sample = opened.relight(12.0);
    FarVolume v(512), fresh(512);
    CHECK(v.update(opened, sample, 300.0F, 30.0F).far_box_count == 1);
    for (std::int32_t i = 0; i < leaving; ++i) {
      WelkinSector* sector = nullptr;
      REQUIRE(welkin_level_remove(opened.level, 2 * i, 0, &sector) == WELKIN_OK);
      welkin_sector_close(sector);
    }
    const WelkinVolumeUpdate update = v.update(opened, sample, 300.0F, 30.0F);
    CHECK(update.far_box_count == (leaving == 8 ? 8U : 1U));
    CHECK(update.far_box[0].size[0] == (leaving == 8 ? 16U : 17U * 16U));
    CHECK(update.far_box[0].size[1] == 16U);
    fresh.update(opened, sample, 300.0F, 30.0F);
    CHECK(v.texels() == fresh.texels());
  }
}

TEST_CASE("FarMap, RefusesWhatItCannotServe") {
  WelkinVolume* volume = nullptr;
  for (const std::uint32_t texels : {1U, 16U, 40U, 1040U, UINT32_MAX}) {
    WelkinVolumeSettings settings{};
    settings.far_texels = texels;
    CHECK(welkin_volume_create(&settings, &volume) == WELKIN_ERROR_ARGUMENT);
    CHECK_THAT(welkin_argument_error(), Catch::Contains("far_texels is " + std::to_string(texels)));
  }
  for (const float fade : {-1.0F, 0.5F, 2e4F, NAN}) {
    WelkinVolumeSettings settings{};
    settings.far_fade_m = fade;
    CHECK(welkin_volume_create(&settings, &volume) == WELKIN_ERROR_ARGUMENT);
    CHECK_THAT(welkin_argument_error(), Catch::Contains("far_fade_m is "));
  }
  FarVolume v;
  const float far_away[3] = {2e7F, 0, 0}, here[3] = {0, 0, 0}, long_normal[3] = {0, 2, 0};
  float visibility = 0.0F;
  CHECK(welkin_volume_far_visibility(v.volume, far_away, nullptr, &visibility) == WELKIN_ERROR_ARGUMENT);
  CHECK(welkin_volume_far_visibility(v.volume, here, long_normal, &visibility) == WELKIN_ERROR_ARGUMENT);
  CHECK(welkin_volume_far_visibility(v.volume, here, nullptr, nullptr) == WELKIN_ERROR_ARGUMENT);
  REQUIRE(welkin_volume_far_visibility(v.volume, here, nullptr, &visibility) == WELKIN_OK);
  CHECK(visibility == 1.0F);
}

TEST_CASE("FarMap, AGameOfTheFirstReleaseGetsItsConstants") {
  const RandomLevel baked(2, 8, 0, SunTransfer::none, false);
  OpenedLevel opened(baked);
  FarVolume v;
  v.update(opened, opened.relight(12.0), 100.0F, 30.0F);
  WelkinVolumeConstants all{}, first{};
  first.far_map.x = first.far_share.x = 7.0F;
  REQUIRE(welkin_volume_constants(v.volume, &all, sizeof all) == WELKIN_OK);
  REQUIRE(welkin_volume_constants(v.volume, &first, 80) == WELKIN_OK);
  CHECK(std::memcmp(&all, &first, 80) == 0);
  CHECK((first.far_map.x == 7.0F && first.far_share.x == 7.0F));
  CHECK((all.far_map.x == -384.0F && all.far_map.y == -512.0F && all.far_map.z == 1024.0F && all.far_map.w == 16.0F));
  CHECK((all.far_share.x == 477.0F && all.far_share.y == 1.0F / 64.0F));
}

}  // namespace welkin::tests
