// SPDX-License-Identifier: Apache-2.0
// The volume while sectors come and go, and over a whole day.
#include <welkin/volume.h>
#include <welkin/volume_constants.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "tests/runtime/small_volume.h"

namespace welkin::tests {
namespace {

using transfer::SunTransfer;

/// A game with room for a few sectors of a level: it opens those about the camera, and the farthest leave for them.
class Game {
 public:
  Game(const RandomLevel& baked, std::uint32_t capacity) : baked_(baked), opened_(baked) {
    for (std::size_t i = 0; i < baked.sector.size(); ++i) leave(baked.sector[i].id.x);
    welkin_level_close(opened_.level);
    WelkinOpenInfo info{};
    info.data = opened_.files[1].data();
    info.size = opened_.files[1].size;
    WelkinLevelLimits limits{};
    limits.sector_capacity = capacity;
    REQUIRE(welkin_level_open(&info, opened_.sky, &limits, &opened_.level, nullptr) == WELKIN_OK);
  }

  void moveTo(const std::array<float, 3>& camera, double radius_m) {
    for (std::size_t i = 0; i < baked_.sector.size(); ++i) {
      const geometry::SectorId id = baked_.sector[i].id;
      if (std::hypot(64.0 * id.x + 32.0 - double{camera[0]}, 64.0 * id.z + 32.0 - double{camera[2]}) > radius_m)
        continue;
      WelkinSector* sector = nullptr;
      const AlignedBytes& file = opened_.files[2 + i];
      REQUIRE(welkin_sector_open(opened_.level, file.data(), file.size, &sector, nullptr) == WELKIN_OK);
      WelkinResult result = welkin_level_add(opened_.level, sector);
      if (result == WELKIN_ERROR_MEMORY) {
        std::int32_t x = 0, z = 0;
        REQUIRE(welkin_level_farthest(opened_.level, camera.data(), &x, &z) == WELKIN_OK);
        leave(x);
        ++left;
        result = welkin_level_add(opened_.level, sector);
      }
      if (result == WELKIN_ERROR_ARGUMENT) welkin_sector_close(sector);  // it is resident
    }
  }

  OpenedLevel& level() { return opened_; }
  int left = 0;  ///< sectors that left for others

 private:
  void leave(std::int32_t x) {
    WelkinSector* sector = nullptr;
    REQUIRE(welkin_level_remove(opened_.level, x, 0, &sector) == WELKIN_OK);
    REQUIRE(sector != nullptr);
    welkin_sector_close(sector);
  }

  const RandomLevel& baked_;
  OpenedLevel opened_;
};

}  // namespace

TEST_CASE("VolumeStream, AFlightWithRoomForThreeSectorsShowsTheLightOfAll") {
  const RandomLevel baked = wholeLevel(SunTransfer::directional, 8);
  OpenedLevel all(baked);
  const WelkinSkySample sample = all.relight(10.0);
  Game game(baked, 3);
  WelkinLevelLight light{};
  light.sample = &sample;
  light.sky = light.sun_bounce = light.local = 1.0F;
  REQUIRE(welkin_level_set_light(game.level().level, &light) == WELKIN_OK);
  // The volume reaches 32 m to each side, so that the three sectors nearest to the camera hold all of it.
  Volume streamed(WELKIN_VOLUME_RGBA16F, {16, 8, 16}), wanted(WELKIN_VOLUME_RGBA16F, {16, 8, 16});
  std::mt19937 random(3);
  float x = -30.0F;
  for (int i = 0; i < 300; ++i) {
    x += i == 200 ? -300.0F : std::uniform_real_distribution<float>(-2, 5)(random);  // it also turns, and jumps back
    const std::array<float, 3> camera = {x, 10.0F, 30.0F};
    game.moveTo(camera, 80.0);
    // Of one sector's probes, or of three where it jumps: those that came are lit before they are seen.
    REQUIRE(welkin_level_relight(game.level().level, i == 0 || i == 200 ? 180 : 60, nullptr) == WELKIN_OK);
    streamed.update(game.level(), sample, camera);
    wanted.update(all, sample, camera);
    INFO("frame " << i << ", x " << x);
    const bool is_same = streamed.bytes() == wanted.bytes();  // a bool: a list of megabytes prints for minutes
    REQUIRE(is_same);
  }
  CHECK(game.left > 6);
}

TEST_CASE("VolumeStream, SectorsInAnyOrderEndInTheSameBytes") {
  const RandomLevel baked = wholeLevel(SunTransfer::directional, 5);
  OpenedLevel inOrder(baked), shuffled(baked);
  Volume volume(WELKIN_VOLUME_RGBA16F, {24, 8, 20}), wanted(WELKIN_VOLUME_RGBA16F, {24, 8, 20});
  std::mt19937 random(9);
  std::vector<WelkinSector*> away;
  for (int i = 0; i < 120; ++i) {
    WelkinSector* sector = nullptr;
    REQUIRE(welkin_level_remove(shuffled.level, static_cast<std::int32_t>(random() % 5) - 1, 0, &sector) == WELKIN_OK);
    if (sector != nullptr) away.push_back(sector);
    while (!away.empty() && (i == 119 || random() % 2 == 0)) {
      std::swap(away.back(), away[random() % away.size()]);
      REQUIRE(welkin_level_add(shuffled.level, away.back()) == WELKIN_OK);
      away.pop_back();
    }
    const WelkinSkySample sample = shuffled.sampleAt(0.2 * i);
    WelkinLevelLight light{};
    light.sample = &sample;
    light.sky = light.sun_bounce = light.local = 1.0F;
    REQUIRE(welkin_level_set_light(shuffled.level, &light) == WELKIN_OK);
    REQUIRE(welkin_level_relight(shuffled.level, 50, nullptr) == WELKIN_OK);
    volume.update(shuffled, sample, {std::uniform_real_distribution<float>(-60, 250)(random), 9.0F, 30.0F}, 500);
  }
  const WelkinSkySample sample = inOrder.relight(15.0);
  shuffled.relight(15.0);
  for (const float x : {0.0F, 64.0F, 130.0F}) {
    volume.update(shuffled, sample, {x, 9.0F, 30.0F});
    wanted.update(inOrder, sample, {x, 9.0F, 30.0F});
    const bool is_same = volume.bytes() == wanted.bytes();
    CHECK(is_same);
  }
}

TEST_CASE("VolumeStream, TheScaleOfBytesFollowsADayWithoutPumping") {
  // 20,000 frames: at 60 a second a day of 5.6 minutes.
  constexpr int kFrames = 20000;
  RandomLevel baked = wholeLevel(SunTransfer::none);  // without the sun, whose random bounce may be below 0
  for (std::size_t i = 0; i < baked.sector.size(); ++i) {
    std::fill(baked.sector[i].probes.sky_side.begin(), baked.sector[i].probes.sky_side.end(), std::int8_t{0});
    baked.seal(i);
  }
  OpenedLevel opened(baked);
  Volume bytes(WELKIN_VOLUME_RGBA8, {4, 4, 4}), halfs(WELKIN_VOLUME_RGBA16F, {4, 4, 4});
  const std::array<float, 3> camera = {10, 8, 30};
  const float normal[3] = {0, 1, 0};
  float before_bytes[3] = {}, before_halfs[3] = {}, scale = 0.0F, least = 1e9F, most = 0.0F;
  int changes = 0, turns = 0, last_frame = -kFrames, last_way = 0, soonest = kFrames;
  double worst = 0.0;  // of what a frame adds to the light's own change, in steps of the scale
  for (int i = 0; i < kFrames; ++i) {
    const WelkinSkySample sample = opened.relight(24.0 * i / kFrames);
    bytes.update(opened, sample, camera);
    halfs.update(opened, sample, camera);
    WelkinVolumeConstants k{};
    REQUIRE(welkin_volume_constants(bytes.volume, &k, sizeof k) == WELKIN_OK);
    float of_bytes[3], of_halfs[3];
    REQUIRE(welkin_volume_irradiance(bytes.volume, camera.data(), normal, of_bytes, nullptr) == WELKIN_OK);
    REQUIRE(welkin_volume_irradiance(halfs.volume, camera.data(), normal, of_halfs, nullptr) == WELKIN_OK);
    const double step = double{std::max(k.low.w, scale)} / 255.0;
    for (int c = 0; c < 3 && i > 0; ++c) {
      const double own = std::abs(double{of_halfs[c]} - double{before_halfs[c]});
      worst = std::max(worst, (std::abs(double{of_bytes[c]} - double{before_bytes[c]}) - own) / step);
    }
    std::copy_n(of_bytes, 3, before_bytes);
    std::copy_n(of_halfs, 3, before_halfs);
    if (i > 0 && k.low.w != scale) {
      const int way = k.low.w > scale ? 1 : -1;
      ++changes;
      if (way == -last_way) {
        ++turns;
        soonest = std::min(soonest, i - last_frame);
      }
      last_way = way;
      last_frame = i;
    }
    scale = k.low.w;
    least = std::min(least, scale);
    most = std::max(most, scale);
  }
  INFO(changes << " changes, " << turns << " turns, the soonest after " << soonest << " frames, worst " << worst
               << " steps, scale " << least << " to " << most);
  CHECK(most > 1.5F * least);  // the day moves it
  // Two texels' roundings, before and after, whose weights' sizes sum to 2 at most.
  CHECK(worst < 2.0);
  // Up and down again at eighths of an octave, and no turn but for the day's own.
  CHECK(changes <= 2.0 * 8.0 * std::log2(double{most / least}) + 4.0);
  CHECK(turns <= 4);
  CHECK(soonest > kFrames / 100);
}

}  // namespace welkin::tests
