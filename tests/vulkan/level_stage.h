// SPDX-License-Identifier: Apache-2.0
// Shared parts of the level picture's tests: a level with its sky, device and view, and a pixel as the CPU computes it.
#pragma once

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>

#include "probes/loader/read_scene.h"
#include "render/level_view.h"
#include "render/views.h"
#include "test_sky.h"
#include "tests/folder.h"
#include "tests/gltf_text.h"
#include "worst.h"

namespace welkin::tests {

using f64::Number3;
using level::Scene;
using render::Camera;
using render::FloatImage;
using render::LevelOptions;

/// Albedo and normal are stored as half floats, which a device may truncate: each loses up to 2^-10 = 9.8e-4 of itself.
/// Positions, from a 32-bit depth, and the sky's series are off by far less.
inline constexpr double kSurfaceTolerance = 1.2e-3;

inline Scene sceneOf(const GltfText& gltf) {
  const Folder folder;
  level::LevelFile level;
  level.geometry.push_back({folder.write("a.gltf", gltf.text()), {}, geometry::Role::fixed, {}});
  return loader::readScene(level);
}

inline std::vector<double> listOf(const Number3& v) {
  return {v.x, v.y, v.z};
}

/// Whether the ray meets the box from `low` to `high`, by slabs.
inline bool meets(const Number3& from, const Number3& direction, const Number3& low, const Number3& high) {
  double enter = 0.0;
  double leave = 1e30;
  for (int i = 0; i < 3; ++i) {
    const double a = (low[i] - from[i]) / direction[i];
    const double b = (high[i] - from[i]) / direction[i];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return enter < leave;
}

struct Pixel {
  uint32_t x, y;
  Number3 ray;
};

/// Calls `visit` for every pixel with its unit ray.
inline void forEachPixel(const FloatImage& image, const Camera& camera,
                         const std::function<void(const Pixel&)>& visit) {
  const auto m = render::inverseViewProjection(camera, static_cast<double>(image.width) / image.height);
  for (uint32_t y = 0; y < image.height; ++y)
    for (uint32_t x = 0; x < image.width; ++x) {
      const double ndc[2] = {2.0 * (x + 0.5) / image.width - 1.0, 2.0 * (y + 0.5) / image.height - 1.0};
      Number3 ray;
      for (int i = 0; i < 3; ++i) {
        const auto at = static_cast<std::size_t>(i);
        ray[i] = ndc[0] * double{m[at]} + ndc[1] * double{m[4 + at]} + double{m[12 + at]};
      }
      visit({x, y, ray / std::sqrt(dot(ray, ray))});
    }
}

inline Number3 vectorOf(const float v[3]) {
  return {double{v[0]}, double{v[1]}, double{v[2]}};
}

inline Number3 skyIrradiance(const Sky& sky, const WelkinSkySample& sample, const Number3& normal) {
  const float n[3] = {static_cast<float>(normal.x), static_cast<float>(normal.y), static_cast<float>(normal.z)};
  float e[3];
  REQUIRE(welkin_sky_irradiance(sky.get(), &sample, n, e) == WELKIN_OK);
  return vectorOf(e);
}

inline Number3 domeRadiance(const Sky& sky, const WelkinSkySample& sample, const Number3& direction) {
  const float d[3] = {static_cast<float>(direction.x), static_cast<float>(direction.y),
                      static_cast<float>(direction.z)};
  float radiance[3];
  REQUIRE(welkin_dome_radiance(sky.get(), &sample, d, radiance) == WELKIN_OK);
  return vectorOf(radiance);
}

inline void compare(Worst& worst, const FloatImage& image, const Pixel& p, const Number3& expected) {
  for (int i = 0; i < 3; ++i)
    worst.compare(double{image.pixel(p.x, p.y)[i]}, expected[i], std::max(expected[i], 1e-9), [&] {
      return "pixel " + std::to_string(p.x) + "," + std::to_string(p.y) + " channel " + std::to_string(i);
    });
}

inline constexpr render::LevelOptions kPlain{
    .occlusion = false, .waves = false, .mist_per_m = 0.0, .shadow_size = 2048};

/// A sky, a device, a scene and its view, in the order of their construction.
struct Stage {
  explicit Stage(Scene made, const render::LevelOptions& options = kPlain, const TestSkyOptions& sky_options = {})
      : bytes(testSkyFile(sky_options)),
        sky(openTestSky(bytes)),
        device(true),
        scene(std::move(made)),
        view(std::make_unique<render::LevelView>(device, sky, scene, options)) {}

  std::vector<std::byte> bytes;
  Sky sky;
  render::VulkanDevice device;
  Scene scene;
  std::unique_ptr<render::LevelView> view;
};

}  // namespace welkin::tests
