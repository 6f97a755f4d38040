// SPDX-License-Identifier: Apache-2.0
#include "generate/rocks.h"

#include <cmath>

#include "generate/noise.h"

namespace welkin::island {
namespace {

constexpr uint32_t kRocksSeed = 211;

Colour rockColour(const Vec3& p, double light) {
  const double fine = fractalNoise(p * 1.7, 3, kRocksSeed + 1);
  const double band = noise({p.x * 0.2, p.y * 1.3, p.z * 0.2}, kRocksSeed + 2);
  return welkin::mix(Colour(0.20, 0.17, 0.145), Colour(0.38, 0.34, 0.29), 0.5 * fine + 0.5 * band) * light;
}

/// One ring of the cave: distance from the mouth, half the width and height of the opening, shift to the side.
struct Ring {
  double along, halfWidth, height, shift;
};

/// Rings of the inside from its end outward, of the lip, and of the collar back into the hill. A negative `along` lies
/// outside.
constexpr Ring kRings[] = {{19.6, 0.5, 0.6, 3.0}, {19.0, 2.4, 2.4, 3.0}, {17.0, 4.2, 4.4, 2.9}, {14.6, 5.0, 5.4, 2.6},
                           {12.0, 4.9, 5.6, 2.0}, {9.6, 4.1, 5.0, 1.3},  {7.2, 3.3, 4.4, 0.7},  {4.8, 2.8, 4.1, 0.3},
                           {2.6, 2.7, 4.1, 0.1},  {0.8, 2.9, 4.3, 0.0},  {-0.6, 3.2, 4.6, 0.0}, {-1.3, 3.7, 5.1, 0.0},
                           {-1.1, 4.7, 6.3, 0.0}, {-0.2, 5.8, 7.8, 0.0}, {1.4, 6.7, 9.0, 0.0},  {3.6, 7.2, 9.6, 0.0},
                           {6.2, 6.8, 9.0, 0.0},  {8.8, 5.4, 7.0, 0.0}};
constexpr int kRingCount = static_cast<int>(std::size(kRings));
constexpr int kAround = 26;
constexpr int kFirstOutside = 11;  // the lip

Vec3 cavePoint(int row, int column) {
  const Ring& ring = kRings[row];
  const double turn = kTau * column / kAround;
  const double c = det::cos(turn);
  const double s = det::sin(turn);
  // an arch above, a flat floor below
  const double sink = row == kFirstOutside ? -0.5 : row > kFirstOutside ? -1.6 : 0.0;
  const double y = s > 0.0 ? ring.height * s : sink * -s;
  const double x = ring.halfWidth * (s > 0.0 ? c : (c < 0.0 ? -1.0 : 1.0) * det::sqrt(std::abs(c)));
  // the floor reaches out under the ground before the mouth
  const double apron = row + 1 >= kFirstOutside ? 1.9 * smoothStep(0.0, 0.35, -s) : 0.0;
  Vec3 p(x + ring.shift, y, apron - ring.along);
  const double rough = s > 0.02 ? 1.0 : 0.12;
  const Vec3 seedPoint = p * 0.45 + Vec3(7.0);
  const Vec3 offset(fractalNoise(seedPoint, 3, kRocksSeed + 11) - 0.5,
                    fractalNoise(seedPoint, 3, kRocksSeed + 21) - 0.5,
                    fractalNoise(seedPoint, 3, kRocksSeed + 31) - 0.5);
  return p + offset * Vec3(2.2, 2.0 * (p.y > 0.3 ? 1.0 : 0.5), 2.0) * rough;
}

}  // namespace

Mesh rock(int variant) {
  const uint32_t seed = kRocksSeed + 50 + 7 * static_cast<uint32_t>(variant);
  const auto place = [&](const Vec3& n) {
    double radius = 0.75 + 0.55 * fractalNoise(n * 1.4 + Vec3(5.0), 2, seed);
    for (uint32_t cut = 0; cut < 9; ++cut) {  // flat faces, like broken stone
      const Vec3 plane = normalise(
          {random(seed + 3, cut, -1, 1), random(seed + 4, cut, -0.8, 1), random(seed + 5, cut, -1, 1) + 1e-3});
      const double facing = dot(plane, n);
      if (facing > 0.05) radius = min(radius, random(seed + 6, cut, 0.66, 0.95) / facing);
    }
    return n * Vec3(1.15, 0.85, 1.0) * radius;
  };
  Mesh mesh;
  mesh.add("rock",
           blob(2, place, [&](const Vec3& n) { return rockColour(place(n) + Vec3(variant * 31.0), 0.75 + 0.3 * n.y); }),
           Shading::flat);
  return mesh;
}

Mesh cave() {
  // From inside the tunnel the columns run the other way round. The surface turns over at the lip by itself.
  Shape shape = grid(kRingCount, kAround, true, cavePoint, [](int row, int column) {
    const Vec3 p = cavePoint(row, column);
    const bool isFloor = kTau * column / kAround > kTau / 2 || column == 0;
    if (isFloor && row < kFirstOutside)
      return welkin::mix(Colour(0.40, 0.32, 0.22), Colour(0.52, 0.42, 0.28), fractalNoise(p * 0.8, 3, kRocksSeed + 5));
    return rockColour(p, 1.0);
  });
  const int end = shape.point({kRings[0].shift, 0.3, -kRings[0].along - 0.2}, rockColour({}, 1.0));
  for (int i = 0; i < kAround; ++i) shape.faces.push_back({end, (i + 1) % kAround, i});
  Mesh mesh;
  mesh.add("cave_rock", shape, Shading::flat);
  return mesh;
}

}  // namespace welkin::island
