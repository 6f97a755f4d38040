// SPDX-License-Identifier: Apache-2.0
// Doors of rooms: the query and the volume go over from one side's light to the other's by the closed form.
#include "format/doors.h"

#include <welkin/volume.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "tests/runtime/random_level.h"

namespace welkin::tests {
namespace {

using f64::Number3;

/// Where the tests' door lies, metres: across a face of the room within a cell, from 29 inside to 35.5 outside.
constexpr double kFace = double{30.7F}, kInner = 29.0, kOuter = 35.5;

/// RandomLevel with its room's face there.
RandomLevel levelWithDoor(std::size_t modes, transfer::SunTransfer sun) {
  RandomLevel level(2, 37, modes, sun, false);
  for (std::size_t i = 0; i < level.sector.size(); ++i) {
    level.sector[i].room[0].box.high.z = kFace;
    level.seal(i);
  }
  return level;
}

double smooth(double t) {
  const double x = std::clamp(t, 0.0, 1.0);
  return x * x * (3.0 - 2.0 * x);
}

/// The other side's share at a place of the door of RandomLevel: x from -4 to 7, fading over 2.75 m on either side.
double shareAt(const Number3& p) {
  if (p.x < -4.0 || p.x > 7.0 || p.y < 0.0 || p.y > 5.0 || p.z < kInner || p.z > kOuter) return 0.0;
  const double outside = smooth((p.z - kInner) / (kOuter - kInner));
  return (p.z > kFace ? 1.0 - outside : outside) * smooth(std::min(p.x + 4.0, 7.0 - p.x) / 2.75);
}

RandomLevel withoutDoors(RandomLevel level) {
  for (std::size_t i = 0; i < level.sector.size(); ++i) {
    level.sector[i].door.clear();
    level.seal(i);
  }
  return level;
}

struct Surface {
  Number3 position, normal;
};

/// Surfaces about the door. Their normals lie along the face, so that pushes do not cross it.
std::vector<Surface> surfacesAboutDoor() {
  std::mt19937 random(8);
  const auto in = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
  std::vector<Surface> surfaces;
  while (surfaces.size() < 20000) {
    const double turn = in(0.0, 6.28);
    surfaces.push_back({Number3(in(-6, 9), in(-2, 7), in(27, 38)), Number3(std::cos(turn), std::sin(turn), 0.0)});
  }
  return surfaces;
}

/// The light with the door less the mixture of that without it on the two sides of the face: the worst of all surfaces,
/// over the largest. `push_m`: how far off the surface the share is taken.
template <typename With, typename Without>
double worstMixture(const With& with, const Without& without, double push_m) {
  double worst = 0.0, largest = 0.0;
  std::size_t soft = 0, compared = 0;
  for (const Surface& s : surfacesAboutDoor()) {
    const double share = shareAt(s.position + push_m * s.normal);
    Number3 beyond = s.position;
    beyond.z = kFace + (s.position.z > kFace ? -1.0 : 1.0) / 256.0;
    const Number3 here = without(s.position, s.normal), there = without(beyond, s.normal);
    const Number3 found = with(s.position, s.normal);
    if (share > 0.05) ++soft;
    for (int c = 0; c < 3; ++c) {
      if (!(here[c] > 0.0) || !(there[c] > 0.0)) continue;  // random light may be below 0, and then is not told
      largest = std::max(largest, here[c]);
      ++compared;
      worst = std::max(worst, std::abs(found[c] - (1.0 - share) * here[c] - share * there[c]));
    }
  }
  CHECK(soft > 2000);
  CHECK(compared > 30000);
  CHECK(largest > 0.0);
  return worst / largest;
}

auto queryOf(const OpenedLevel& opened) {
  return [&opened](const Number3& p, const Number3& n) {
    const float at[1][3] = {{static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)}};
    const float normal[1][3] = {{static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z)}};
    float rgb[1][3];
    std::uint8_t served = 0;
    REQUIRE(welkin_level_irradiance(opened.level, 1, at, normal, rgb, &served) == WELKIN_OK);
    CHECK(served == 1);
    return Number3(double{rgb[0][0]}, double{rgb[0][1]}, double{rgb[0][2]});
  };
}

/// Names a probe of its side of the room in every cell, and puts the grid where the volume's texels are.
void nameSides(RandomLevel& level) {
  std::mt19937 random(9);
  const geometry::Box room{{-6.0, 0.0, 20.0}, {9.0, 6.0, kFace}};
  for (std::size_t i = 0; i < level.sector.size(); ++i) {
    sectors::SectorFile& s = level.sector[i];
    s.low_y = -4.0;
    s.cell_height_m = 4.0;
    for (std::size_t cell = 0; cell < s.grid.size(); ++cell) {
      const Number3 middle(4.0 * static_cast<double>(cell % 16) + 2.0, 4.0 * static_cast<double>(cell / 16 % 16) - 2.0,
                           4.0 * static_cast<double>(cell / 256) + 2.0);
      const bool inside = geometry::contains(room, middle + geometry::cornerOf(s.id));
      do s.grid[cell] = static_cast<std::uint8_t>(random() % s.in_room.size());
      while ((s.in_room[s.grid[cell]] != 0) != inside);
    }
    level.seal(i);
  }
}

struct OpenedVolume {
  OpenedVolume(OpenedLevel& opened) {
    const WelkinSkySample sample = opened.relight(10.0);
    WelkinVolumeSettings settings{};
    REQUIRE(welkin_volume_create(&settings, &volume) == WELKIN_OK);
    const float camera[3] = {0, 4, 30};
    WelkinVolumeUpdate update{};
    REQUIRE(welkin_volume_update(volume, opened.level, &sample, camera, UINT32_MAX, &update) == WELKIN_OK);
    CHECK(update.cuts_left == 0);
  }
  OpenedVolume(const OpenedVolume&) = delete;
  OpenedVolume& operator=(const OpenedVolume&) = delete;
  ~OpenedVolume() { welkin_volume_destroy(volume); }

  auto light() const {
    return [this](const Number3& p, const Number3& n) {
      const float at[3] = {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
      const float normal[3] = {static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z)};
      float rgb[3];
      REQUIRE(welkin_volume_irradiance(volume, at, normal, rgb, nullptr) == WELKIN_OK);
      return Number3(double{rgb[0]}, double{rgb[1]}, double{rgb[2]});
    };
  }

  WelkinVolume* volume = nullptr;
};

}  // namespace

TEST_CASE("Doors, TheWayIsTheFaceThatTheBoxCrosses") {
  const format::InWorld low{0, 0, 0}, high{10, 3, 8};
  const auto way = [&](const format::InWorld& door_low, const format::InWorld& door_high) {
    return format::doorWayOf({door_low, door_high, low, high});
  };
  const format::DoorWay out = way({4, 0, 6}, {6, 2, 11});
  REQUIRE(out.is_door);
  CHECK((out.axis == 2 && out.rises && out.face == 8.0));
  const format::DoorWay in = way({-1, 0.5, 6}, {1, 2, 7});
  REQUIRE(in.is_door);
  CHECK((in.axis == 0 && !in.rises && in.face == 0.0));
  const format::DoorWay hatch = way({4, 2, 2}, {6, 4, 4});
  REQUIRE(hatch.is_door);
  CHECK((hatch.axis == 1 && hatch.rises && hatch.face == 3.0));
  const format::DoorWay below = way({4, -1, 6}, {6, 2, 9});  // through the floor as well: the upright face counts
  REQUIRE(below.is_door);
  CHECK((below.axis == 2 && below.low[1] == 0.0));
  CHECK_FALSE(way({4, 0, 5}, {6, 2, 7}).is_door);       // inside
  CHECK_FALSE(way({4, 0, 6}, {6, 2, 8}).is_door);       // ends at the face
  CHECK_FALSE(way({4, 0, 9}, {6, 2, 11}).is_door);      // outside
  CHECK_FALSE(way({4, 0, -1}, {6, 2, 9}).is_door);      // through two faces
  CHECK_FALSE(way({9, 0, 7}, {11, 2, 9}).is_door);      // over an edge
  CHECK_FALSE(way({10, 0, 7}, {11, 2, 9}).is_door);     // beside the room
  CHECK_FALSE(way({4, 0, 6}, {4.0005, 2, 9}).is_door);  // too thin
  CHECK_FALSE(way({4, 0, 6}, {6, std::nan(""), 9}).is_door);
}

TEST_CASE("Doors, TheLightGoesOverByTheClosedForm") {
  const format::DoorWay way = format::doorWayOf({{4, 0, 6}, {6, 2, 11}, {0, 0, 0}, {10, 3, 8}});
  const auto share = [&](double x, double z) { return format::beyondDoor(way, {x, 1.0, z}).share; };
  CHECK(share(5, 5.99) == 0.0);
  CHECK(share(5, 11.01) == 0.0);
  CHECK(share(3.99, 8) == 0.0);
  CHECK(share(5, 6) == 0.0);
  CHECK(share(5, 11) == 0.0);
  // The door is 5 m deep, and its face at 2 m of them: 0.4^2 (3 - 0.8) = 0.352.
  CHECK(share(5, 8) == Approx(0.352).margin(1e-15));
  CHECK(share(5, 8 + 1e-12) == Approx(0.648).margin(1e-9));
  CHECK(share(5, 7) == Approx(0.04 * 2.6));           // of the light outside
  CHECK(share(5, 10) == Approx(0.04 * 2.6));          // of the light inside
  CHECK(share(4.125, 8) == Approx(0.352 * 0.15625));  // a quarter of the way into the half metre that fades
  CHECK(share(5.875, 8) == Approx(0.352 * 0.15625));
  CHECK(format::beyondDoor(way, {5, 1, 8}).place[2] == 8.0 + 0x1p-8);
  CHECK(format::beyondDoor(way, {5, 1, 9}).place[2] == 8.0 - 0x1p-8);
  // As wide as its room: no side of it has air beyond.
  const format::DoorWay whole = format::doorWayOf({{0, 0, 6}, {10, 2, 11}, {0, 0, 0}, {10, 3, 8}});
  CHECK(format::beyondDoor(whole, {0.01, 1, 8}).share == Approx(0.352));
  CHECK(format::beyondDoor(whole, {10, 1, 8}).share == Approx(0.352));
}

TEST_CASE("Doors, TheQueryMixesBothSides") {
  const RandomLevel baked = levelWithDoor(10, transfer::SunTransfer::directional);
  OpenedLevel with(baked), without(withoutDoors(baked));
  with.relight(10.0);
  without.relight(10.0);
  // Floats of 24 bits, of places and of light.
  CHECK(worstMixture(queryOf(with), queryOf(without), 1.0) < 1e-5);
}

TEST_CASE("Doors, TheVolumeMixesBothSides") {
  RandomLevel baked = levelWithDoor(0, transfer::SunTransfer::none);
  nameSides(baked);
  OpenedLevel with(baked), without(withoutDoors(baked));
  const OpenedVolume soft(with), hard(without);
  // Floats of places: a place that is 1e-6 m on the other side of a face of a cell or room.
  CHECK(worstMixture(soft.light(), hard.light(), 0.25) < 1e-4);
}

TEST_CASE("Doors, TheVolumeHasNoSeamAtTheFace") {
  RandomLevel baked = levelWithDoor(0, transfer::SunTransfer::none);
  nameSides(baked);
  OpenedLevel opened(baked);
  const OpenedVolume volume(opened);
  const auto light = volume.light();
  const Number3 up(0.0, 1.0, 0.0);
  double worst = 0.0, largest = 0.0;
  for (const double x : {0.0, 1.0, 2.5, 3.9})
    for (const double y : {0.0, 0.5, 1.0, 2.5, 3.5}) {
      const Number3 wanted = light({x, y, kFace - 1e-3}, up);
      for (int step = -40; step <= 40; ++step) {  // floats of 2e-6 m, and steps of 3e-5 m of the planes' words
        const Number3 found = light({x, y, kFace + 2e-6 * step}, up);
        for (int c = 0; c < 3; ++c) {
          largest = std::max(largest, wanted[c]);
          worst = std::max(worst, std::abs(found[c] - wanted[c]));
        }
      }
    }
  CHECK(largest > 0.0);
  // A millimetre of a door that is 6.5 m deep: 1.5 / 6.5 of a thousandth; and of the filter: three axes' 4 m.
  CHECK(worst < 2e-3 * largest);
}

}  // namespace welkin::tests
