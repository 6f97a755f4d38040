// SPDX-License-Identifier: Apache-2.0
#include "generate/talk.h"

#include <utility>

namespace welkin::talk {
namespace {

using island::Colour;
using island::Mesh;
using island::Scene;
using island::Shading;
using island::Vec3;

constexpr Colour kGrey{0.45, 0.43, 0.4};
constexpr Colour kWhite{0.75, 0.75, 0.75};
constexpr Colour kRed{0.75, 0.08, 0.06};
constexpr Colour kGreen{0.08, 0.6, 0.1};
constexpr Colour kWood{0.45, 0.28, 0.14};
constexpr Colour kRoof{0.5, 0.2, 0.12};

/// A scene of one mesh, in the middle of the sector 0_0.
class Builder {
 public:
  Builder() {
    island::Shape ground;  // its upper side alone: nobody sees the others, and the certificate counts every surface
    for (const auto& [x, z] : {std::pair(8, 8), std::pair(8, 56), std::pair(56, 56), std::pair(56, 8)})
      ground.point({double(x), 0, double(z)}, kGrey);
    ground.quad(0, 1, 2, 3);
    mesh_.add("paint", ground, Shading::flat);
  }

  void box(const Vec3& low, const Vec3& high, const Colour& colour) {
    mesh_.add("paint", island::box({}, low, high, colour), Shading::flat);
  }
  void sphere(const Vec3& centre, double radius) {
    const auto place = [&](const Vec3& n) { return centre + n * radius; };
    mesh_.add("paint", island::blob(3, place, [](const Vec3&) { return kWhite; }), Shading::smooth);
  }
  island::GltfFiles encode(const std::string& name) const {
    Scene scene;
    scene.addMaterial({"paint", {1, 1, 1}, 1.0});
    scene.addMesh(name, mesh_);
    island::Node node;
    node.name = node.mesh = name;
    node.role = "static";
    scene.addNode(node);
    return scene.encode(name + ".bin");
  }

 private:
  Mesh mesh_;
};

Builder walls() {
  Builder b;
  b.box({25.6, 0, 22}, {26, 5, 42}, kRed);
  b.box({38, 0, 22}, {38.4, 5, 42}, kGreen);
  b.sphere({32, 1.3, 27}, 1.3);
  b.sphere({29, 1.3, 33}, 1.3);
  b.sphere({35, 1.3, 33}, 1.3);
  return b;
}

Builder yard() {
  Builder b;
  b.box({26, 0, 22}, {38, 3.2, 29}, kWhite);
  b.box({25, 3.2, 21}, {39, 3.5, 32}, kRoof);  // reaches over the porch in the south
  for (const double x : {25.6, 38.2}) b.box({x, 0, 31.4}, {x + 0.2, 3.2, 31.6}, kWood);
  b.box({22, 0, 36}, {30, 1.4, 36.2}, kWood);
  b.box({34, 0, 36}, {42, 1.4, 36.2}, kWood);
  b.sphere({32, 0.8, 33.5}, 0.8);
  return b;
}

Builder lamp() {
  Builder b;
  b.box({31, 0, 28}, {31.2, 3, 40}, kWhite);  // the lamp is west of it
  b.box({22, 0, 23.6}, {44, 4, 24}, kWhite);  // both of its sides see this one
  b.sphere({36, 1, 31}, 1.0);
  return b;
}

}  // namespace

std::array<TalkLevel, 3> talkLevels() {
  return {{{"walls", walls().encode("walls")}, {"yard", yard().encode("yard")}, {"lamp", lamp().encode("lamp")}}};
}

}  // namespace welkin::talk
