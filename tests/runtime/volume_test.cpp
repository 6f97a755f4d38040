// SPDX-License-Identifier: Apache-2.0
// The volume against look-ups of the level, and against itself filled at once.
#include <welkin/volume.h>
#include <welkin/volume_constants.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <random>

#include "tests/runtime/small_volume.h"

namespace welkin::tests {
namespace {

using transfer::SunTransfer;

struct Difference {
  double worst = 0.0, largest = 0.0;  ///< of irradiances
};

/// Differences between volume and look-up at middles of cells, pushed back by the push. There the volume's filter meets
/// one texel, and the look-up one cell.
Difference differenceAtMiddles(const OpenedLevel& opened, const Volume& volume) {
  std::mt19937 random(4);
  Difference d;
  int compared = 0;
  for (int i = 0; i < 4000; ++i) {
    const auto in = [&](int low, int high) { return std::uniform_int_distribution<int>(low, high)(random); };
    const float normal[3] = {0.0F, i % 2 == 0 ? 1.0F : -1.0F, 0.0F};
    const float place[3] = {4.0F * static_cast<float>(in(-16, 31)) + 2.0F, 4.0F * static_cast<float>(in(0, 6)) + 2.0F,
                            4.0F * static_cast<float>(in(8, 15)) + 2.0F};
    const float position[3] = {place[0], place[1] - normal[1], place[2]};
    float wanted[3], found[3], inside = 0.0F;
    std::uint8_t served = 0;
    REQUIRE(welkin_level_irradiance(opened.level, 1, &position, &normal, &wanted, &served) == WELKIN_OK);
    REQUIRE(welkin_volume_irradiance(volume.volume, position, normal, found, &inside) == WELKIN_OK);
    if (served == 0) continue;
    CHECK(inside == 1.0F);
    ++compared;
    for (int c = 0; c < 3; ++c) {
      d.largest = std::max(d.largest, double{wanted[c]});
      d.worst = std::max(d.worst, std::abs(double{wanted[c]} - double{found[c]}));
    }
  }
  CHECK(compared > 1000);
  return d;
}

/// Irradiance at a point as a game shows it: that of the volume, and the open sky beyond.
std::array<double, 3> shownAt(const Volume& volume, const WelkinSkySample& sample,
                              const std::array<float, 3>& position) {
  const float up[3] = {0, 1, 0};
  float within[3], beyond[3], inside = 0.0F;
  REQUIRE(welkin_volume_irradiance(volume.volume, position.data(), up, within, &inside) == WELKIN_OK);
  REQUIRE(welkin_sample_irradiance(&sample, up, beyond) == WELKIN_OK);
  std::array<double, 3> shown;
  for (std::size_t c = 0; c < 3; ++c)
    shown[c] = double{inside} * double{within[c]} + (1.0 - double{inside}) * double{beyond[c]};
  return shown;
}

}  // namespace

TEST_CASE("Volume, AFlightShowsNoStepsBetweenFrames") {
  const RandomLevel baked = wholeLevel();
  OpenedLevel opened(baked);
  const WelkinSkySample sample = opened.relight(10.0);
  Volume volume(WELKIN_VOLUME_RGBA16F, {20, 12, 20});
  // Across three sector borders, and more than twice around the torus of 80 m; the world's points stand still.
  constexpr int kFrames = 800;
  constexpr float kStep_m = 0.25F;
  std::vector<std::array<float, 3>> point;
  std::mt19937 random(12);
  const auto in = [&](float low, float high) { return std::uniform_real_distribution<float>(low, high)(random); };
  for (int i = 0; i < 400; ++i) point.push_back({in(-60, 60), in(0, 20), in(2, 62)});
  std::vector<std::array<double, 3>> before(point.size());
  std::vector<float> share_before(point.size());
  double largest = 0.0, most_within = 0.0, most_faded = 0.0;
  for (int i = 0; i < kFrames; ++i) {
    const std::array<float, 3> camera = {-100.0F + kStep_m * static_cast<float>(i), 10.0F, 30.0F};
    volume.update(opened, sample, camera);
    for (std::size_t p = 0; p < point.size(); ++p) {
      const float up[3] = {0, 1, 0};
      float rgb[3], inside = 0.0F;
      REQUIRE(welkin_volume_irradiance(volume.volume, point[p].data(), up, rgb, &inside) == WELKIN_OK);
      const auto shown = shownAt(volume, sample, point[p]);
      for (std::size_t c = 0; c < 3; ++c) {
        largest = std::max(largest, shown[c]);
        if (i == 0) continue;
        double& most = inside == 1.0F && share_before[p] == 1.0F ? most_within : most_faded;
        most = std::max(most, std::abs(shown[c] - before[p][c]));
      }
      before[p] = shown;
      share_before[p] = inside;
    }
  }
  INFO("steps " << most_within << " within, " << most_faded << " where it fades, of " << largest);
  // The share falls by the step over the border's width of 8 m.
  CHECK(most_faded <= 1.001 * largest * double{kStep_m} / 8.0);
  CHECK(most_faded > 0.0);
  CHECK(most_within == 0.0);  // a texel is that of its cell, wherever the camera is
}

TEST_CASE("Volume, AtTheMiddleOfACellItIsTheLookUp") {
  const RandomLevel baked = wholeLevel();
  OpenedLevel opened(baked);
  const WelkinSkySample sample = opened.relight(10.0);
  Volume half(WELKIN_VOLUME_RGBA16F);
  half.update(opened, sample, {10, 10, 50});
  // Half an ulp of 11 bits in each of four numbers, whose weights' sizes sum to at most 2.
  const Difference of_halfs = differenceAtMiddles(opened, half);
  CHECK(of_halfs.worst < 2.0 * 0x1p-11 * of_halfs.largest);
}

TEST_CASE("Volume, BytesAreOffByHalfAStepOfTheScale") {
  RandomLevel baked = wholeLevel(SunTransfer::none);  // without the sun, whose random bounce may be below 0
  for (std::size_t i = 0; i < baked.sector.size(); ++i) {
    std::fill(baked.sector[i].probes.sky_side.begin(), baked.sector[i].probes.sky_side.end(), std::int8_t{0});
    baked.seal(i);
  }
  OpenedLevel opened(baked);
  Volume volume(WELKIN_VOLUME_RGBA8);
  float before = 0.0F;
  for (const double time_h : {5.0, 6.0, 8.0, 12.0, 12.01}) {
    const WelkinSkySample sample = opened.relight(time_h);
    volume.update(opened, sample, {10, 10, 50});
    WelkinVolumeConstants k{};
    REQUIRE(welkin_volume_constants(volume.volume, &k, sizeof k) == WELKIN_OK);
    const Difference d = differenceAtMiddles(opened, volume);
    CHECK(d.worst < 2.0 * 0.5 / 255.0 * double{k.low.w} * (1.0 + 1e-5));
    double open = d.largest;  // or that of the open sky in a direction of the basis
    for (const auto& direction : f64::transferBasis().v) {
      const float normal[3] = {static_cast<float>(direction.x), static_cast<float>(direction.y),
                               static_cast<float>(direction.z)};
      float rgb[3];
      REQUIRE(welkin_sample_irradiance(&sample, normal, rgb) == WELKIN_OK);
      open = std::max(open, double{*std::max_element(rgb, rgb + 3)});
    }
    CHECK(double{k.low.w} < 1.25 * open);
    if (time_h == 12.01) CHECK(k.low.w == before);  // a minute's change of the light leaves the scale alone
    before = k.low.w;
  }
}

TEST_CASE("Volume, TheFirstUpdateHoldsAllWords") {
  const RandomLevel baked = wholeLevel();
  OpenedLevel opened(baked);
  const WelkinSkySample sample = opened.relight(10.0);
  for (const std::uint32_t bricks : {0U, 64U, WELKIN_VOLUME_NO_BRICKS}) {
    WelkinVolumeSettings settings{};
    settings.texels[0] = settings.texels[2] = 24;
    settings.texels[1] = 8;
    settings.bricks = bricks;
    WelkinVolume* volume = nullptr;
    REQUIRE(welkin_volume_create(&settings, &volume) == WELKIN_OK);
    const float camera[3] = {0, 10, 30};
    WelkinVolumeUpdate update{};
    REQUIRE(welkin_volume_update(volume, opened.level, &sample, camera, UINT32_MAX, &update) == WELKIN_OK);
    const void* words = nullptr;
    std::size_t bytes = 0;
    REQUIRE(welkin_volume_cuts(volume, &words, &bytes) == WELKIN_OK);
    CHECK(update.cut_first == 0);
    CHECK(update.cut_bytes == bytes);  // a buffer of the caller's may hold anything before
    CHECK(bytes % 16 == 0);
    REQUIRE(welkin_volume_update(volume, opened.level, &sample, camera, UINT32_MAX, &update) == WELKIN_OK);
    CHECK(update.cut_bytes == 0);
    welkin_volume_destroy(volume);
  }
}

TEST_CASE("Volume, ItMovesAsIfFilledAtOnce") {
  const RandomLevel baked = wholeLevel();
  OpenedLevel opened(baked);
  const WelkinSkySample sample = opened.relight(10.0);
  std::mt19937 random(7);
  Volume moved(WELKIN_VOLUME_RGBA16F, {24, 8, 20});
  std::array<float, 3> camera = {0, 10, 30};
  moved.update(opened, sample, camera);
  for (int i = 0; i < 60; ++i) {
    for (float& c : camera) c += std::uniform_real_distribution<float>(-9, 9)(random);
    if (i % 20 == 19) camera[0] += 300;
    if (i % 20 == 0) camera[0] = 0;
    const WelkinVolumeUpdate update = moved.update(opened, sample, camera);
    CHECK(update.box_count <= WELKIN_VOLUME_MAX_BOXES);
    CHECK(update.remaining == 0);
    Volume fresh(WELKIN_VOLUME_RGBA16F, {24, 8, 20});
    fresh.update(opened, sample, camera);
    CHECK(moved.bytes() == fresh.bytes());
  }
}

TEST_CASE("Volume, AStepOfACellFillsASlabAlone") {
  const RandomLevel baked = wholeLevel();
  OpenedLevel opened(baked);
  const WelkinSkySample sample = opened.relight(10.0);
  constexpr std::uint32_t kSize[3] = {24, 8, 20};
  Volume moved(WELKIN_VOLUME_RGBA16F, {24, 8, 20});
  std::array<float, 3> camera = {2, 10, 30};
  moved.update(opened, sample, camera);
  CHECK(moved.update(opened, sample, camera).filled == 0);
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (int step = 0; step < 2 * 24; ++step) {
      camera[axis] += step % 48 < 24 ? 4.0F : -4.0F;
      const WelkinVolumeUpdate update = moved.update(opened, sample, camera);
      INFO("axis " << axis << ", step " << step);
      CHECK(update.remaining == 0);
      // The slab, which along x and y goes on in the copy of the first slice; along z that slice may be in it.
      std::uint32_t slab = 1;
      for (std::size_t a = 0; a < 3; ++a) slab *= a == axis ? 1 : a == 2 ? kSize[2] + 1 : kSize[a];
      const bool has_copy = axis == 2 && update.box_count == 2;
      CHECK(update.filled == (has_copy ? 2 : 1) * slab);
      CHECK(update.box_count == (has_copy ? 2 : 1));
    }
}

TEST_CASE("Volume, TwoOfOneLevelKeepTheirOwnFormats") {
  const RandomLevel baked = wholeLevel();
  OpenedLevel opened(baked);
  const WelkinSkySample sample = opened.relight(10.0);
  for (const auto format : {WELKIN_VOLUME_RGBA16F, WELKIN_VOLUME_RGBA8}) {
    Volume moved(format, {24, 8, 20}), wanted(format, {24, 8, 20});
    Volume other(format == WELKIN_VOLUME_RGBA8 ? WELKIN_VOLUME_RGBA16F : WELKIN_VOLUME_RGBA8, {8, 8, 8});
    moved.update(opened, sample, {0, 10, 30});
    other.update(opened, sample, {0, 10, 30});
    moved.update(opened, sample, {12, 10, 30});  // fills a slab, after the other volume has packed the same light
    wanted.update(opened, sample, {12, 10, 30});
    CHECK(moved.bytes() == wanted.bytes());
  }
}

TEST_CASE("Volume, TheBoxesHoldEveryTexelThatChanged") {
  const RandomLevel baked = wholeLevel();
  OpenedLevel opened(baked);
  Volume volume(WELKIN_VOLUME_RGBA16F, {24, 8, 20});
  std::uint32_t extent[3];
  REQUIRE(welkin_volume_extent(volume.volume, extent) == WELKIN_OK);
  CHECK(extent[2] > 20 + 1);
  std::vector<std::byte> copy;
  std::mt19937 random(8);
  std::array<float, 3> camera = {0, 10, 30};
  WelkinSkySample sample = opened.relight(9.0);
  for (int i = 0; i < 40; ++i) {
    if (i % 4 == 3) sample = opened.relight(9.0 + 0.1 * i);
    for (float& c : camera) c += std::uniform_real_distribution<float>(-6, 6)(random);
    const WelkinVolumeUpdate update = volume.update(opened, sample, camera, 24 * 8 * 7);
    const std::vector<std::byte> now = volume.bytes();
    if (copy.empty()) copy.resize(now.size());
    std::uint32_t filled = 0;
    for (std::uint32_t b = 0; b < update.box_count; ++b) {
      const WelkinVolumeBox& box = update.box[b];
      filled += box.size[0] * box.size[1] * box.size[2];
      for (std::uint32_t c = 0; c < 3; ++c)
        for (std::uint32_t z = box.first[2]; z < box.first[2] + box.size[2]; ++z)
          for (std::uint32_t y = box.first[1]; y < box.first[1] + box.size[1]; ++y) {
            const std::size_t at = 8 * (box.first[0] + 24 * (y + 8 * (z + extent[2] * std::size_t{c})));
            std::memcpy(copy.data() + at, now.data() + at, 8 * box.size[0]);
          }
    }
    CHECK(filled == update.filled);
    CHECK(copy == now);
  }
  // Once the light stands still, a few updates end all that remains.
  WelkinVolumeUpdate update{};
  int updates = 0;
  do {
    update = volume.update(opened, sample, camera, 24 * 8 * 7);
    ++updates;
  } while (update.remaining > 0);
  CHECK(updates <= 3);
  CHECK(volume.update(opened, sample, camera).box_count == 0);
  Volume fresh(WELKIN_VOLUME_RGBA16F, {24, 8, 20});
  fresh.update(opened, sample, camera);
  CHECK(volume.bytes() == fresh.bytes());
}

TEST_CASE("Volume, BeyondTheSectorsItIsTheOpenSky") {
  const RandomLevel baked = wholeLevel();
  OpenedLevel opened(baked);
  const WelkinSkySample sample = opened.relight(13.0);
  Volume volume(WELKIN_VOLUME_RGBA16F);
  volume.update(opened, sample, {1e4F, 10, 30});
  for (const auto& normal : {std::array<float, 3>{0, 1, 0}, {0, -1, 0}, {0.6F, 0.8F, 0}}) {
    const float position[3] = {1e4F, 12, 30};
    float wanted[3], found[3];
    REQUIRE(welkin_sample_irradiance(&sample, normal.data(), wanted) == WELKIN_OK);
    REQUIRE(welkin_volume_irradiance(volume.volume, position, normal.data(), found, nullptr) == WELKIN_OK);
    // The volume is linear in the normal, the sky not quite.
    for (float& w : wanted) w *= static_cast<float>(baked.index.scale.sky);
    for (int c = 0; c < 3; ++c) CHECK(double{found[c]} == Approx(double{wanted[c]}).epsilon(0.25));
    if (normal[1] == -1.0F)
      for (int c = 0; c < 3; ++c) CHECK(double{found[c]} == Approx(double{wanted[c]}).epsilon(2e-3));
  }
}

TEST_CASE("Volume, ConstantsPlaceTheTexels") {
  const RandomLevel baked = wholeLevel();
  OpenedLevel opened(baked);
  const WelkinSkySample sample = opened.relight(13.0);
  Volume volume(WELKIN_VOLUME_RGBA8, {24, 8, 20});
  volume.update(opened, sample, {-1, 17, 3});
  WelkinVolumeConstants k{};
  REQUIRE(welkin_volume_constants(volume.volume, &k, sizeof k) == WELKIN_OK);
  CHECK((k.low.x == -52.0F && k.low.y == 0.0F && k.low.z == -40.0F));
  CHECK((k.camera.x == -1.0F && k.camera.y == 17.0F && k.camera.z == 3.0F && k.camera.w == 1.0F));
  CHECK((k.size.x == 96.0F && k.size.y == 32.0F && k.size.z == 80.0F));
  CHECK((k.texel.x == 4.0F && k.texel.y == 4.0F && k.texel.z == 4.0F));
  CHECK(k.low.w > 0.0F);
  CHECK(welkin_volume_constants(volume.volume, &k, 48) == WELKIN_ERROR_ARGUMENT);
}

}  // namespace welkin::tests
