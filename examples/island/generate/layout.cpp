// SPDX-License-Identifier: Apache-2.0
#include "generate/layout.h"

#include "generate/terrain.h"

namespace welkin::island {
namespace {

struct Segment {
  double x0, z0, x1, z1;
};

/// From the jetty through the village to the cave, and to the spit in the south.
constexpr std::array<Segment, 9> kPaths = {{{-7, 27, 1, 37},
                                            {1, 37, 0, 52},
                                            {1, 37, 15, 38},
                                            {15, 38, 14, 22},
                                            {15, 38, 30, 27},
                                            {14, 22, 6, 4},
                                            {6, 4, -9, -19},
                                            {0, 52, -2, 80},
                                            {15, 38, 18, 48}}};

double distance(double x0, double z0, double x1, double z1) {
  return det::sqrt((x1 - x0) * (x1 - x0) + (z1 - z0) * (z1 - z0));
}

double distance(double x, double z, const Segment& s) {
  const double dx = s.x1 - s.x0;
  const double dz = s.z1 - s.z0;
  const double t = clamp(((x - s.x0) * dx + (z - s.z0) * dz) / (dx * dx + dz * dz), 0.0, 1.0);
  return distance(x, z, s.x0 + t * dx, s.z0 + t * dz);
}

}  // namespace

double distanceToPath_m(double x, double z) {
  double nearest = 1e9;
  for (const Segment& s : kPaths) nearest = min(nearest, distance(x, z, s));
  return nearest;
}

double clearance_m(double x, double z) {
  double nearest = 1e9;
  for (const HutPlace& hut : kHuts) nearest = min(nearest, distance(x, z, hut.place.x, hut.place.z) - 5.6);
  const Vec3 mouth = caveSite().mouth;
  nearest = min(nearest, distance(x, z, Segment{mouth.x - 7.0, mouth.z + 10.0, mouth.x + 2.0, mouth.z - 3.0}) - 5.0);
  nearest = min(nearest, distance(x, z, Segment{kJetty.x, kJetty.z, kJetty.x - 32.0, kJetty.z + 1.0}) - 2.0);
  nearest = min(nearest, distance(x, z, kBeachedBoat.x, kBeachedBoat.z) - 3.5);
  const double s = det::sin(radians(kWreck.azimuth_deg)) * 13.0;
  const double c = det::cos(radians(kWreck.azimuth_deg)) * 13.0;
  return min(nearest, distance(x, z, Segment{kWreck.x - s, kWreck.z + c, kWreck.x + s, kWreck.z - c}) - 4.5);
}

bool isInView(double x, double z) {
  return distance(x, z, Segment{-6.0, 78.0, 2.0, 50.0}) < 7.5;
}

}  // namespace welkin::island
