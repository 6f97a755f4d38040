// SPDX-License-Identifier: Apache-2.0
// Camera, shadow and sea constants of the level picture.
#include "render/level_frame.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "render/waves.h"

namespace welkin::render {
namespace {

using f64::Number3;

constexpr double kNear = 0.05;  // metres

Number3 middle(const level::Bounds& bounds) {
  return (bounds.low + bounds.high) * 0.5;
}

Number3 corner(const level::Bounds& b, int i) {
  return {(i & 1) != 0 ? b.high.x : b.low.x, (i & 2) != 0 ? b.high.y : b.low.y, (i & 4) != 0 ? b.high.z : b.low.z};
}

void setVector(render::shaders::LevelVector& to, const Number3& v, double w) {
  for (int i = 0; i < 3; ++i) to[i] = static_cast<float>(v[i]);
  to[3] = static_cast<float>(w);
}

/// Sets row `row` of a column-major matrix to the dot product with `v` plus `offset`.
void setRow(render::shaders::LevelMatrix& matrix, int row, const Number3& v, double offset) {
  for (int i = 0; i < 3; ++i) matrix[4 * i + row] = static_cast<float>(v[i]);
  matrix[12 + row] = static_cast<float>(offset);
}

/// Sets the matrix from world to device coordinates. Its axes come from the ray matrix: column c there is the direction
/// that device axis c adds.
void setViewProjection(render::shaders::LevelConstants& constants, const Number3& position) {
  const auto axis = [&](int column) {
    const float* c = constants.rays + 4 * column;
    return Number3(double{c[0]}, double{c[1]}, double{c[2]});
  };
  const Number3 right = axis(0) / dot(axis(0), axis(0));
  const Number3 down = axis(1) / dot(axis(1), axis(1));
  const Number3 forward = axis(3);
  setRow(constants.view_projection, 0, right, -dot(right, position));
  setRow(constants.view_projection, 1, down, -dot(down, position));
  setRow(constants.view_projection, 2, Number3(0.0), kNear);
  setRow(constants.view_projection, 3, forward, -dot(forward, position));
}

/// Sets an orthographic map that holds the whole level, as seen from the light. Returns the edge of a texel in metres.
double setShadow(render::shaders::LevelConstants& constants, const level::Bounds& bounds, const Number3& towards,
                 uint32_t size) {
  const Number3 side = std::abs(towards.y) > 0.9 ? Number3(1.0, 0.0, 0.0) : Number3(0.0, 1.0, 0.0);
  Number3 right = cross(side, towards);
  right = right / std::sqrt(dot(right, right));
  const Number3 axes[3] = {right, cross(towards, right), -towards};
  double low[3] = {1e30, 1e30, 1e30};
  double high[3] = {-1e30, -1e30, -1e30};
  for (int i = 0; i < 8; ++i)
    for (int a = 0; a < 3; ++a) {
      const double along = dot(axes[a], corner(bounds, i));
      low[a] = std::min(low[a], along);
      high[a] = std::max(high[a], along);
    }
  const double margin = 4.0 / size;  // Margin of the map for the filter.
  const double edge = std::max({high[0] - low[0], high[1] - low[1], 1e-3}) / (1.0 - 2.0 * margin);
  for (int a = 0; a < 2; ++a) {
    const double centre = 0.5 * (low[a] + high[a]);
    setRow(constants.shadow, a, axes[a] / edge, 0.5 - centre / edge);
  }
  const double depth = (high[2] - low[2]) * 1.02 + 1e-3;
  setRow(constants.shadow, 2, axes[2] / depth, 0.01 - low[2] / depth);
  constants.shadow[15] = 1.0F;
  return edge / size;
}

}  // namespace

const WelkinLight* lightOf(const WelkinSkySample& sample) {
  for (const WelkinLight* light : {&sample.sun, &sample.moon})
    if (light->direction[1] > 0.0F && light->illuminance > 0.0F) return light;
  return nullptr;
}

render::shaders::LevelConstants levelConstants(const level::Scene& scene, const WelkinSkySample& sample,
                                               const Camera& camera, const Number3& position, uint32_t width,
                                               uint32_t height, const LevelOptions& options, bool mirrored) {
  render::shaders::LevelConstants constants{};
  const bool sea = !scene.water.empty();
  const double level = scene.water.high.y;
  const auto rays = inverseViewProjection(camera, static_cast<double>(width) / height);
  std::copy(rays.begin(), rays.end(), constants.rays);
  Number3 eye = position;
  if (mirrored) {
    eye.y = 2.0 * level - eye.y;
    for (int column = 0; column < 4; ++column) constants.rays[4 * column + 1] = -constants.rays[4 * column + 1];
  }
  setViewProjection(constants, eye);
  setVector(constants.camera, eye, kNear);
  const WelkinLight* light = lightOf(sample);
  Number3 towards(0.0, 1.0, 0.0);
  if (light != nullptr) {
    const float* d = light->direction;
    const float* e = light->normal_irradiance;
    towards = {double{d[0]}, double{d[1]}, double{d[2]}};
    if (options.direct) setVector(constants.light_irradiance, {double{e[0]}, double{e[1]}, double{e[2]}}, 0.0);
  }
  const level::Bounds& bounds = scene.bounds.empty() ? scene.water : scene.bounds;
  const double texel = setShadow(constants, bounds, towards, options.shadow_size);
  setVector(constants.light, light != nullptr ? towards : Number3(0.0, -1.0, 0.0), texel);
  constants.light_irradiance[3] = static_cast<float>(1.0 / options.shadow_size);
  const double pixel_rad = 2.0 * std::tan(0.5 * camera.fov_rad) / height;
  constants.picture[1] = options.contact ? 1.0F : 0.0F;
  constants.picture[2] = options.probes ? options.parts.sky : 1.0F;
  setVector(constants.options,
            {options.mist_per_m,
             options.probes       ? double{options.parts.sky}
             : options.flat_light ? 1.0
                                  : 0.0,
             mirrored ? level : -1e30},
            pixel_rad);
  setVector(constants.water, {sea ? level : 0.0, options.waves ? kRippleVariance : 0.0, options.cubemaps ? 1.0 : 0.0},
            options.direct ? static_cast<double>(scene.lights.size()) : 0.0);
  setVector(constants.floor_edge, {bounds.low.x, bounds.low.z, bounds.high.x}, bounds.high.z);
  if (options.waves) {
    const auto waves = wavesAt(sample.time_h);
    std::memcpy(constants.waves, waves.data(), sizeof(constants.waves));
  } else {
    for (render::shaders::LevelVector& wave : constants.waves) wave[0] = 1.0F;  // Zero slope, but a valid direction.
  }
  return constants;
}

std::optional<double> seaBelow(const level::Scene& scene, const Number3& position) {
  if (scene.water.empty() || !(position.y > scene.water.high.y)) return std::nullopt;
  return scene.water.high.y;
}

void lookAtMiddle(const level::Scene& scene, const Number3& position, Camera& camera) {
  const Number3 to = middle(scene.bounds.empty() ? scene.water : scene.bounds) - position;
  camera.yaw_rad = std::atan2(to.x, -to.z);
  camera.pitch_rad = std::atan2(to.y, std::hypot(to.x, to.z));
}

PlacedCamera overview(const level::Scene& scene, double fov_rad) {
  const level::Bounds& bounds = scene.bounds.empty() ? scene.water : scene.bounds;
  const Number3 size = bounds.high - bounds.low;
  const double radius = 0.5 * std::hypot(size.x, size.z);
  PlacedCamera placed{{0.0, 0.0, fov_rad}, middle(bounds)};
  const double distance = 0.8 * radius / std::tan(0.5 * fov_rad);
  placed.position += f64::directionOf(0.75 * f64::kPi, 0.22) * distance;
  lookAtMiddle(scene, placed.position, placed.camera);
  return placed;
}

}  // namespace welkin::render
