// SPDX-License-Identifier: Apache-2.0
#include "engine_lookup.h"

#include <cmath>

namespace welkin::tests {
namespace {

using det::Number3;

constexpr double kPi = 3.14159265358979323846;

/// The face of a vector and the place in it, as OpenGL, Vulkan and Direct3D choose it ("Cube Map Face Selection").
CubePlace textureUnit(double x, double y, double z) {
  const double ax = std::abs(x), ay = std::abs(y), az = std::abs(z);
  const auto place = [](int face, double sc, double tc, double ma) {
    return CubePlace{face, 0.5 * (sc / ma + 1.0), 0.5 * (tc / ma + 1.0)};
  };
  if (az >= ax && az >= ay) return z > 0 ? place(4, x, -y, az) : place(5, -x, -y, az);
  if (ay >= ax) return y > 0 ? place(2, x, z, ay) : place(3, x, -z, ay);
  return x > 0 ? place(0, -z, -y, ax) : place(1, z, -y, ax);
}

double fraction(double x) {
  return x - std::floor(x);
}

CubePlace plainCube(const Number3& d) {
  return textureUnit(d.x, d.y, d.z);
}

/// Welkin: docs/conventions.md. Column 0 is north, and azimuths grow to the right.
LatlongPlace welkinLatlong(const Number3& d) {
  return {fraction(std::atan2(d.x, -d.z) / (2 * kPi)), 0.5 - std::asin(d.y) / kPi};
}

/// three.js: the world is Welkin's. PMREMGenerator.js and the background negate x of a CubeTexture's lookup
/// (flipEnvMap). equirectUv() in common.glsl.js; its v counts from the lower edge.
CubePlace threeCube(const Number3& d) {
  return textureUnit(-d.x, d.y, d.z);
}
LatlongPlace threeLatlong(const Number3& d) {
  return {std::atan2(d.z, d.x) / (2 * kPi) + 0.5, 1.0 - (std::asin(d.y) / kPi + 0.5)};
}

/// Unity: +x east, +y up, +z north. Cubes are sampled with the world's direction. ToRadialCoords() of
/// Skybox-PanoramicBeta.shader; its v counts from the lower edge.
CubePlace unityCube(const Number3& d) {
  return textureUnit(d.x, d.y, -d.z);
}
LatlongPlace unityLatlong(const Number3& d) {
  const double x = d.x, y = d.y, z = -d.z;
  return {fraction(0.5 - std::atan2(z, x) * 0.5 / kPi), 1.0 - (1.0 - std::acos(y) / kPi)};
}

/// Unreal: a glTF's (x, y, z) is its (x, z, y). Cubes are sampled with the world's direction. LookupLongLat() in
/// TextureCompressorModule.cpp gets the world's direction with y and z exchanged.
CubePlace unrealCube(const Number3& d) {
  return textureUnit(d.x, d.z, d.y);
}
LatlongPlace unrealLatlong(const Number3& d) {
  const double world_x = d.x, world_y = d.z, world_z = d.y;
  const double side_x = world_x, side_y = world_z, side_z = world_y;
  return {(1 + std::atan2(side_x, -side_z) / kPi) / 2, std::acos(side_y) / kPi};
}

/// Godot: the world is Welkin's. SKY_COORDS in sky.glsl.
LatlongPlace godotLatlong(const Number3& d) {
  double x = std::atan2(d.x, -d.z);
  if (x < 0.0) x += 2 * kPi;
  return {x / (2 * kPi), std::acos(d.y) / kPi};
}

/// Filament: the world is Welkin's. cmgen reads a latlong by toRectilinear() in CubemapUtils.cpp, then mirrors the
/// cube.
LatlongPlace filamentLatlong(const Number3& d) {
  const double s_x = -d.x, s_y = d.y, s_z = d.z;
  const double xf = std::atan2(s_x, s_z) / kPi, yf = std::asin(s_y) * 2 / kPi;
  return {(xf + 1) * 0.5, (1 - yf) * 0.5};
}

}  // namespace

const std::vector<EngineLookup>& engineLookups() {
  static const std::vector<EngineLookup> lookups = {
      {"welkin", plainCube, welkinLatlong}, {"three", threeCube, threeLatlong},
      {"unity", unityCube, unityLatlong},   {"unreal", unrealCube, unrealLatlong},
      {"godot", plainCube, godotLatlong},   {"filament", plainCube, filamentLatlong}};
  return lookups;
}

}  // namespace welkin::tests
