// SPDX-License-Identifier: Apache-2.0
#include "generate/plants.h"

#include "generate/noise.h"

namespace welkin::island {
namespace {

constexpr uint32_t kPlantsSeed = 131;

/// Shape of a frond: angles in radians, lengths in metres.
struct Frond {
  Vec3 base;
  double azimuth = 0.0;
  double elevation = 0.0;  ///< at its start
  double bend = 1.2;       ///< downward turn from start to tip
  double reach = 3.4;
  double leaf = 0.85;  ///< length of the longest leaflet
  Colour colour;
  int stations = 15;
};

/// A bent midrib with a row of pointed leaflets on each side, which hang like a roof.
Shape frond(const Frond& f, uint32_t seed) {
  Shape shape;
  const Vec3 away(det::sin(f.azimuth), 0, -det::cos(f.azimuth));
  const Vec3 side = cross(away, Vec3(0, 1, 0));
  std::vector<int> rib;
  std::vector<int> left;
  std::vector<int> right;
  Vec3 p = f.base;
  const double step = f.reach / f.stations;
  for (int i = 0; i <= f.stations; ++i) {
    const double t = static_cast<double>(i) / f.stations;
    const double angle = f.elevation - f.bend * t * (0.5 + 0.5 * t);
    const Vec3 forward = away * det::cos(angle) + Vec3(0, det::sin(angle), 0);
    const Vec3 up = cross(side, forward);
    const Colour shade = f.colour * mix(0.75, 1.15, t);
    rib.push_back(shape.point(p, shade));
    if (i < f.stations) {
      // short at the stem, longest at a third, short at the tip
      const double length_m = f.leaf * min(0.35 + 2.6 * t, 1.0) * (1.0 - 0.72 * t * t);
      for (const double s : {-1.0, 1.0}) {
        const auto id = static_cast<uint32_t>(i * 2 + (s > 0.0 ? 1 : 0));
        const double droop = random(seed, id, 0.45, 0.8);
        const Vec3 tip = p + (side * (s * 0.84) - up * droop + forward * (0.5 + 0.5 * t)) *
                                 (length_m * random(seed + 1, id, 0.85, 1.05));
        (s < 0.0 ? left : right).push_back(shape.point(tip, shade * 1.1));
      }
    }
    p += forward * step;
  }
  for (std::size_t i = 0; i + 1 < rib.size(); ++i) {
    shape.faces.push_back({rib[i], right[i], rib[i + 1]});
    shape.faces.push_back({rib[i], rib[i + 1], left[i]});
  }
  return shape;
}

Colour leafGreen(uint32_t seed, uint32_t id) {
  return welkin::mix(Colour(0.10, 0.24, 0.03), Colour(0.24, 0.36, 0.06), random(seed, id));
}

/// Broad pointed leaves all over a dome, and a dark core that hides the other side.
Mesh roundBush(bool inFlower) {
  Mesh mesh;
  const uint32_t seed = kPlantsSeed + (inFlower ? 40 : 60);
  const auto core = [&](const Vec3& n) {
    return Vec3(n.x, 0.75 * n.y + 0.45, n.z) * (0.55 + 0.3 * noise(n * 2.5 + Vec3(3.0), seed));
  };
  mesh.add("leaf", blob(1, core, [](const Vec3& n) { return Colour(0.035, 0.085, 0.015) * (1.0 + 0.4 * n.y); }),
           Shading::smooth);
  constexpr uint32_t kLeaves = 130;
  for (uint32_t i = 0; i < kLeaves; ++i) {
    // evenly over the sphere's upper part (a Fibonacci lattice)
    const double y = 1.0 - 1.35 * (i + 0.5) / kLeaves;
    const double turn = 2.399963229728653 * i;
    const double r = det::sqrt(1.0 - y * y);
    const Vec3 n(r * det::cos(turn), y, r * det::sin(turn));
    const Vec3 base = core(n) * 0.92;
    const Vec3 lift = normalise(n + Vec3(random(seed + 3, i, -0.8, 0.8), 0.3, random(seed + 4, i, -0.8, 0.8)));
    const Frame frame = frameAlong(base, lift);
    const double size = random(seed + 5, i, 0.25, 0.38);
    const Colour green =
        welkin::mix(Colour(0.07, 0.19, 0.025), Colour(0.22, 0.34, 0.06), random(seed + 6, i)) * (0.75 + 0.35 * y);
    Shape leaf;
    leaf.point(frame({0, 0, 0}), green * 0.6);
    leaf.point(frame({0.38 * size, 0.05, 0.5 * size}), green);
    leaf.point(frame({0, -0.25 * size, 1.15 * size}), green * 1.15);
    leaf.point(frame({-0.38 * size, 0.05, 0.5 * size}), green);
    leaf.quad(0, 1, 2, 3);
    mesh.add("leaf", leaf, Shading::smooth);
    if (!inFlower || i % 5 != 0) continue;
    const Frame stalk = frameAlong(base + lift * (0.75 * size), lift);
    Shape flower;
    const int middle = flower.point(stalk({0, 0, 0}), {1.0, 0.75, 0.2});
    for (int petal = 0; petal < 6; ++petal)
      flower.point(stalk({0.12 * det::cos(kTau * petal / 6), 0.12 * det::sin(kTau * petal / 6), 0.05}), Colour(1.0));
    for (int petal = 0; petal < 6; ++petal)
      flower.faces.push_back({middle, middle + 1 + petal, middle + 1 + (petal + 1) % 6});
    mesh.add("flower", flower, Shading::smooth);
  }
  return mesh;
}

/// A tuft of grass: bent blades.
Mesh tuft() {
  Mesh mesh;
  for (uint32_t i = 0; i < 22; ++i) {
    const double turn = kTau * random(kPlantsSeed + 91, i);
    const double out = random(kPlantsSeed + 92, i, 0.0, 0.22);
    const Vec3 away(det::cos(turn), 0, det::sin(turn));
    const Vec3 side = cross(away, Vec3(0, 1, 0)) * 0.03;
    const Vec3 base = away * out;
    const double high = random(kPlantsSeed + 93, i, 0.28, 0.55);
    const Vec3 knee = base + away * (0.12 * high) + Vec3(0, 0.65 * high, 0);
    const Vec3 tip = base + away * random(kPlantsSeed + 94, i, 0.15, 0.4) + Vec3(0, high, 0);
    const Colour green = welkin::mix(Colour(0.13, 0.24, 0.035), Colour(0.34, 0.36, 0.09), random(kPlantsSeed + 95, i));
    Shape blade;
    blade.point(base - side, green * 0.6);
    blade.point(base + side, green * 0.6);
    blade.point(knee + side, green);
    blade.point(knee - side, green);
    blade.point(tip, green * 1.2);
    blade.quad(0, 3, 2, 1);
    blade.faces.push_back({3, 4, 2});
    mesh.add("leaf", blade, Shading::smooth);
  }
  return mesh;
}

}  // namespace

Mesh palm(int variant) {
  Mesh mesh;
  const auto v = static_cast<uint32_t>(variant);
  const uint32_t seed = kPlantsSeed + 10 * v;
  const double height = 7.2 + 1.3 * variant;
  const double lean = variant == 0 ? 3.0 : variant == 1 ? 1.5 : 2.2;
  std::vector<Vec3> line;
  std::vector<double> radius;
  constexpr int kRings = 13;
  for (int i = 0; i <= kRings; ++i) {
    const double t = static_cast<double>(i) / kRings;
    // leans at once, then rights itself
    line.push_back({0.25 * det::sin(3.0 * t), height * t - 0.4, -lean * t * (1.5 - 0.5 * t)});
    const double foot = 0.16 * (1.0 - t) * (1.0 - t) * (1.0 - t) * (1.0 - t);
    radius.push_back((0.2 - 0.07 * t + foot) * (i % 2 == 0 ? 1.07 : 0.93));
  }
  Shape trunk = tube(line, radius, 7, {0.36, 0.29, 0.21});
  for (std::size_t i = 0; i < trunk.points.size(); ++i)
    trunk.colours[i] *= 0.75 + 0.5 * noise(trunk.points[i] * Vec3(1.0, 3.0, 1.0), seed);
  mesh.add("bark", trunk, Shading::smooth);

  const Vec3 crown = line.back() + Vec3(0, 0.02, 0);
  const int fronds = 11 + variant % 2;
  for (int i = 0; i < fronds; ++i) {
    const auto id = static_cast<uint32_t>(i);
    Frond f;
    f.base = crown;
    f.azimuth = kTau * i / fronds + random(seed + 1, id, -0.2, 0.2);
    f.elevation = (i % 2 == 0 ? 0.95 : 0.35) + random(seed + 2, id, -0.15, 0.2);
    f.bend = random(seed + 3, id, 1.35, 1.8);
    f.reach = random(seed + 4, id, 3.3, 4.1);
    f.colour = leafGreen(seed + 5, id);
    mesh.add("leaf", frond(f, seed + 6 + id), Shading::smooth);
  }
  for (uint32_t i = 0; i < 2; ++i) {  // withered ones hang along the trunk
    Frond f;
    f.base = crown - Vec3(0, 0.15, 0);
    f.azimuth = kTau * random(seed + 7, i);
    f.elevation = -0.75;
    f.bend = 0.7;
    f.reach = 2.5;
    f.leaf = 0.55;
    f.colour = {0.34, 0.22, 0.09};
    f.stations = 9;
    mesh.add("leaf", frond(f, seed + 30 + i), Shading::smooth);
  }
  for (int i = 0; i < 5; ++i) {
    const double turn = kTau * i / 5;
    const Vec3 centre = crown + Vec3(0.24 * det::cos(turn), -0.2, 0.24 * det::sin(turn));
    mesh.add("bark",
             blob(
                 1, [&](const Vec3& n) { return centre + n * Vec3(0.13, 0.16, 0.13); },
                 [](const Vec3&) { return Colour(0.22, 0.18, 0.05); }),
             Shading::smooth);
  }
  return mesh;
}

Mesh bush(int variant) {
  if (variant < 2) return roundBush(variant == 1);
  if (variant == 3) return tuft();
  Mesh mesh;
  for (int i = 0; i < 13; ++i) {
    const auto id = static_cast<uint32_t>(i);
    Frond f;
    f.azimuth = kTau * i / 13 + random(kPlantsSeed + 81, id, -0.2, 0.2);
    f.elevation = (i % 3 == 0 ? 1.25 : i % 3 == 1 ? 0.9 : 0.6) + random(kPlantsSeed + 82, id, -0.1, 0.1);
    f.bend = random(kPlantsSeed + 83, id, 1.2, 1.7);
    f.reach = random(kPlantsSeed + 84, id, 1.2, 1.8);
    f.leaf = 0.3;
    f.stations = 8;
    f.colour = leafGreen(kPlantsSeed + 85, id) * 0.85;
    mesh.add("leaf", frond(f, kPlantsSeed + 86 + id), Shading::smooth);
  }
  return mesh;
}

}  // namespace welkin::island
