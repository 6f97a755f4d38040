// SPDX-License-Identifier: Apache-2.0
#include "generate/island.h"

#include <fmt/format.h>

#include <cmath>

#include "generate/harbour.h"
#include "generate/hut.h"
#include "generate/layout.h"
#include "generate/noise.h"
#include "generate/plants.h"
#include "generate/rocks.h"
#include "generate/terrain.h"
#include "generate/wreck.h"

namespace welkin::island {
namespace {

constexpr uint32_t kIslandSeed = 503;
constexpr int kPalms = 72;
constexpr int kBushes = 110;
constexpr int kTufts = 240;
constexpr int kTuft = 3;  // the variant of a bush
constexpr int kPebbles = 70;
constexpr int kRocks = 34;

void addMaterials(Scene& scene) {
  const Colour white(1.0);  // the vertices' colours are the albedo
  scene.addMaterial({"ground", white, 0.95});
  scene.addMaterial({"sea", {0.02, 0.10, 0.12}, 0.05});
  scene.addMaterial({"rock", white, 0.9});
  scene.addMaterial({"cave_rock", white, 0.9, true});
  scene.addMaterial({"stone", white, 0.9});
  scene.addMaterial({"wood", white, 0.85});
  scene.addMaterial({"thatch", white, 1.0, true});
  scene.addMaterial({"trim", {0.72, 0.68, 0.58}, 0.7});
  scene.addMaterial({"bark", white, 0.95});
  scene.addMaterial({"leaf", white, 0.6, true});
  scene.addMaterial({"flower", {0.85, 0.05, 0.22}, 0.6, true});
  scene.addMaterial({"hull", white, 0.7, true});
  scene.addMaterial({"boat_white", {0.75, 0.73, 0.68}, 0.5, true});
  scene.addMaterial({"boat_red", {0.62, 0.05, 0.03}, 0.5, true});
  scene.addMaterial({"boat_blue", {0.03, 0.18, 0.52}, 0.5, true});
  scene.addMaterial({"wall_red", {0.70, 0.045, 0.03}, 0.8});
  scene.addMaterial({"wall_yellow", {0.85, 0.56, 0.05}, 0.8});
  scene.addMaterial({"wall_turquoise", {0.03, 0.52, 0.50}, 0.8});
  scene.addMaterial({"wall_white", {0.82, 0.80, 0.75}, 0.8});
  scene.addMaterial({"wall_orange", {0.82, 0.22, 0.03}, 0.8});
  scene.addMaterial({"wall_blue", {0.04, 0.13, 0.55}, 0.8});
  scene.addMaterial({"wall_pink", {0.80, 0.16, 0.30}, 0.8});
  scene.addMaterial({"wall_green", {0.18, 0.50, 0.10}, 0.8});
}

void addGroundAndSea(Scene& scene) {
  Mesh ground;
  ground.add("ground", terrain(), Shading::smooth);
  scene.addMesh("terrain", ground);
  scene.addNode({.name = "terrain", .mesh = "terrain", .translation = {}, .role = "static"});
  Mesh sea;
  Shape plane;
  for (const auto& [x, z] : {std::pair{-1.0, 1.0}, {1.0, 1.0}, {1.0, -1.0}, {-1.0, -1.0}})
    plane.point({x * kHalfExtent_m, 0.0, z * kHalfExtent_m}, Colour(1.0));
  plane.quad(0, 1, 2, 3);
  sea.add("sea", plane, Shading::flat);
  scene.addMesh("sea", sea);
  scene.addNode({.name = "sea", .mesh = "sea", .translation = {}, .role = "water"});
}

void addVillage(Scene& scene) {
  for (const bool onStilts : {true, false}) scene.addMesh(onStilts ? "hut_stilts" : "hut_stone", hut(onStilts));
  int number = 0;
  for (const HutPlace& h : kHuts) {
    const std::string name = fmt::format("hut_{}", ++number);
    scene.addRepaintedMesh(name, h.onStilts ? "hut_stilts" : "hut_stone", "wall_red", h.wall);
    scene.addNode({.name = name,
                   .mesh = name,
                   .translation = onGround(h.place.x, h.place.z),
                   .azimuth_rad = radians(h.place.azimuth_deg),
                   .role = "static"});
  }
  scene.addMesh("jetty", jetty());
  scene.addNode({.name = "jetty",
                 .mesh = "jetty",
                 .translation = {kJetty.x, 0.0, kJetty.z},
                 .azimuth_rad = radians(kJetty.azimuth_deg),
                 .role = "static"});
  scene.addMesh("driftwood", driftwood());
  number = 0;
  for (const Place& p : kDriftwood)
    scene.addNode({.name = fmt::format("driftwood_{}", ++number),
                   .mesh = "driftwood",
                   .translation = onGround(p.x, p.z),
                   .azimuth_rad = radians(p.azimuth_deg),
                   .role = "static"});
  scene.addMesh("boat", boat());
  scene.addRepaintedMesh("boat_blue", "boat", "boat_red", "boat_blue");
  scene.addNode({.name = "boat",
                 .mesh = "boat",
                 .translation = {kBoat.x, 0.0, kBoat.z},
                 .azimuth_rad = radians(kBoat.azimuth_deg),
                 .role = "static"});
  scene.addNode({.name = "boat_2",
                 .mesh = "boat_blue",
                 .translation = onGround(kBeachedBoat.x, kBeachedBoat.z) + Vec3(0, 0.24, 0),
                 .azimuth_rad = radians(kBeachedBoat.azimuth_deg),
                 .pitch_rad = radians(-4.0),
                 .roll_rad = radians(14.0),
                 .role = "static"});
}

void addLandmarks(Scene& scene) {
  scene.addMesh("wreck", wreck());
  scene.addNode({.name = "wreck",
                 .mesh = "wreck",
                 .translation = onGround(kWreck.x, kWreck.z) - Vec3(0, 0.9, 0),
                 .azimuth_rad = radians(kWreck.azimuth_deg),
                 .pitch_rad = radians(5.0),
                 .roll_rad = radians(17.0),
                 .role = "static"});
  const CaveSite site = caveSite();
  scene.addMesh("cave", cave());
  scene.addNode(
      {.name = "cave", .mesh = "cave", .translation = site.mouth, .azimuth_rad = site.azimuth_rad, .role = "static"});
}

/// Draws places on the island until `count` of them satisfy `accept` and lie `apart_m` from one another.
template <typename Accept, typename Use>
void scatter(int count, double apart_m, uint32_t seed, Accept accept, Use use) {
  std::vector<Vec3> taken;
  for (uint32_t draw = 0; draw < 40000 && static_cast<int>(taken.size()) < count; ++draw) {
    const double x = random(seed, draw, -75.0, 95.0);
    const double z = random(seed + 1, draw, -105.0, 110.0);
    bool isFree = true;
    for (const Vec3& t : taken) isFree = isFree && length(t - Vec3(x, 0, z)) > apart_m;
    if (!isFree || !accept(x, z, random(seed + 2, draw))) continue;
    taken.push_back({x, 0, z});
    use(x, z, static_cast<int>(taken.size()));
  }
}

/// Azimuth of the nearest sea, radians.
double seaward(double x, double z) {
  const double east = inland_m(x - 3.0, z) - inland_m(x + 3.0, z);
  const double south = inland_m(x, z - 3.0) - inland_m(x, z + 3.0);
  return det::atan(east, -south);
}

void addPalms(Scene& scene) {
  for (int v = 0; v < kPalmVariants; ++v) scene.addMesh(fmt::format("palm_{}", static_cast<char>('a' + v)), palm(v));
  const auto plant = [&](double x, double z, int number, double azimuth_rad) {
    const auto id = static_cast<uint32_t>(number);
    scene.addNode({.name = fmt::format("palm_{:02}", number),
                   .mesh = fmt::format(
                       "palm_{}", static_cast<char>('a' + static_cast<int>(hash(kIslandSeed + id) % kPalmVariants))),
                   .translation = onGround(x, z),
                   .azimuth_rad = azimuth_rad,
                   .scale = random(kIslandSeed + 1, id, 0.85, 1.25),
                   .role = "vegetation"});
  };
  int number = 0;
  for (const Place& p : kFramingPalms) plant(p.x, p.z, ++number, radians(p.azimuth_deg));
  const int byHand = number;
  scatter(
      kPalms - byHand, 4.2, kIslandSeed + 2,
      [](double x, double z, double chance) {
        const double d = inland_m(x, z);
        const double likely = max(smoothStep(8.0, 13.0, d) * smoothStep(26.0, 18.0, d),
                                  0.25 * smoothStep(10.0, 30.0, d) + 0.5 * smoothStep(6.0, 9.0, height_m(x, z)));
        return chance < likely && clearance_m(x, z) > 0.6 && distanceToPath_m(x, z) > 1.6 && height_m(x, z) > 0.9 &&
               groundNormal(x, z).y > 0.82 && !isInView(x, z);
      },
      [&](double x, double z, int i) {
        const auto id = static_cast<uint32_t>(i);
        plant(x, z, byHand + i, seaward(x, z) + random(kIslandSeed + 3, id, -0.8, 0.8));
      });
}

void addBushesAndRocks(Scene& scene) {
  for (int v = 0; v < kBushVariants; ++v) scene.addMesh(fmt::format("bush_{}", static_cast<char>('a' + v)), bush(v));
  scatter(
      kBushes, 1.5, kIslandSeed + 10,
      [](double x, double z, double chance) {
        const double d = inland_m(x, z);
        return chance < 0.8 && d > 11.0 && clearance_m(x, z) > -0.4 && distanceToPath_m(x, z) > 1.4 &&
               height_m(x, z) > 1.3 && groundNormal(x, z).y > 0.8 && !(z > 60.0 && isInView(x, z)) &&
               (height_m(x, z) > 7.0 || noise({x * 0.09, 0, z * 0.09}, kIslandSeed + 11) > 0.5);
      },
      [&](double x, double z, int i) {
        const auto id = static_cast<uint32_t>(i);
        scene.addNode({.name = fmt::format("bush_{:03}", i),
                       .mesh = fmt::format(
                           "bush_{}", static_cast<char>('a' + static_cast<int>(hash(kIslandSeed + 12 + id) % kTuft))),
                       .translation = onGround(x, z) - Vec3(0, 0.08, 0),
                       .azimuth_rad = kTau * random(kIslandSeed + 13, id),
                       .scale = random(kIslandSeed + 14, id, 0.8, 1.7),
                       .role = "vegetation"});
      });
  scatter(
      kTufts, 0.7, kIslandSeed + 30,
      [](double x, double z, double chance) {
        const double d = inland_m(x, z);
        return chance < (x < 20.0 && z > 0.0 && z < 80.0 ? 1.0 : 0.15) && d > 11.0 && d < 40.0 &&
               clearance_m(x, z) > -1.5 && distanceToPath_m(x, z) > 1.0 && height_m(x, z) > 1.1 &&
               groundNormal(x, z).y > 0.8 && noise({x * 0.2, 0, z * 0.2}, kIslandSeed + 31) > 0.42;
      },
      [&](double x, double z, int i) {
        const auto id = static_cast<uint32_t>(kBushes + i);
        scene.addNode({.name = fmt::format("bush_{:03}", id),
                       .mesh = fmt::format("bush_{}", static_cast<char>('a' + kTuft)),
                       .translation = onGround(x, z) - Vec3(0, 0.04, 0),
                       .azimuth_rad = kTau * random(kIslandSeed + 32, id),
                       .scale = random(kIslandSeed + 33, id, 0.7, 1.6),
                       .role = "vegetation"});
      });
  for (int v = 0; v < kRockVariants; ++v) scene.addMesh(fmt::format("rock_{}", static_cast<char>('a' + v)), rock(v));
  scatter(
      kRocks, 3.0, kIslandSeed + 20,
      [](double x, double z, double chance) {
        const double d = inland_m(x, z);
        const bool byTheHeadland = x < -25.0 && z < -36.0 && d > -9.0 && d < 9.0;
        const bool onTheHill = height_m(x, z) > 8.0 && groundNormal(x, z).y < 0.85;
        const bool anywhere = d > -5.0 && d < 30.0 && chance < 0.06;
        return (byTheHeadland || onTheHill || anywhere) && clearance_m(x, z) > 1.0 && distanceToPath_m(x, z) > 2.5 &&
               !isInView(x, z);
      },
      [&](double x, double z, int i) {
        const auto id = static_cast<uint32_t>(i);
        scene.addNode(
            {.name = fmt::format("rock_{:02}", i),
             .mesh = fmt::format(
                 "rock_{}", static_cast<char>('a' + static_cast<int>(hash(kIslandSeed + 22 + id) % kRockVariants))),
             .translation = onGround(x, z),
             .azimuth_rad = kTau * random(kIslandSeed + 23, id),
             .scale = random(kIslandSeed + 24, id, 0.6, 2.4),
             .role = "static"});
      });
  scatter(
      kPebbles, 0.5, kIslandSeed + 40,
      [](double x, double z, double chance) {
        const double d = inland_m(x, z);
        return chance < (z > 10.0 && x < 10.0 ? 1.0 : 0.2) && d > -1.0 && d < 14.0 && distanceToPath_m(x, z) > 1.0 &&
               clearance_m(x, z) > 0.0;
      },
      [&](double x, double z, int i) {
        const auto id = static_cast<uint32_t>(kRocks + i);
        scene.addNode(
            {.name = fmt::format("rock_{:02}", id),
             .mesh = fmt::format(
                 "rock_{}", static_cast<char>('a' + static_cast<int>(hash(kIslandSeed + 22 + id) % kRockVariants))),
             .translation = onGround(x, z),
             .azimuth_rad = kTau * random(kIslandSeed + 43, id),
             .scale = random(kIslandSeed + 44, id, 0.05, 0.1) +
                      0.3 * random(kIslandSeed + 45, id) * random(kIslandSeed + 46, id) * random(kIslandSeed + 47, id),
             .role = "static"});
      });
}

}  // namespace

GltfFiles islandFiles() {
  Scene scene;
  addMaterials(scene);
  addGroundAndSea(scene);
  addVillage(scene);
  addLandmarks(scene);
  addPalms(scene);
  addBushesAndRocks(scene);
  return scene.encode("island.bin");
}

}  // namespace welkin::island
