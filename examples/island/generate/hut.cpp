// SPDX-License-Identifier: Apache-2.0
#include "generate/hut.h"

#include <cmath>

#include "generate/noise.h"

namespace welkin::island {
namespace {

constexpr uint32_t kHutSeed = 71;
constexpr double kHalfWidth = 2.5;   // x
constexpr double kHalfDepth = 3.0;   // z
constexpr double kPorch = 1.9;       // before the front wall
constexpr double kEaveAbove = 2.15;  // eaves above the floor
constexpr double kPlank = 0.5;
constexpr double kThickness = 0.09;

/// The roof's rectangle, and its rise from the eaves to the ridge.
constexpr double kRoofWidth = kHalfWidth + 0.95;
constexpr double kRoofFront = -kHalfDepth - kPorch - 0.35;
constexpr double kRoofBack = kHalfDepth + 0.95;
constexpr double kRise = 2.9;
constexpr double kThatch = 0.2;

const Colour kWood(0.30, 0.19, 0.10);

/// Height of the roof's underside above the eaves.
double roofUnder(double x, double z) {
  const double edge = min(kRoofWidth - std::abs(x), min(z - kRoofFront, kRoofBack - z));
  return clamp(edge / kRoofWidth, 0.0, 1.0) * kRise - kThatch;
}

/// An opening in a wall: its planks and its heights above the floor.
struct Opening {
  int first = 0, count = 0;
  double low = 0.0, high = 0.0;
};

/// A wall from `from` to `from` + `along` x planks, whose outside is to its right. Planks leave the opening free.
Shape wall(const Vec3& from, const Vec3& along, int planks, const Opening& opening, double floor, uint32_t seed) {
  Shape shape;
  const Frame frame = {from, along, {0, 1, 0}, cross(along, Vec3(0, 1, 0))};
  for (int i = 0; i < planks; ++i) {
    const auto id = static_cast<uint32_t>(i);
    const double x0 = i * kPlank;
    const double x1 = x0 + kPlank;
    const Vec3 a = frame({x0, 0, 0});
    const Vec3 b = frame({x1, 0, 0});
    const double top_a = floor + kEaveAbove + roofUnder(a.x, a.z) + 0.08;
    const double top_b = floor + kEaveAbove + roofUnder(b.x, b.z) + 0.08;
    const double out = random(seed, id, 0.0, 0.03);
    const Colour tint = Colour(1.0) * random(seed + 1, id, 0.78, 1.0);
    const auto piece = [&](double low, double high_a, double high_b) {
      Shape plank = box(frame, {x0, low, -kThickness}, {x1, high_a, out}, tint);
      for (const std::size_t corner : {3U, 7U}) plank.points[corner].y = high_b;
      shape.append(plank);
    };
    if (i < opening.first || i >= opening.first + opening.count) {
      piece(floor, top_a, top_b);
    } else {
      if (opening.low > 0.0) piece(floor, floor + opening.low, floor + opening.low);
      piece(floor + opening.high, top_a, top_b);
    }
  }
  return shape;
}

/// A frame of four boards round an opening, in the wall's frame.
Shape casing(const Frame& frame, double x0, double x1, double low, double high) {
  constexpr double kBoard = 0.09;
  constexpr double kOut = 0.07;
  constexpr double kOver = 0.015;  // the boards cover the planks' ends
  const Colour colour(1.0);
  Shape shape = box(frame, {x0 - kBoard, low, -kOut - kThickness}, {x0 + kOver, high, kOut}, colour);
  shape.append(box(frame, {x1 - kOver, low, -kOut - kThickness}, {x1 + kBoard, high, kOut}, colour));
  shape.append(box(frame, {x0 - kBoard, high - kOver, -kOut - kThickness}, {x1 + kBoard, high + kBoard, kOut}, colour));
  return shape;
}

/// A point of the roof: `t` from the eaves to the ridge, `u` round it, counter-clockwise from above.
Vec3 roofPoint(double t, double u, double lift, double floor) {
  const double width = 2.0 * kRoofWidth;
  const double depth = kRoofBack - kRoofFront;
  double s = u * (2.0 * width + 2.0 * depth);
  Vec3 eave;
  if (s < depth) {
    eave = {kRoofWidth, 0, kRoofBack - s};
  } else if ((s -= depth) < width) {
    eave = {kRoofWidth - s, 0, kRoofFront};
  } else if ((s -= width) < depth) {
    eave = {-kRoofWidth, 0, kRoofFront + s};
  } else {
    eave = {-kRoofWidth + (s - depth), 0, kRoofBack};
  }
  const Vec3 ridge(0, 0, clamp(eave.z, kRoofFront + kRoofWidth, kRoofBack - kRoofWidth));
  const Vec3 p = welkin::mix(eave, ridge, t);
  return {p.x, floor + kEaveAbove + kRise * t + lift, p.z};
}

void addRoof(Mesh& mesh, double floor) {
  constexpr int kAround = 72;
  constexpr int kTiers = 4;
  const auto thatchColour = [](int tier, int column, double light) {
    const double straw = random(kHutSeed + 5, static_cast<uint32_t>(tier * 1000 + column), 0.72, 1.0);
    return Colour(0.50, 0.36, 0.17) * (straw * light);
  };
  for (int tier = 0; tier < kTiers; ++tier) {
    const auto point = [&](int row, int column) {
      const double u = static_cast<double>(column) / kAround;
      const double fringe = random(kHutSeed + 3, static_cast<uint32_t>(tier * 1000 + column), 0.0, 0.045);
      const double low = static_cast<double>(tier) / kTiers - (tier > 0 ? 0.06 : 0.0) - fringe;
      if (row == 0) return roofPoint(low + 0.03, u, -0.5 * kThatch, floor);
      if (row == 1) return roofPoint(low, u, 0.04, floor);
      const double t = min((tier + 1.0) / kTiers + 0.01, 0.999);
      return roofPoint(t, u, tier + 1 == kTiers ? 0.1 : 0.02, floor);
    };
    const auto colour = [&](int row, int column) {
      return thatchColour(tier, column, row == 0 ? 0.45 : row == 1 ? 1.0 : 0.8);
    };
    // the fringe, and the slope that ends below the next tier
    mesh.add("thatch", grid(2, kAround, true, point, colour), Shading::smooth);
    const auto above = [](const auto& f) { return [f](int row, int column) { return f(row + 1, column); }; };
    mesh.add("thatch", grid(2, kAround, true, above(point), above(colour)), Shading::smooth);
  }
  Shape under = grid(
      2, 36, true,
      [&](int row, int column) { return roofPoint(row == 0 ? 0.02 : 0.99, column / 36.0, -kThatch, floor); },
      [](int, int) { return Colour(0.22, 0.15, 0.08); });
  under.flip();
  mesh.add("thatch", under, Shading::flat);
  const double ridge = floor + kEaveAbove + kRise;
  mesh.add("thatch",
           tube({{0, ridge + 0.04, kRoofFront + kRoofWidth - 0.4},
                 {0, ridge + 0.10, 0},
                 {0, ridge + 0.04, kRoofBack - kRoofWidth + 0.4}},
                {0.2, 0.2, 0.2}, 6, {0.40, 0.28, 0.13}),
           Shading::smooth);
}

void addStilts(Mesh& mesh, double floor) {
  for (const double x : {-2.35, 0.0, 2.35})
    for (const double z : {-4.7, -2.85, 0.0, 2.85})
      mesh.add("wood", post({x, -2.2, z}, {x * 0.98, floor - 0.1, z}, 0.11, 6, kWood), Shading::smooth);
  for (const double x : {-2.35, 2.35})
    mesh.add("wood", box({}, {x - 0.08, floor - 0.26, -4.85}, {x + 0.08, floor - 0.1, 3.0}, kWood * 0.8),
             Shading::flat);
  // a ladder of broad treads
  for (int i = 0; i < 6; ++i) {
    const double y = floor - 0.22 * (i + 1);
    const double z = -4.95 - 0.26 * i;
    mesh.add("wood", box({}, {-0.55, y - 0.05, z - 0.15}, {0.55, y, z + 0.13}, kWood), Shading::flat);
  }
  for (const double x : {-0.6, 0.6})
    mesh.add("wood", post({x, floor + 0.02, -4.8}, {x, floor - 1.5, -6.4}, 0.06, 5, kWood * 0.8), Shading::smooth);
}

void addStones(Mesh& mesh, double floor) {
  mesh.add("stone", box({}, {-2.62, -1.6, -4.85}, {2.62, floor - 0.12, 3.1}, {0.20, 0.19, 0.17}), Shading::flat);
  const auto course = [&](const Vec3& from, const Vec3& along, double run, uint32_t seed) {
    const Frame frame = {from, along, {0, 1, 0}, cross(along, Vec3(0, 1, 0))};
    for (uint32_t row = 0; row < 2; ++row) {
      double x = -0.06;
      for (uint32_t i = 0; x < run; ++i) {
        const uint32_t id = row * 100 + i;
        const double end = min(x + random(seed, id, 0.5, 0.95), run + 0.06);
        const double top = row == 0 ? floor - 0.13 : floor - 0.45;
        const Colour grey = Colour(0.36, 0.33, 0.29) * random(seed + 1, id, 0.6, 1.1);
        const double out = random(seed + 2, id, 0.06, 0.16);
        mesh.add("stone", box(frame, {x + 0.02, row == 0 ? top - 0.3 : -1.0, -0.2}, {end - 0.02, top, out}, grey),
                 Shading::flat);
        x = end;
      }
    }
  };
  course({-2.62, 0, 3.1}, {1, 0, 0}, 5.24, kHutSeed + 20);
  course({2.62, 0, 3.1}, {0, 0, -1}, 7.95, kHutSeed + 30);
  course({2.62, 0, -4.85}, {-1, 0, 0}, 5.24, kHutSeed + 40);
  course({-2.62, 0, -4.85}, {0, 0, 1}, 7.95, kHutSeed + 50);
  for (int i = 0; i < 3; ++i) {
    const double y = floor - 0.2 * (i + 1);
    mesh.add("stone",
             box({}, {-0.8, -1.2, -5.25 - 0.32 * i}, {0.8, y, -4.9}, Colour(0.38, 0.35, 0.31) * (1.0 - 0.1 * i)),
             Shading::flat);
  }
}

void addFloorAndPorch(Mesh& mesh, double floor) {
  for (int i = 0; i < 20; ++i) {
    const double z = -4.85 + 0.4 * i;
    const Colour colour = kWood * random(kHutSeed + 8, static_cast<uint32_t>(i), 0.75, 1.2);
    mesh.add("wood", box({}, {-2.6, floor - 0.1, z}, {2.6, floor, z + 0.37}, colour), Shading::flat);
  }
  mesh.add("wood", box({}, {-2.58, floor - 0.13, -4.83}, {2.58, floor - 0.03, 3.08}, kWood * 0.5), Shading::flat);
  for (const double x : {-2.45, -0.85, 0.85, 2.45}) {
    const double top = floor + kEaveAbove + roofUnder(x, -4.7) + 0.1;
    mesh.add("wood", post({x, floor, -4.7}, {x, top, -4.7}, 0.075, 6, kWood), Shading::smooth);
  }
  for (const double s : {-1.0, 1.0})
    for (const double y : {0.45, 0.9}) {
      mesh.add("wood",
               box({}, {min(s * 0.85, s * 2.45), floor + y - 0.03, -4.73},
                   {max(s * 0.85, s * 2.45), floor + y + 0.03, -4.67}, kWood * 1.2),
               Shading::flat);
      mesh.add(
          "wood",
          box({}, {s * 2.45 - 0.03, floor + y - 0.03, -4.7}, {s * 2.45 + 0.03, floor + y + 0.03, -3.0}, kWood * 1.2),
          Shading::flat);
    }
}

void addRoom(Mesh& mesh, double floor) {
  const auto wood = [&](const Vec3& low, const Vec3& high) {
    mesh.add("wood", box({{0, floor, 0}}, low, high, kWood * 1.1), Shading::flat);
  };
  wood({0.9, 0.25, 0.5}, {2.3, 0.4, 2.7});  // a bed with a blanket
  mesh.add("wall_white", box({{0, floor, 0}}, {0.95, 0.4, 0.55}, {2.25, 0.5, 2.65}, Colour(0.95)), Shading::flat);
  for (const double x : {1.0, 2.2})
    for (const double z : {0.6, 2.6}) wood({x - 0.06, 0, z - 0.06}, {x + 0.06, 0.25, z + 0.06});
  wood({-2.2, 0.7, 1.2}, {-1.1, 0.76, 2.6});  // a table
  for (const double x : {-2.1, -1.2})
    for (const double z : {1.3, 2.5}) wood({x - 0.04, 0, z - 0.04}, {x + 0.04, 0.7, z + 0.04});
}

}  // namespace

Mesh hut(bool onStilts) {
  Mesh mesh;
  const double floor = onStilts ? 1.25 : 0.62;
  const Opening door = {4, 2, 0.0, 2.05};
  const Opening window = {5, 2, 0.95, 1.75};
  Shape walls = wall({kHalfWidth, 0, -kHalfDepth}, {-1, 0, 0}, 10, door, floor, kHutSeed + 60);
  walls.append(wall({-kHalfWidth, 0, -kHalfDepth}, {0, 0, 1}, 12, window, floor, kHutSeed + 62));
  walls.append(wall({-kHalfWidth, 0, kHalfDepth}, {1, 0, 0}, 10, {}, floor, kHutSeed + 64));
  walls.append(wall({kHalfWidth, 0, kHalfDepth}, {0, 0, -1}, 12, window, floor, kHutSeed + 66));
  mesh.add("wall_red", walls, Shading::flat);

  const Frame front = {{kHalfWidth, floor, -kHalfDepth}, {-1, 0, 0}, {0, 1, 0}, {0, 0, -1}};
  const Frame left = {{-kHalfWidth, floor, -kHalfDepth}, {0, 0, 1}, {0, 1, 0}, {-1, 0, 0}};
  const Frame right = {{kHalfWidth, floor, kHalfDepth}, {0, 0, -1}, {0, 1, 0}, {1, 0, 0}};
  mesh.add("trim", casing(front, 2.0, 3.0, 0.0, 2.05), Shading::flat);
  for (const Frame& side : {left, right}) {
    mesh.add("trim", casing(side, 2.5, 3.5, 0.95, 1.75), Shading::flat);
    mesh.add("trim", box(side, {2.4, 0.87, -0.17}, {3.6, 0.965, 0.12}, Colour(1.0)), Shading::flat);
    // a shutter held up by its sill
    const Frame hinge = {side({2.5, 1.75, 0.05}), side.x, side.y * -0.64 + side.z * 0.768,
                         (side.y * 0.768 + side.z * 0.64) * -1.0};
    mesh.add("trim", box(hinge, {0.0, 0.0, 0.0}, {1.0, 0.85, 0.04}, Colour(0.85)), Shading::flat);
  }
  for (const double x : {-kHalfWidth, kHalfWidth})
    for (const double z : {-kHalfDepth, kHalfDepth})
      mesh.add("trim",
               box({}, {x - 0.1, floor - 0.05, z - 0.1},
                   {x + 0.1, floor + kEaveAbove + roofUnder(x, z) + 0.03, z + 0.1}, Colour(0.95)),
               Shading::flat);
  // the door stands open
  mesh.add("trim",
           box({{-0.52, floor, -kHalfDepth - 0.05}, {-0.34, 0, -0.94}, {0, 1, 0}, {0.94, 0, -0.34}}, {0.0, 0.04, -0.03},
               {0.96, 2.0, 0.02}, Colour(0.8)),
           Shading::flat);

  addFloorAndPorch(mesh, floor);
  addRoom(mesh, floor);
  addRoof(mesh, floor);
  if (onStilts) {
    addStilts(mesh, floor);
  } else {
    addStones(mesh, floor);
  }
  return mesh;
}

}  // namespace welkin::island
