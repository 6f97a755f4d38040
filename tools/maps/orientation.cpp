// SPDX-License-Identifier: Apache-2.0
#include "maps/orientation.h"

#include <cmath>

#include "sky/cubemap/cubemap.h"

namespace welkin::maps {
namespace {

const Orientation kWelkin = {"welkin", {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, 0.0};

const Orientation kEngines[] = {
    {"three", {-1, 0, 0}, {0, 1, 0}, {0, 0, 1}, 270.0},  // its shader negates x of a cube texture's lookup
    {"unity", {1, 0, 0}, {0, 1, 0}, {0, 0, -1}, 270.0},  // +x east, +y up, +z north
    {"unreal", {1, 0, 0}, {0, 0, 1}, {0, 1, 0}, 180.0},  // +x east, +y south, +z up
    {"godot", {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, 0.0},
    {"filament", {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, 0.0}};

}  // namespace

const Orientation& welkinOrientation() {
  return kWelkin;
}

std::optional<Orientation> orientationOf(std::string_view engine) {
  for (const Orientation& orientation : kEngines)
    if (engine == orientation.name) return orientation;
  return std::nullopt;
}

std::string engineNames() {
  std::string names;
  for (const Orientation& orientation : kEngines) names += (names.empty() ? "" : ", ") + std::string(orientation.name);
  return names;
}

Number3 cubeDirection(const Orientation& orientation, int face, double s, double t) {
  const cubemap::FaceAxes axes = cubemap::faceAxes(cubemap::Layout::vulkan_cube, face);
  const Number3 lookup = axes.normal + axes.right * (2.0 * s - 1.0) + axes.down * (2.0 * t - 1.0);
  const Number3 direction = orientation.x * lookup.x + orientation.y * lookup.y + orientation.z * lookup.z;
  return direction * (1.0 / std::sqrt(dot(direction, direction)));
}

Number3 latlongDirection(const Orientation& orientation, double u, double v) {
  const double azimuth = det::kTwoPi * u + orientation.left_azimuth_deg * det::kDegree;
  const double elevation = det::kHalfPi - det::kPi * v;
  const double level = det::cos(elevation);
  return {level * det::sin(azimuth), det::sin(elevation), -level * det::cos(azimuth)};
}

}  // namespace welkin::maps
