// SPDX-License-Identifier: Apache-2.0
// Rooms in the volume's bricks against the look-ups of the level.
#include <welkin/volume.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "tests/runtime/random_level.h"

namespace welkin::tests {
namespace {

using f64::Number3;

const geometry::Box kRoom{{-6.5, 1.0, 20.0}, {9.0, 6.0, 31.0}};  ///< across the border of two sectors at x = 0

/// Two sectors of random probes, where each cell names a probe of the room that its middle is in.
RandomLevel levelWithRoom() {
  RandomLevel baked(2, 60, 0, transfer::SunTransfer::none, false);
  std::mt19937 random(9);
  for (std::size_t i = 0; i < baked.sector.size(); ++i) {
    sectors::SectorFile& s = baked.sector[i];
    const Number3 corner = geometry::cornerOf(s.id);
    s.low_y = -4.0;
    s.cell_height_m = 4.0;
    s.door.clear();
    s.room = {{{kRoom.low - corner, kRoom.high - corner}, 3}};
    for (std::size_t cell = 0; cell < s.grid.size(); ++cell) {
      const Number3 middle =
          corner + Number3(4.0 * static_cast<double>(cell % 16) + 2.0, 4.0 * static_cast<double>(cell / 16 % 16) - 2.0,
                           4.0 * static_cast<double>(cell / 256) + 2.0);
      const bool inside = geometry::contains(kRoom, middle);
      do s.grid[cell] = static_cast<std::uint8_t>(random() % 60);
      while ((s.in_room[s.grid[cell]] != 0) != inside);
    }
    baked.seal(i);
  }
  return baked;
}

}  // namespace

TEST_CASE("VolumeRooms, EachSideHasTheLightOfItsOwnProbes") {
  const RandomLevel baked = levelWithRoom();
  OpenedLevel opened(baked);
  const WelkinSkySample sample = opened.relight(10.0);
  WelkinVolumeSettings settings{};
  WelkinVolume* volume = nullptr;
  REQUIRE(welkin_volume_create(&settings, &volume) == WELKIN_OK);
  const float camera[3] = {0, 4, 26};
  WelkinVolumeUpdate update{};
  REQUIRE(welkin_volume_update(volume, opened.level, &sample, camera, UINT32_MAX, &update) == WELKIN_OK);
  CHECK(update.bricks > 0);
  CHECK(update.cuts_left == 0);
  std::mt19937 random(4);
  const auto in = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
  double worst[2] = {}, largest = 0.0;
  int compared[2] = {};
  for (int i = 0; i < 40000; ++i) {
    // Inside anywhere. Outside at middles of cells, where one cell has all of the query's weight.
    const bool anywhere = i % 2 == 0;
    const auto middle = [&](double low, double high) { return 4.0 * std::floor(in(low, high) / 4.0) + 2.0; };
    const Number3 place = anywhere ? Number3(in(-6.5, 9.0), in(1.0, 6.0), in(20.0, 31.0))
                                   : Number3(middle(-16, 20), middle(-4, 16), middle(8, 44));
    Number3 n(in(-1, 1), in(-1, 1), in(-1, 1));
    if (!anywhere) n = Number3(0.0, i % 4 == 1 ? 1.0 : -1.0, 0.0);
    const double length = std::sqrt(dot(n, n));
    if (length < 0.1) continue;
    n = n / length;
    const Number3 at = place - n;  // pushed by 1 m
    const bool inside = geometry::contains(kRoom, place);
    // The volume has the room of a place 0.25 m off the surface.
    if (inside != geometry::contains(kRoom, at) || inside != geometry::contains(kRoom, at + 0.25 * n)) continue;
    if (anywhere && !inside) continue;
    const float position[1][3] = {{static_cast<float>(at.x), static_cast<float>(at.y), static_cast<float>(at.z)}};
    const float normal[1][3] = {{static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z)}};
    float wanted[1][3], found[3];
    std::uint8_t served = 0;
    REQUIRE(welkin_level_irradiance(opened.level, 1, position, normal, wanted, &served) == WELKIN_OK);
    REQUIRE(welkin_volume_irradiance(volume, position[0], normal[0], found, nullptr) == WELKIN_OK);
    CHECK(served == 1);
    ++compared[inside];
    for (int c = 0; c < 3; ++c) {
      largest = std::max(largest, double{wanted[0][c]});
      worst[inside] = std::max(worst[inside], std::abs(double{wanted[0][c]} - double{found[c]}));
    }
  }
  welkin_volume_destroy(volume);
  CHECK(compared[0] > 1000);
  CHECK(compared[1] > 1000);
  CHECK(largest > 0.0);
  // Half an ulp of 11 bits in each of four numbers, whose weights' sizes sum to at most 2.
  CHECK(worst[0] < 2.0 * 0x1p-11 * largest);
  CHECK(worst[1] < 2.0 * 0x1p-11 * largest);
}

}  // namespace welkin::tests
