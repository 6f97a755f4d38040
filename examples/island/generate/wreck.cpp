// SPDX-License-Identifier: Apache-2.0
#include "generate/wreck.h"

#include <cmath>

#include "generate/noise.h"

namespace welkin::island {
namespace {

constexpr uint32_t kWreckSeed = 401;
constexpr double kLength = 28.0;
constexpr double kHalfBeam = 3.6;
constexpr double kDepth = 4.6;
constexpr int kStations = 45;
constexpr int kStrakes = 13;
constexpr double kDeckShare = 0.8;  // share of the depth below the deck; the rest is bulwark

double sheer(double s) {
  return kDepth + 2.2 * s * s * s + 0.6 * (1.0 - s) * (1.0 - s) * (1.0 - s);
}

/// A point of the hull: `s` from stern to bow, `v` from keel to rail.
Vec3 hull(double s, double v, double side) {
  const double tail = clamp(s / 0.22, 0.0, 1.0);
  const double nose = clamp((s - 0.62) / 0.38, 0.0, 1.0);
  const double plan = (0.72 + 0.28 * tail * (2.0 - tail)) * (1.0 - nose * nose * (0.75 + 0.25 * nose));
  const double round = det::sqrt(1.0 - (1.0 - v) * (1.0 - v));  // amidships: a full bilge
  const double full = det::sqrt(round);
  const double sharp = mix(full, v * (0.6 + 0.4 * v), nose);  // the bow flares
  const double rake = 1.6 * v * nose * nose - 0.7 * v * (1.0 - tail);
  const double lift = 1.3 * (1.0 - tail) * (1.0 - tail) * (1.0 - v);  // the counter
  return {side * kHalfBeam * max(plan * sharp, 0.012), v * sheer(s) + lift, kLength * (0.5 - s) - rake};
}

/// Colour: paint above the old water line, red lead below, rust through both.
Colour plating(const Vec3& p) {
  const double worn = fractalNoise(p * Vec3(0.5, 0.35, 0.5), 4, kWreckSeed);
  const double streak = noise(p * Vec3(2.2, 0.15, 2.2), kWreckSeed + 5);
  const Colour rust =
      welkin::mix(Colour(0.17, 0.065, 0.028), Colour(0.40, 0.17, 0.06), fractalNoise(p * 1.3, 3, kWreckSeed + 9));
  const Colour paint = p.y > 1.9 ? Colour(0.10, 0.22, 0.27) : Colour(0.28, 0.07, 0.045);
  const double bare = smoothStep(0.44, 0.56, worn + 0.28 * (streak - 0.5) + 0.05);
  return welkin::mix(paint, rust, bare);
}

/// Whether plates are gone: two holes are in the starboard side, one is in the port side near the bow.
bool isBroken(const Vec3& p) {
  const double edge = 0.9 * (noise(p * 1.3, kWreckSeed + 15) - 0.5);
  const auto hole = [&](double side, double y, double z, double radius_y, double radius_z) {
    const double dy = (p.y - y) / radius_y;
    const double dz = (p.z - z) / radius_z;
    return p.x * side > 0.0 && det::sqrt(dy * dy + dz * dz) + edge < 1.0;
  };
  return hole(1.0, 2.5, -1.6, 1.4, 3.0) || hole(1.0, 2.0, 7.0, 0.7, 1.0) || hole(-1.0, 2.3, -5.5, 1.3, 2.2);
}

Vec3 middle(const Shape& shape, const std::array<int, 3>& face) {
  Vec3 sum;
  for (const int i : face) sum += shape.points[static_cast<std::size_t>(i)];
  return sum / 3.0;
}

void addHull(Mesh& mesh) {
  for (const double side : {-1.0, 1.0}) {
    Shape shape = grid(
        kStrakes, kStations, false,
        [&](int row, int column) {
          // strakes close together at the bilge
          const double v = static_cast<double>(row) / (kStrakes - 1);
          return hull(column / (kStations - 1.0), v * (0.35 + 0.65 * v), side);
        },
        [&](int row, int column) {
          const double v = static_cast<double>(row) / (kStrakes - 1);
          return plating(hull(column / (kStations - 1.0), v * (0.35 + 0.65 * v), side));
        });
    if (side < 0.0) shape.flip();
    std::erase_if(shape.faces, [&](const auto& face) { return isBroken(middle(shape, face)); });
    mesh.add("hull", shape, Shading::smooth);
  }
  Shape transom = grid(
      kStrakes, 2, false,
      [](int row, int column) {
        const double v = static_cast<double>(row) / (kStrakes - 1);
        return hull(0.0, v * (0.35 + 0.65 * v), column == 0 ? -1.0 : 1.0);
      },
      [](int row, int column) {
        return plating({column * 3.0, row * 0.4, 14.0});
      });
  mesh.add("hull", transom, Shading::flat);
  for (int i = 0; i < 13; ++i) {  // ribs, seen through the holes
    const double s = 0.14 + 0.055 * i;
    for (const double side : {-1.0, 1.0}) {
      std::vector<Vec3> line;
      for (const double v : {0.04, 0.2, 0.4, 0.6, 0.8})
        line.push_back(hull(s, v, side) * Vec3(0.92, 1.0, 1.0) + Vec3(0, 0.14, 0));
      mesh.add("hull", tube(line, {0.09, 0.09, 0.09, 0.09, 0.09}, 4, {0.16, 0.07, 0.035}), Shading::smooth);
    }
  }
}

void addDeck(Mesh& mesh) {
  Shape deck = grid(
      kStations, 7, false,
      [](int row, int column) {
        const Vec3 edge = hull(row / (kStations - 1.0), kDeckShare, 1.0);
        return Vec3(edge.x * (column - 3) / 3.0, edge.y, edge.z);
      },
      [](int row, int column) {
        const Vec3 p(column * 1.1, 9.0, row * 0.6);
        return welkin::mix(Colour(0.20, 0.085, 0.04), Colour(0.27, 0.20, 0.14), fractalNoise(p, 3, kWreckSeed + 21));
      });
  std::erase_if(deck.faces, [&](const auto& face) {  // two hatches
    const Vec3 p = middle(deck, face);
    return std::abs(p.x) < 1.9 && ((p.z > -6.2 && p.z < -2.0) || (p.z > -0.6 && p.z < 3.4));
  });
  mesh.add("hull", deck, Shading::flat);
  const double y = hull(0.5, kDeckShare, 1.0).y;
  for (const auto& [from, to] : {std::pair{-6.4, -1.8}, std::pair{-0.8, 3.6}}) {
    const Colour coaming(0.30, 0.12, 0.05);
    for (const double x : {-1.95, 1.95})
      mesh.add("hull", box({{x, y, 0}}, {-0.08, -0.3, from}, {0.08, 0.75, to}, coaming), Shading::flat);
    for (const double z : {from, to})
      mesh.add("hull", box({{0, y, z}}, {-2.03, -0.3, -0.08}, {2.03, 0.75, 0.08}, coaming), Shading::flat);
  }
}

/// A storey with a row of windows round it: posts, a wall below and a beam above.
void addStorey(Mesh& mesh, const Vec3& low, const Vec3& high, double sill, double lintel, int windows) {
  const auto wornWhite = [](const Vec3& low_, const Vec3& high_) {
    Shape shape = box({}, low_, high_, {});
    for (std::size_t i = 0; i < shape.points.size(); ++i) {
      const double worn = fractalNoise(shape.points[i] * 0.9, 3, kWreckSeed + 33);
      shape.colours[i] = welkin::mix(Colour(0.62, 0.60, 0.54), Colour(0.34, 0.17, 0.08), smoothStep(0.45, 0.62, worn));
    }
    return shape;
  };
  constexpr double kPlate = 0.08;
  const auto side = [&](const Vec3& a, const Vec3& b, bool alongX) {
    const double run = alongX ? b.x - a.x : b.z - a.z;
    const auto piece = [&](double from, double to, double y0, double y1) {
      const Vec3 p = alongX ? Vec3(a.x + from, y0, a.z) : Vec3(a.x, y0, a.z + from);
      const Vec3 q = alongX ? Vec3(a.x + to, y1, a.z + kPlate) : Vec3(a.x + kPlate, y1, a.z + to);
      mesh.add("hull", wornWhite(p, q), Shading::flat);
    };
    piece(0.0, run, a.y, a.y + sill);
    piece(0.0, run, a.y + lintel, b.y);
    const double pitch = run / windows;
    for (int i = 0; i <= windows; ++i)
      piece(max(i * pitch - 0.18, 0.0), min(i * pitch + 0.18, run), a.y + sill, a.y + lintel);
  };
  side(low, {high.x, high.y, low.z}, true);
  side({low.x, low.y, high.z - kPlate}, high, true);
  side(low, {low.x, high.y, high.z}, false);
  side({high.x - kPlate, low.y, low.z}, high, false);
  mesh.add("hull", wornWhite({low.x - 0.35, high.y, low.z - 0.35}, {high.x + 0.35, high.y + 0.12, high.z + 0.35}),
           Shading::flat);
}

}  // namespace

Mesh wreck() {
  Mesh mesh;
  addHull(mesh);
  addDeck(mesh);
  const double deck = hull(0.2, kDeckShare, 1.0).y;
  addStorey(mesh, {-2.4, deck, 5.2}, {2.4, deck + 2.3, 11.6}, 1.0, 1.6, 4);
  addStorey(mesh, {-2.0, deck + 2.4, 5.6}, {2.0, deck + 4.7, 9.2}, 1.0, 1.9, 3);
  mesh.add("hull", post({0.0, deck + 2.4, 10.4}, {0.15, deck + 5.6, 10.9}, 0.7, 10, {0.36, 0.13, 0.05}),
           Shading::smooth);
  mesh.add("hull", post({0.0, deck + 4.4, 10.71}, {0.05, deck + 5.1, 10.82}, 0.74, 10, {0.50, 0.46, 0.38}),
           Shading::smooth);
  const Colour spar(0.27, 0.12, 0.06);
  mesh.add("hull", post({0.0, deck - 0.5, -1.2}, {0.3, deck + 7.5, -0.9}, 0.16, 7, spar), Shading::smooth);
  mesh.add("hull", post({0.3, deck + 0.9, -1.3}, {1.6, deck + 4.8, -6.6}, 0.09, 6, spar), Shading::smooth);  // derricks
  mesh.add("hull", post({0.1, deck + 0.9, -0.8}, {-2.3, deck + 2.6, 4.0}, 0.09, 6, spar), Shading::smooth);
  mesh.add("hull", post({-1.3, deck + 6.2, -0.95}, {1.7, deck + 6.5, -0.95}, 0.07, 6, spar), Shading::smooth);
  mesh.add("hull", box({{0, hull(0.86, kDeckShare, 1.0).y, -10.2}}, {-0.7, -0.1, -0.4}, {0.7, 0.7, 0.4}, spar * 1.2),
           Shading::flat);
  return mesh;
}

}  // namespace welkin::island
