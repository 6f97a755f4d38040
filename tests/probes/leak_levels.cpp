// SPDX-License-Identifier: Apache-2.0
#include "tests/probes/leak_levels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "probes/geometry/random.h"
#include "probes/geometry/tracer.h"
#include "probes/sectors/level_light.h"
#include "tests/probes/rooms.h"
#include "tests/probes/skies.h"

namespace welkin::tests {
namespace {

constexpr double kLeakWall_m = 0.1;
constexpr int kSurfacePoints = 1500;
constexpr int kAirPoints = 500;

using Corner = std::array<double, 2>;

/// A closed prism over a polygon, with a shell of kLeakWall_m about it, turned and moved.
struct Prism {
  std::vector<Corner> corner;  ///< star-shaped about the first, anticlockwise seen against the axis
  double length_m = 0.0;       ///< along the axis
  bool lies = false;           ///< the axis is along z, and the polygon upright; else it is along y
  double turn_rad = 0.0;       ///< about y
  Number3 at;

  Number3 place(const Corner& c, double along) const {
    const Number3 p = lies ? Number3(c[0], c[1], along) : Number3(c[0], along, -c[1]);
    const double cosine = std::cos(turn_rad), sine = std::sin(turn_rad);
    return at + Number3(cosine * p.x + sine * p.z, p.y, cosine * p.z - sine * p.x);
  }
};

struct Facet {
  std::array<Number3, 3> corner;  ///< its front looks inward
};

/// The polygon, moved outward by a distance at every edge.
std::vector<Corner> outset(const std::vector<Corner>& polygon, double by) {
  std::vector<Corner> result;
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Corner &a = polygon[(i + n - 1) % n], &b = polygon[i], &c = polygon[(i + 1) % n];
    const auto outward = [](const Corner& p, const Corner& q) {
      const double length = std::hypot(q[0] - p[0], q[1] - p[1]);
      return Corner{(q[1] - p[1]) / length, -(q[0] - p[0]) / length};
    };
    const Corner u = outward(a, b), v = outward(b, c);
    const double scale = by / (1.0 + u[0] * v[0] + u[1] * v[1]);
    result.push_back({b[0] + (u[0] + v[0]) * scale, b[1] + (u[1] + v[1]) * scale});
  }
  return result;
}

/// Facets of a prism that look inward. Edges in `open` have no wall.
std::vector<Facet> facetsOf(const Prism& prism, const std::vector<Corner>& polygon, double low, double high,
                            const std::vector<std::size_t>& open) {
  std::vector<Facet> facets;
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (std::find(open.begin(), open.end(), i) != open.end()) continue;
    const Number3 a = prism.place(polygon[i], low), b = prism.place(polygon[(i + 1) % n], low);
    const Number3 c = prism.place(polygon[(i + 1) % n], high), d = prism.place(polygon[i], high);
    facets.push_back({{a, c, b}});
    facets.push_back({{a, d, c}});
  }
  for (std::size_t i = 1; i + 1 < n; ++i) {
    facets.push_back({{prism.place(polygon[0], low), prism.place(polygon[i], low), prism.place(polygon[i + 1], low)}});
    facets.push_back(
        {{prism.place(polygon[0], high), prism.place(polygon[i + 1], high), prism.place(polygon[i], high)}});
  }
  return facets;
}

Number3 normalOf(const Facet& f) {
  const Number3 n = cross(f.corner[1] - f.corner[0], f.corner[2] - f.corner[0]);
  return n / std::sqrt(dot(n, n));
}

void addFacet(geometry::Surfaces& s, const Facet& f, bool flip) {
  const auto first = static_cast<std::uint32_t>(s.position.size());
  for (const Number3& p : f.corner) s.position.push_back({p.x, p.y, p.z});
  s.triangle.push_back({{first, first + (flip ? 2U : 1U), first + (flip ? 1U : 2U)}, 0, 0});
}

void addShell(LeakLevel& level, const Prism& prism, geometry::Random& random, const std::vector<std::size_t>& open = {},
              bool looked_at = true) {
  const std::vector<Facet> inner = facetsOf(prism, prism.corner, 0.0, prism.length_m, open);
  for (const Facet& f : inner) addFacet(level.surfaces, f, false);
  const auto outer =
      facetsOf(prism, outset(prism.corner, kLeakWall_m), -kLeakWall_m, prism.length_m + kLeakWall_m, open);
  for (const Facet& f : outer) addFacet(level.surfaces, f, true);
  if (!looked_at) return;
  std::vector<double> until = {0.0};
  for (const Facet& f : inner) {
    const Number3 n = cross(f.corner[1] - f.corner[0], f.corner[2] - f.corner[0]);
    until.push_back(until.back() + std::sqrt(dot(n, n)));
  }
  for (int i = 0; i < kSurfacePoints + kAirPoints; ++i) {
    const double at = random.unit() * until.back();
    const auto found = std::upper_bound(until.begin(), until.end(), at) - until.begin() - 1;
    const Facet& f = inner[static_cast<std::size_t>(std::min<std::ptrdiff_t>(found, std::ssize(inner) - 1))];
    double u = random.unit(), v = random.unit();
    if (u + v > 1.0) std::tie(u, v) = std::pair(1.0 - u, 1.0 - v);
    const Number3 p = f.corner[0] + (f.corner[1] - f.corner[0]) * u + (f.corner[2] - f.corner[0]) * v;
    const double off = random.unit();
    const std::uint64_t axis = random.next() % 6;
    if (i < kSurfacePoints) {
      level.point.push_back({p, normalOf(f), 1.0});
      continue;
    }
    Number3 normal(0.0);
    normal[static_cast<int>(axis % 3)] = axis < 3 ? 1.0 : -1.0;
    constexpr double kNarrowest_m = 0.8;  // of all shapes; no two walls meet at less than a right angle
    level.point.push_back({p + normalOf(f) * (0.99 * kNarrowest_m * off + 1e-3), normal, 0.0});
  }
}

/// The box of a prism and half of its walls.
geometry::Box roomOf(const Prism& prism) {
  geometry::Box box{prism.place(prism.corner[0], 0.0), prism.place(prism.corner[0], 0.0)};
  for (const Corner& c : prism.corner)
    for (const double along : {0.0, prism.length_m}) {
      const Number3 p = prism.place(c, along);
      for (int a = 0; a < 3; ++a) {
        box.low[a] = std::min(box.low[a], p[a]);
        box.high[a] = std::max(box.high[a], p[a]);
      }
    }
  return {box.low - Number3(0.5 * kLeakWall_m), box.high + Number3(0.5 * kLeakWall_m)};
}

std::vector<Corner> rectangle(double width, double depth) {
  return {{0, 0}, {width, 0}, {width, depth}, {0, depth}};
}

/// A box with a door in its first wall, 1 m wide and 2 m high, of which `inner` gets the points.
void addRoomWithDoor(LeakLevel& level, const Prism& prism, geometry::Random& random) {
  Prism closed = prism;
  addShell(level, closed, random, {0});
  const double width = prism.corner[1][0], height = prism.length_m;
  const auto wall = [&](double x0, double x1, double y0, double y1) {
    const auto quad = [&](double z, bool flip) {
      const Number3 a = prism.place({x0, z}, y0), b = prism.place({x1, z}, y0), c = prism.place({x1, z}, y1),
                    d = prism.place({x0, z}, y1);
      addFacet(level.surfaces, {{a, c, b}}, flip);
      addFacet(level.surfaces, {{a, d, c}}, flip);
    };
    quad(0.0, false);
    quad(-kLeakWall_m, true);
  };
  const double left = 0.5 * width - 0.5, right = 0.5 * width + 0.5;
  wall(-kLeakWall_m, left, -kLeakWall_m, height + kLeakWall_m);
  wall(right, width + kLeakWall_m, -kLeakWall_m, height + kLeakWall_m);
  wall(left, right, 2.0, height + kLeakWall_m);
  level.sealed = false;
}

}  // namespace

const std::vector<std::string>& leakShapes() {
  static const std::vector<std::string> kShapes = {
      "hall 20 x 12 m",     "hut 3 x 3 m",        "hut 2.3 x 2.3 m", "hut, turned by 17", "hut, turned by 45",
      "hall, turned by 17", "hall, turned by 45", "corridor 0.8 m",  "corridor 3 m",      "corridor 0.8 m, by 17",
      "L of corridors 2 m", "house with a roof",  "below a floor",   "room with a door"};
  return kShapes;
}

LeakLevel leakLevel(const std::string& shape, std::uint64_t seed) {
  geometry::Random random(seed, 71);
  LeakLevel level;
  level.surfaces = groundOf(Number3(0.5), 200.0);
  Prism prism;
  const double x = random.unit(), z = random.unit();
  prism.at = Number3(20.0 + 4.0 * x, 0.5 * kLeakWall_m, 36.0 + 4.0 * z);
  const auto has = [&](const char* word) { return shape.find(word) != std::string::npos; };
  if (has("17")) prism.turn_rad = 17.0 * det::kPi / 180.0;
  if (has("45")) prism.turn_rad = 45.0 * det::kPi / 180.0;
  prism.length_m = has("hall") ? 5.0 : 2.5;
  prism.corner = rectangle(3, 3);
  if (has("2.3")) prism.corner = rectangle(2.3, 2.3);
  if (has("hall")) prism.corner = rectangle(20, 12);
  if (has("corridor 0.8")) prism.corner = rectangle(18, 0.8);
  if (has("corridor 3")) prism.corner = rectangle(18, 3);
  if (has("L of")) prism.corner = {{2, 2}, {2, 12}, {0, 12}, {0, 0}, {14, 0}, {14, 2}};
  if (has("roof")) {
    prism.lies = true;
    prism.corner = {{0, 0}, {6, 0}, {6, 2.5}, {3, 4.5}, {0, 2.5}};
    prism.length_m = 9.0;
    prism.at.z -= 9.0;
  }
  if (has("door")) {
    prism.corner = rectangle(7, 6);
    addRoomWithDoor(level, prism, random);
    level.room = {roomOf(prism)};
    return level;
  }
  if (has("below")) prism.corner = rectangle(11, 9);
  addShell(level, prism, random);
  level.room = {roomOf(prism)};
  if (has("L of")) {  // a box a leg
    Prism leg = prism;
    leg.corner = rectangle(14, 2);
    level.room = {roomOf(leg)};
    leg.corner = rectangle(2, 12);
    level.room.push_back(roomOf(leg));
  }
  if (has("below")) {  // an upper storey, open to one side, on the same slab
    prism.at.y += prism.length_m + kLeakWall_m;
    addShell(level, prism, random, {0}, false);
  }
  return level;
}

Leak leakOf(const LeakLevel& level, placement::Walls walls, bool masks) {
  build::BakeSection section;
  section.transfer.rays = 64;
  section.transfer.bounces = 0;
  section.transfer.sun = transfer::SunTransfer::none;
  section.probes.walls = walls;
  const model::Sky sky = uniformSky(1.0);
  const build::LevelBake bake(level.surfaces, section, sky, std::nullopt);
  std::vector<sectors::SectorFile> sectors = {bake.bake({0, 0}, {})};
  if (!masks) std::fill(sectors[0].cuts.mask.begin(), sectors[0].cuts.mask.end(), format::kAllOpen);
  const sectors::LevelLight light(sectors, sky, 12.0);
  const geometry::Tracer tracer(level.surfaces);
  const auto place = transfer::decodedProbes(sectors[0].probes, sectors[0].id).position;
  Leak leak;
  leak.cut_cells = sectors[0].cuts.cell.size();
  leak.bytes = sectors[0].cuts.bytes();
  for (const LeakPoint& p : level.point) {
    const auto found = light.at(p.position, p.normal, p.push_m);
    if (!found) {
      ++leak.without;
      continue;
    }
    double share = found->sky.y / det::kPi;
    leak.any = leak.any || !(found->sky == Number3(0.0));
    if (!level.sealed) {
      double seen = 0.0;
      const Number3 from = p.position + p.normal * (p.push_m > 0.0 ? 0.02 : 0.0);
      for (std::size_t i = 0; i < place.size(); ++i) {
        const Number3 way = place[i] - from;
        const double far = std::sqrt(dot(way, way));
        if (!tracer.occluded(from, way / far, far)) seen = std::max(seen, light.ofProbe({0, 0}, i, p.normal).sky.y);
      }
      share = std::max(0.0, share - seen / det::kPi);
    }
    leak.mean += share / static_cast<double>(level.point.size());
    if (share > leak.worst) {
      leak.worst = share;
      leak.worst_at = p;
    }
  }
  return leak;
}

}  // namespace welkin::tests
