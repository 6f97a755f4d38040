// SPDX-License-Identifier: Apache-2.0
#include "generate/harbour.h"

namespace welkin::island {
namespace {

constexpr uint32_t kHarbourSeed = 307;
const Colour kDriedWood(0.34, 0.25, 0.16);

/// A point of the hull: `s` from stern to bow, `v` from keel to rim, both in [0, 1]; `side` is -1 or 1.
Vec3 hull(double s, double v, double side, double thickness) {
  const double plan = s < 0.45 ? mix(0.62, 0.8, s / 0.45) : 0.8 * (1.0 - ((s - 0.45) / 0.55) * ((s - 0.45) / 0.55));
  const double sheer = 0.52 + 0.5 * s * s * s + 0.1 * (1.0 - s) * (1.0 - s);
  const double keel = -0.3 + 0.35 * smoothStep(0.75, 1.0, s);
  const double flare = det::sqrt(v) * (0.8 + 0.2 * v);
  return {side * max(plan * flare - thickness, 0.012), mix(keel + thickness, sheer, v),
          2.8 - 5.6 * s + (s > 0.5 ? thickness * s : -thickness)};
}

}  // namespace

Mesh jetty() {
  Mesh mesh;
  constexpr double kDeck = 1.05;
  constexpr double kLength = 30.0;
  constexpr int kPlanks = 66;
  for (int i = 0; i < kPlanks; ++i) {
    const auto id = static_cast<uint32_t>(i);
    if (random(kHarbourSeed, id) < 0.04) continue;  // a plank is missing
    const double z = 1.5 - (kLength + 1.5) * i / kPlanks;
    const double left = random(kHarbourSeed + 1, id, -1.06, -0.92);
    const double right = random(kHarbourSeed + 2, id, 0.92, 1.06);
    const Colour colour = kDriedWood * random(kHarbourSeed + 3, id, 0.7, 1.2);
    mesh.add("wood", box({}, {left, kDeck - 0.06, z - 0.42}, {right, kDeck, z}, colour), Shading::flat);
  }
  for (const double x : {-0.75, 0.75})
    mesh.add("wood", box({}, {x - 0.07, kDeck - 0.22, -kLength}, {x + 0.07, kDeck - 0.06, 1.5}, kDriedWood * 0.7),
             Shading::flat);
  for (int i = 0; i <= 8; ++i) {
    const auto id = static_cast<uint32_t>(i);
    for (const double x : {-0.98, 0.98}) {
      const double top = kDeck + (i % 2 == 0 ? random(kHarbourSeed + 4, id, 0.45, 0.8) : -0.1);
      const double z = -kLength * i / 8.0 + 0.1;
      mesh.add("wood", post({x * 1.03, -5.5, z}, {x, top, z}, 0.11, 7, kDriedWood * 0.75), Shading::smooth);
    }
  }
  // a head across the end
  for (int i = 0; i < 12; ++i) {
    const Colour colour = kDriedWood * random(kHarbourSeed + 5, static_cast<uint32_t>(i), 0.7, 1.2);
    const double x = -3.0 + 0.5 * i;
    mesh.add("wood", box({}, {x, kDeck + 0.005, -kLength - 1.6}, {x + 0.46, kDeck + 0.06, -kLength + 0.3}, colour),
             Shading::flat);
  }
  for (const double x : {-2.9, 2.9})
    for (const double z : {-kLength - 1.5, -kLength + 0.2})
      mesh.add("wood", post({x, -6.0, z}, {x, kDeck + 0.6, z}, 0.12, 7, kDriedWood * 0.75), Shading::smooth);
  return mesh;
}

Mesh driftwood() {
  Mesh mesh;
  const Colour bleached(0.40, 0.35, 0.29);
  mesh.add("wood",
           tube({{-2.0, 0.02, 0.1},
                 {-1.2, 0.1, -0.1},
                 {-0.3, 0.12, 0.05},
                 {0.7, 0.16, 0.0},
                 {1.5, 0.26, -0.2},
                 {2.1, 0.5, -0.3}},
                {0.06, 0.13, 0.17, 0.2, 0.17, 0.1}, 8, bleached),
           Shading::smooth);
  mesh.add("wood", tube({{0.6, 0.2, 0.0}, {0.8, 0.5, 0.3}, {0.75, 0.75, 0.65}}, {0.1, 0.07, 0.02}, 6, bleached * 0.9),
           Shading::smooth);
  mesh.add("wood",
           tube({{-0.6, 0.12, 0.0}, {-0.9, 0.3, -0.35}, {-1.3, 0.36, -0.6}}, {0.08, 0.05, 0.02}, 6, bleached * 0.9),
           Shading::smooth);
  return mesh;
}

Mesh boat() {
  Mesh mesh;
  constexpr int kStations = 13;
  const std::array<double, 5> strakes = {0.0, 0.12, 0.38, 0.72, 1.0};
  const auto skin = [&](std::size_t first, std::size_t last, double side, double thickness, const char* material,
                        const Colour& colour) {
    Shape shape = grid(
        static_cast<int>(last - first) + 1, kStations, false,
        [&](int row, int column) {
          return hull(column / (kStations - 1.0), strakes[first + static_cast<std::size_t>(row)], side, thickness);
        },
        [&](int, int) { return colour; });
    if ((side < 0.0) != (thickness > 0.0)) shape.flip();
    mesh.add(material, shape, Shading::smooth);
  };
  for (const double side : {-1.0, 1.0}) {
    skin(0, 3, side, 0.0, "boat_white", Colour(0.95));
    skin(3, 4, side, 0.0, "boat_red", Colour(1.0));
    skin(0, 4, side, 0.05, "wood", kDriedWood * 1.3);
    // the rim
    Shape rim = grid(
        2, kStations, false,
        [&](int row, int column) {
          return hull(column / (kStations - 1.0), 1.0, side, row == 0 ? -0.04 : 0.06) + Vec3(0, 0.02, 0);
        },
        [&](int, int) { return kDriedWood; });
    if (side < 0.0) rim.flip();
    mesh.add("wood", rim, Shading::flat);
  }
  Shape transom;
  for (const double v : strakes) {
    transom.point(hull(0.0, v, -1.0, 0.0), Colour(1.0));
    transom.point(hull(0.0, v, 1.0, 0.0), Colour(1.0));
  }
  for (int i = 0; i + 1 < static_cast<int>(strakes.size()); ++i) transom.quad(2 * i, 2 * i + 1, 2 * i + 3, 2 * i + 2);
  mesh.add("boat_red", transom, Shading::flat);
  for (const double s : {0.2, 0.48, 0.74}) {
    const double half = hull(s, 0.75, 1.0, 0.05).x;
    mesh.add("wood", box({{0, 0.3, 2.8 - 5.6 * s}}, {-half, 0.0, -0.14}, {half, 0.05, 0.14}, kDriedWood * 1.1),
             Shading::flat);
  }
  mesh.add("wood", post({-0.3, 0.5, 1.9}, {-0.1, 0.55, -1.6}, 0.03, 5, kDriedWood * 1.4), Shading::smooth);  // an oar
  return mesh;
}

}  // namespace welkin::island
