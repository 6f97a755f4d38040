// SPDX-License-Identifier: Apache-2.0
#include "generate/terrain.h"

#include <cmath>

#include "generate/layout.h"
#include "generate/noise.h"

namespace welkin::island {
namespace {

constexpr uint32_t kCoastSeed = 11;
constexpr uint32_t kHillSeed = 23;
constexpr uint32_t kCliffSeed = 37;
constexpr uint32_t kColourSeed = 53;

constexpr int kCells = 132;
constexpr double kCentreSpacing = 0.5;  // share of the mean spacing: finer at the village

double disc(double x, double z, double centre_x, double centre_z, double radius) {
  const double dx = x - centre_x;
  const double dz = z - centre_z;
  return radius - det::sqrt(dx * dx + dz * dz);
}

/// Share of a hill's height at the distance q, in units of its radius.
double dome(double q) {
  const double inside = max(1.0 - q * q, 0.0);
  return inside * inside;
}

/// Steps of `step` metres: a gentle tread below, a cliff above.
double terrace(double height, double step) {
  const double level = std::floor(height / step);
  const double t = height / step - level;
  return step * (level + 0.3 * t + 0.7 * smoothStep(0.5, 0.86, t));
}

/// The spur of rock that holds the cave, and the level ground in front of it.
double withCave(double height, double x, double z) {
  const CaveSite site = caveSite();
  const Frame frame = frameAt(site.mouth, site.azimuth_rad);
  const Vec3 p = Vec3(x, site.mouth.y, z) - site.mouth;
  const double along = -dot(p, frame.z);  // the way in
  const double across = dot(p, frame.x);
  const double side = max(std::abs(across) - 5.0, 0.0);
  const double rough = fractalNoise({x * 0.16, 0.0, z * 0.16}, 3, kCliffSeed + 9);
  const double floor = site.mouth.y;
  const double crest = floor + 5.6 + 3.0 * rough + 0.2 * along - 0.10 * side * side - 0.6 * max(along - 24.0, 0.0);
  const double inside = smoothStep(-0.2, 1.6, along + 1.6 * (rough - 0.5));
  double result = mix(height, smoothMax(height, crest, 3.0), inside);
  const double forecourt =
      smoothStep(1.2, -0.2, along) * smoothStep(10.0, 5.0, std::abs(across)) * smoothStep(-22.0, -7.0, along);
  result = mix(result, smoothMin(result, floor - 0.12, 0.3), forecourt);
  return result;
}

Colour groundColour(double x, double z) {
  const double y = height_m(x, z);
  const double slope = 1.0 - groundNormal(x, z).y;
  const double fine = fractalNoise({x * 0.7, 0.0, z * 0.7}, 3, kColourSeed);
  const double broad = fractalNoise({x * 0.055, 0.0, z * 0.055}, 3, kColourSeed + 7);

  const Colour dry = welkin::mix(Colour(0.58, 0.46, 0.29), Colour(0.80, 0.69, 0.50), fine);
  const Colour wet(0.34, 0.26, 0.16);
  const Colour seabed = welkin::mix(Colour(0.40, 0.40, 0.28), Colour(0.12, 0.18, 0.14), smoothStep(-1.0, -7.0, y));
  Colour colour = welkin::mix(wet, dry, smoothStep(0.25, 0.75, y + 0.35 * (broad - 0.5)));
  colour = welkin::mix(colour, seabed, smoothStep(-0.2, -1.6, y));

  const Colour meadow = welkin::mix(Colour(0.13, 0.22, 0.035), Colour(0.25, 0.30, 0.06), fine);
  const Colour jungle = welkin::mix(Colour(0.05, 0.12, 0.02), Colour(0.12, 0.20, 0.035), fine);
  const Colour grass = welkin::mix(meadow, jungle, smoothStep(4.0, 13.0, y + 10.0 * (broad - 0.5)));
  const double grown = smoothStep(1.5, 2.05, y + 1.3 * (broad - 0.5) + 0.7 * (fine - 0.5));
  const double sandy = smoothStep(17.0, 10.0, inland_m(x, z) + 7.0 * (fine - 0.5)) * smoothStep(4.5, 2.8, y);
  const double trodden = smoothStep(3.4, 1.6, distanceToPath_m(x, z) + 2.4 * (fine - 0.5));
  colour = welkin::mix(colour, grass, grown * (1.0 - trodden) * (1.0 - sandy));

  const double band = noise({x * 0.05, y * 0.9, z * 0.05}, kColourSeed + 11);
  const Colour rock =
      welkin::mix(Colour(0.13, 0.11, 0.095), Colour(0.37, 0.32, 0.26), smoothStep(0.25, 0.75, 0.6 * band + 0.4 * fine));
  const double bare = smoothStep(0.25, 0.36, slope + 0.16 * (fine - 0.5)) * smoothStep(-2.0, 1.0, y);
  return welkin::mix(colour, rock, bare);
}

}  // namespace

CaveSite caveSite() {
  return {{-4.0, 3.4, -26.0}, 35.0 * kTau / 360.0};
}

double inland_m(double x, double z) {
  double d = disc(x, z, 26.0, -40.0, 60.0);
  d = smoothMax(d, disc(x, z, 40.0, 30.0, 50.0), 24.0);
  d = smoothMax(d, disc(x, z, 16.0, 72.0, 31.0), 24.0);
  d = smoothMax(d, disc(x, z, -44.0, -56.0, 24.0), 30.0);
  d = smoothMin(d, -disc(x, z, -62.0, 8.0, 48.0), 20.0);
  return d + 9.0 * (fractalNoise({x / 26.0, 0.0, z / 26.0}, 3, kCoastSeed) - 0.5);
}

double height_m(double x, double z) {
  const double d = inland_m(x, z);
  if (d < 0.0) return max(0.085 * d - 0.0032 * d * d, -14.0);
  const double undulation = fractalNoise({x / 17.0, 0.0, z / 17.0}, 2, kHillSeed + 5) - 0.5;
  double y = 3.4 * d / (d + 40.0) + 1.8 * undulation * smoothStep(10.0, 34.0, d);

  const double ridges = fractalNoise({x / 19.0, 0.0, z / 19.0}, 4, kHillSeed) - 0.5;
  const double peak_x = (x - 30.0) / 57.0, peak_z = (z + 52.0) / 50.0;
  const double head_x = (x + 47.0) / 24.0, head_z = (z + 60.0) / 22.0;
  double hill = 35.0 * dome(det::sqrt(peak_x * peak_x + peak_z * peak_z));
  hill = smoothMax(hill, 12.0 * dome(det::sqrt(head_x * head_x + head_z * head_z)), 3.0);
  hill += 15.0 * ridges * smoothStep(0.0, 12.0, hill);
  const double cliffs =
      smoothStep(0.44, 0.58, fractalNoise({x / 30.0, 0.0, z / 30.0}, 2, kCliffSeed)) * smoothStep(3.0, 6.0, hill);
  const double dip = 9.0 * fractalNoise({x / 34.0, 0.0, z / 34.0}, 2, kCliffSeed + 6);
  hill = mix(hill, terrace(hill + dip, 9.0) - dip, cliffs);
  hill += 2.4 * (fractalNoise({x / 4.5, hill / 7.0, z / 4.5}, 2, kCliffSeed + 4) - 0.5) * smoothStep(5.0, 10.0, hill);
  y += max(hill, 0.0) * smoothStep(0.5, 13.0, d);
  return withCave(y, x, z);
}

Vec3 groundNormal(double x, double z) {
  constexpr double kReach = 0.6;
  const double east = height_m(x + kReach, z) - height_m(x - kReach, z);
  const double south = height_m(x, z + kReach) - height_m(x, z - kReach);
  return normalise({-east, 2.0 * kReach, -south});
}

Shape terrain() {
  const auto coordinate = [](int i, double finest) {
    const double t = 2.0 * i / kCells - 1.0;
    return kHalfExtent_m * t * (kCentreSpacing + (1.0 - kCentreSpacing) * t * t) + finest * (1.0 - t * t);
  };
  const auto x = [&](int column) { return coordinate(column, 2.0); };
  const auto z = [&](int row) { return coordinate(kCells - row, 26.0); };
  Shape shape = grid(
      kCells + 1, kCells + 1, false, [&](int row, int column) { return onGround(x(column), z(row)); },
      [&](int row, int column) { return groundColour(x(column), z(row)); });

  // The hole: the faces of the cliff that stand in the cave's opening. The cave's collar covers its ragged edge.
  const CaveSite site = caveSite();
  const Frame frame = frameAt(site.mouth, site.azimuth_rad);
  std::erase_if(shape.faces, [&](const std::array<int, 3>& face) {
    Vec3 centre;
    double top = -1e9;
    for (const int i : face) {
      const Vec3& p = shape.points[static_cast<std::size_t>(i)];
      centre += p / 3.0;
      top = max(top, p.y);
    }
    const Vec3 p = centre - site.mouth;
    const double along = -dot(p, frame.z);
    const double rise = top - site.mouth.y;
    return std::abs(dot(p, frame.x)) < 3.9 && along > -3.0 && along < 3.2 && rise > 0.25;
  });
  return shape;
}

}  // namespace welkin::island
