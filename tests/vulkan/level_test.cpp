// SPDX-License-Identifier: Apache-2.0
// The level picture against the CPU: every pixel's surface is found by a ray of the test's own, and its radiance is
// albedo / pi (irradiance of the sky + irradiance of the light where its ray is free).
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>

#include "render/level_view.h"
#include "render/shaders/level_formulas.h"
#include "render/views.h"
#include "test_sky.h"
#include "tests/folder.h"
#include "tests/gltf_text.h"
#include "worst.h"

namespace welkin::tests {
namespace {

using f64::Number3;
using nlohmann::json;
using probes::Scene;
using test::GltfText;
using tools::Camera;
using tools::FloatImage;
using tools::LevelOptions;

/// Albedo and normal are kept as half floats, which a device may truncate: each loses up to 2^-10 = 9.8e-4 of itself.
/// Positions, from a 32-bit depth, and the series of the sky are off by far less.
constexpr double kSurfaceTolerance = 1.2e-3;

const Number3 kGroundAlbedo{0.3, 0.5, 0.2};
constexpr double kBoxHeight = 4.0;

Scene sceneOf(const GltfText& gltf) {
  const test::Folder folder;
  probes::LevelFile level;
  level.geometry.push_back({folder.write("a.gltf", gltf.text()), {}, probes::Role::fixed, {}});
  return probes::readScene(level);
}

std::vector<double> listOf(const Number3& v) {
  return {v.x, v.y, v.z};
}

/// Ground at y = 0, 40 m wide, with a box of 2 x 4 x 3 m in its middle.
Scene groundAndBox() {
  GltfText gltf;
  gltf.addNode(gltf.addMesh(test::squareMesh(), gltf.addMaterial(listOf(kGroundAlbedo))), {{"scale", {20, 1, 20}}});
  gltf.addNode(gltf.addMesh(test::boxMesh(), gltf.addMaterial({0.8, 0.1, 0.1})),
               {{"scale", {1, kBoxHeight / 2, 1.5}}, {"translation", {0, kBoxHeight / 2, 0}}});
  return sceneOf(gltf);
}

/// Whether the ray meets the box from `low` to `high`: slabs.
bool meets(const Number3& from, const Number3& direction, const Number3& low, const Number3& high) {
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
void forEachPixel(const FloatImage& image, const Camera& camera, const std::function<void(const Pixel&)>& visit) {
  const auto m = tools::inverseViewProjection(camera, static_cast<double>(image.width) / image.height);
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

Number3 vectorOf(const float v[3]) {
  return {double{v[0]}, double{v[1]}, double{v[2]}};
}

Number3 skyIrradiance(const Sky& sky, const WelkinSkySample& sample, const Number3& normal) {
  const float n[3] = {static_cast<float>(normal.x), static_cast<float>(normal.y), static_cast<float>(normal.z)};
  float e[3];
  REQUIRE(welkin_sky_irradiance(sky.get(), &sample, n, e) == WELKIN_OK);
  return vectorOf(e);
}

Number3 domeRadiance(const Sky& sky, const WelkinSkySample& sample, const Number3& direction) {
  const float d[3] = {static_cast<float>(direction.x), static_cast<float>(direction.y),
                      static_cast<float>(direction.z)};
  float radiance[3];
  REQUIRE(welkin_dome_radiance(sky.get(), &sample, d, radiance) == WELKIN_OK);
  return vectorOf(radiance);
}

void compare(Worst& worst, const FloatImage& image, const Pixel& p, const Number3& expected) {
  for (int i = 0; i < 3; ++i)
    worst.compare(double{image.pixel(p.x, p.y)[i]}, expected[i], std::max(expected[i], 1e-9), [&] {
      return "pixel " + std::to_string(p.x) + "," + std::to_string(p.y) + " channel " + std::to_string(i);
    });
}

constexpr LevelOptions kPlain{.waves = false, .mist_per_m = 0.0, .shadow_size = 2048};

/// A sky, a device, a scene and its view, in the order in which they must be made.
struct Stage {
  explicit Stage(Scene made, const LevelOptions& options = kPlain, const TestSkyOptions& sky_options = {})
      : bytes(testSkyFile(sky_options)),
        sky(openTestSky(bytes)),
        device(true),
        scene(std::move(made)),
        view(std::make_unique<tools::LevelView>(device, sky, scene, options)) {}

  std::vector<std::byte> bytes;
  Sky sky;
  tools::VulkanDevice device;
  Scene scene;
  std::unique_ptr<tools::LevelView> view;
};

const Camera kDown{0.4, -f64::kHalfPi, 0.9};
const Number3 kAbove{1.0, 30.0, -2.0};

/// Where a ray from above meets the ground; false near the ground's edge and over the box, by `margin` metres.
bool groundAt(const Number3& ray, double margin, Number3& p) {
  p = kAbove + ray * (kAbove.y / -ray.y);
  const Number3 m(margin);
  if (meets(kAbove, ray, Number3(-1.0, 0.0, -1.5) - m, Number3(1.0, kBoxHeight, 1.5) + m)) return false;
  return std::abs(p.x) < 20.0 - margin && std::abs(p.z) < 20.0 - margin;
}

/// Whether the light's ray from `p` meets the box; nothing within `margin` metres of the shadow's edge.
std::optional<bool> shadowAt(const Number3& p, const Number3& light, double margin) {
  const Number3 low(-1.0, 0.0, -1.5);
  const Number3 high(1.0, kBoxHeight, 1.5);
  const Number3 m(margin);
  const bool larger = meets(p, light, low - m, high + m);
  const bool smaller = meets(p, light, low + m, high - m);
  if (larger != smaller) return std::nullopt;
  return larger;
}

}  // namespace

TEST_CASE("LevelView, GroundHasTheRadianceOfSkyAndLight", "[vulkan]") {
  // The map spans about 57 m in 2048 texels of 28 mm; the filter reaches two texels, the offset along the normal as
  // far.
  constexpr double kShadowEdge_m = 0.2;
  struct Light {
    const char* name;
    bool flat;
    uint8_t mode_count;
  };
  for (const auto& [name, flat, mode_count] :
       {Light{"sh", false, 0}, Light{"flat", true, 0}, Light{"modes", false, 7}}) {
    LevelOptions options = kPlain;
    options.flat_light = flat;
    Stage stage(groundAndBox(), options, {.mode_count = mode_count});
    for (const double time_h : {8.5, 12.3, 15.0, 19.0, 2.0}) {
      stage.view->setTime(time_h);
      const WelkinSkySample& sample = stage.view->sample();
      const WelkinLight* light = tools::lightOf(sample);
      const Number3 towards = light != nullptr ? vectorOf(light->direction) : Number3(0.0, -1.0, 0.0);
      const Number3 direct = light != nullptr ? vectorOf(light->normal_irradiance) * towards.y : Number3(0.0);
      CHECK((light == &sample.sun) == (time_h > 6.0 && time_h < 18.0));
      CHECK((light == nullptr) == (time_h == 19.0));  // the sun has set, the moon has not risen
      Number3 ambient = skyIrradiance(stage.sky, sample, {0.0, 1.0, 0.0});
      if (flat) ambient = vectorOf(sample.ambient_sh[0]) * (f64::kPi * f64::shBasis(Number3(0.0)).v[0]);
      const FloatImage image = stage.view->draw(160, 120, kDown, kAbove);
      Worst worst;
      Number3 middle_of_shadow;
      std::size_t lit = 0;
      std::size_t shadowed = 0;
      forEachPixel(image, kDown, [&](const Pixel& pixel) {
        Number3 p;
        if (!groundAt(pixel.ray, kShadowEdge_m, p)) return;
        const auto shadow = light != nullptr ? shadowAt(p, towards, kShadowEdge_m) : std::optional(false);
        if (!shadow) return;
        compare(worst, image, pixel, kGroundAlbedo / f64::kPi * (ambient + (*shadow ? Number3(0.0) : direct)));
        ++(*shadow ? shadowed : lit);
        if (*shadow) middle_of_shadow += p;
      });
      WARN("hour " << time_h << " " << name << ": worst " << worst.error << " at " << worst.where << ", " << lit
                   << " lit, " << shadowed << " in shadow");
      CHECK(lit > 5000);
      CHECK(worst.error < kSurfaceTolerance);
      if (light == nullptr || towards.y > 0.98) continue;  // no shadow, or under the box
      CHECK(shadowed > 100);
      const double side = middle_of_shadow.x * towards.x + middle_of_shadow.z * towards.z;
      CHECK(side < 0.0);  // away from the light
    }
    CHECK(stage.device.messageCount() == 0);
  }
}

TEST_CASE("LevelView, NormalsFollowRotationMirrorAndUnevenScale", "[vulkan]") {
  // A square turned about x and z and stretched; its mirrored twin must not be culled.
  for (const double mirror : {1.0, -1.0}) {
    GltfText gltf;
    const double s = std::sin(0.3);
    const double c = std::cos(0.3);
    gltf.addNode(gltf.addMesh(test::squareMesh(), gltf.addMaterial({0.5, 0.5, 0.5})),
                 {{"rotation", {s, 0, 0, c}}, {"scale", {30 * mirror, 1, 9}}});
    // The scale of a child is in its parent's axes: the normal then needs the cofactor matrix.
    gltf.json["nodes"].push_back({{"scale", {1, 0.5, 1}}, {"children", {0}}});
    gltf.json["scenes"][0]["nodes"] = {1};
    Stage stage(sceneOf(gltf));
    stage.view->setTime(10.0);
    const FloatImage image = stage.view->draw(32, 32, {0.0, -f64::kHalfPi, 0.2}, {0.0, 30.0, 0.0});
    // Turned by 0.6 about x, +y goes to (0, cos, sin); halving y doubles the normal's y.
    Number3 normal(0.0, 2.0 * std::cos(0.6), std::sin(0.6));
    normal = normal / std::sqrt(dot(normal, normal));
    const WelkinSkySample& sample = stage.view->sample();
    const double cosine = dot(normal, vectorOf(sample.sun.direction));
    REQUIRE(cosine > 0.2);
    const Number3 irradiance =
        skyIrradiance(stage.sky, sample, normal) + vectorOf(sample.sun.normal_irradiance) * cosine;
    Worst worst;
    forEachPixel(image, {0.0, -f64::kHalfPi, 0.2},
                 [&](const Pixel& p) { compare(worst, image, p, irradiance * (0.5 / f64::kPi)); });
    WARN("worst " << worst.error << " at " << worst.where);
    CHECK(worst.error < kSurfaceTolerance);
    CHECK(stage.device.messageCount() == 0);
  }
}

TEST_CASE("LevelView, FarPixelsAreTheDome", "[vulkan]") {
  const Camera camera{2.0, 0.5, 0.8};
  Stage stage(groundAndBox(), kPlain, {.disc_radius_rad = 0.1});
  stage.view->setTime(9.0);
  const FloatImage image = stage.view->draw(96, 64, camera, {0.0, 8.0, 0.0});
  tools::Views views(stage.device, stage.sky, WELKIN_VULKAN_ANALYTIC);
  views.setTime(9.0);
  CHECK(image.rgba == views.perspective(96, 64, camera, true).rgba);
  CHECK(stage.device.messageCount() == 0);
}

TEST_CASE("LevelView, TintCanBeLeftOut", "[vulkan]") {
  const Camera camera{2.0, 0.6, 0.8};
  LevelOptions options = kPlain;
  options.tint = false;
  Stage stage(groundAndBox(), options);
  stage.view->setTime(12.0);
  const FloatImage image = stage.view->draw(48, 32, camera, {0.0, 8.0, 0.0});
  WelkinSkySample sample;
  REQUIRE(stage.sky.sample(12.0, sample));
  REQUIRE(sample.polarising_tint[2] < 0.9F);
  for (float& t : sample.polarising_tint) t = 1.0F;
  Worst worst;
  forEachPixel(image, camera,
               [&](const Pixel& p) { compare(worst, image, p, domeRadiance(stage.sky, sample, p.ray)); });
  WARN("worst " << worst.error << " at " << worst.where);
  CHECK(worst.error < shaderTolerance(stage.device));
}

TEST_CASE("LevelView, MistTakesAndGivesBack", "[vulkan]") {
  LevelOptions options = kPlain;
  options.mist_per_m = 0.02;
  Stage stage(groundAndBox(), options);
  stage.view->setTime(19.0);  // no light, so no shadow
  const Camera camera{0.4, -0.9, 0.7};
  const Number3 position(0.0, 12.0, 16.0);
  const FloatImage image = stage.view->draw(64, 48, camera, position);
  const Number3 ground = kGroundAlbedo / f64::kPi * skyIrradiance(stage.sky, stage.view->sample(), {0.0, 1.0, 0.0});
  Worst worst;
  forEachPixel(image, camera, [&](const Pixel& p) {
    const double distance_m = position.y / -p.ray.y;
    const Number3 at = position + p.ray * distance_m;
    if (!(p.ray.y < 0.0) || std::abs(at.x) > 19.9 || std::abs(at.z) > 19.9 ||
        meets(position, p.ray, {-1.05, 0.0, -1.55}, {1.05, kBoxHeight + 0.05, 1.55}))
      return;
    Number3 level(p.ray.x, 0.0, p.ray.z);
    level = level / std::sqrt(dot(level, level)) + Number3(0.0, 1e-3, 0.0);
    const Number3 horizon = domeRadiance(stage.sky, stage.view->sample(), level / std::sqrt(dot(level, level)));
    compare(worst, image, p, mix(horizon, ground, f64::transmittance(0.02, distance_m)));
  });
  WARN("worst " << worst.error << " at " << worst.where << " of " << worst.count);
  CHECK(worst.count > 3000);
  CHECK(worst.error < kSurfaceTolerance + shaderTolerance(stage.device));
  CHECK(stage.device.messageCount() == 0);
}

TEST_CASE("LevelView, CalmSeaMirrorsTheSkyAndTheLevel", "[vulkan]") {
  constexpr double kSea = 1.5;
  GltfText gltf;
  gltf.addNode(gltf.addMesh(test::squareMesh()),
               {{"scale", {100, 1, 100}}, {"translation", {0, kSea, 0}}, {"extras", {{"role", "water"}}}});
  // A box that floats in the air, so that what is seen through the water is water alone.
  const Number3 low(-2.0, kSea + 0.5, -12.0);
  const Number3 high(2.0, kSea + 3.5, -10.0);
  const Number3 albedo(0.8, 0.1, 0.4);
  gltf.addNode(gltf.addMesh(test::boxMesh(), gltf.addMaterial(listOf(albedo))),
               {{"scale", {2, 1.5, 1}}, {"translation", {0, kSea + 2.0, -11}}});
  for (const uint8_t mode_count : {0, 7}) {
    Stage stage(sceneOf(gltf), kPlain, {.mode_count = mode_count});
    stage.view->setTime(15.5);
    const WelkinSkySample& sample = stage.view->sample();
    const Number3 sun = vectorOf(sample.sun.direction);
    REQUIRE(sun.x < -0.3);  // in the west: no glitter to the north, and no shadow of the box there
    const Camera camera{0.0, -0.25, 1.0};
    const Number3 position(0.0, kSea + 4.0, 3.0);
    const FloatImage image = stage.view->draw(160, 120, camera, position);
    const Number3 irradiance =
        skyIrradiance(stage.sky, sample, {0.0, 1.0, 0.0}) + vectorOf(sample.sun.normal_irradiance) * sun.y;
    const Number3 body = f64::kWaterAlbedo / f64::kPi * irradiance;
    // The box's south face as the sun leaves it.
    const double on_face = std::max(sun.z, 0.0);
    const Number3 face =
        albedo / f64::kPi *
        (skyIrradiance(stage.sky, sample, {0.0, 0.0, 1.0}) + vectorOf(sample.sun.normal_irradiance) * on_face);
    Worst of_sky;
    Worst of_box;
    forEachPixel(image, camera, [&](const Pixel& p) {
      if (p.ray.y > -0.02 || meets(position, p.ray, low - Number3(0.1), high + Number3(0.1))) return;
      const Number3 at = position + p.ray * ((position.y - kSea) / -p.ray.y);
      const Number3 mirrored(p.ray.x, -p.ray.y, p.ray.z);
      const double fresnel = f64::schlick(f64::kWaterReflectance, -p.ray.y);
      if (meets(at, sun, low - Number3(0.3), high + Number3(0.3))) return;  // near its shadow
      const bool near = meets(at, mirrored, low - Number3(0.3), high + Number3(0.3));
      // Through the middle of its south face: the picture in the water is sampled at half the picture's size.
      const Number3 on = at + mirrored * ((high.z - at.z) / mirrored.z);
      const bool within = std::abs(on.x) < 1.6 && on.y > low.y + 0.4 && on.y < high.y - 0.4;
      if (within)
        compare(of_box, image, p, mix(body, face, fresnel));
      else if (!near)
        compare(of_sky, image, p, mix(body, domeRadiance(stage.sky, sample, mirrored), fresnel));
    });
    WARN("sky: worst " << of_sky.error << " at " << of_sky.where << " of " << of_sky.count);
    WARN("box: worst " << of_box.error << " at " << of_box.where << " of " << of_box.count);
    CHECK(of_sky.count > 15000);
    CHECK(of_box.count > 300);
    CHECK(of_sky.error < shaderTolerance(stage.device));
    CHECK(of_box.error < kSurfaceTolerance);
    CHECK(stage.device.messageCount() == 0);
  }
}

TEST_CASE("LevelView, CalmSeaMirrorsTheCubemaps", "[vulkan]") {
  // With the view level, the sea's pixel mirrors the sky's pixel above it: what changes in one between the formulas and
  // the cubemaps of noise changes in the other by the share that is mirrored.
  GltfText gltf;
  gltf.addNode(gltf.addMesh(test::squareMesh()), {{"scale", {100, 1, 100}}, {"extras", {{"role", "water"}}}});
  const Camera camera{0.3, 0.0, 1.0};
  const auto drawn = [&](bool cubemaps) {
    LevelOptions options = kPlain;
    options.cubemaps = cubemaps;
    Stage stage(sceneOf(gltf), options);
    stage.view->setTime(15.5);
    auto image = stage.view->draw(64, 64, camera, {0.0, 3.0, 0.0});
    CHECK(stage.device.messageCount() == 0);
    return image;
  };
  const FloatImage formulas = drawn(false);
  const FloatImage cubemaps = drawn(true);
  Worst worst;
  double largest = 0.0;
  forEachPixel(formulas, camera, [&](const Pixel& p) {
    if (p.ray.y > -0.05) return;
    const double fresnel = f64::schlick(f64::kWaterReflectance, -p.ray.y);
    for (int c = 0; c < 3; ++c) {
      const auto change = [&](uint32_t y) {
        return double{cubemaps.pixel(p.x, y)[c]} - double{formulas.pixel(p.x, y)[c]};
      };
      const double sky = change(formulas.height - 1 - p.y);
      largest = std::max(largest, std::abs(sky));
      worst.compare(change(p.y), fresnel * sky, std::max(double{formulas.pixel(p.x, p.y)[c]}, 0.1),
                    [&] { return "pixel " + std::to_string(p.x) + "," + std::to_string(p.y); });
    }
  });
  INFO("worst " << worst.error << " at " << worst.where);
  CHECK(worst.count > 3000);
  CHECK(largest > 0.1);  // the two differ
  CHECK(worst.error < kSurfaceTolerance);
}

TEST_CASE("LevelView, WavesDependOnTheHourAlone", "[vulkan]") {
  GltfText gltf;
  gltf.addNode(gltf.addMesh(test::squareMesh()), {{"scale", {100, 1, 100}}, {"extras", {{"role", "water"}}}});
  LevelOptions options = kPlain;
  options.waves = true;
  Stage stage(sceneOf(gltf), options);
  const auto drawAt = [&](double time_h) {
    stage.view->setTime(time_h);
    return stage.view->draw(48, 32, {0.0, -0.2, 1.0}, {0.0, 3.0, 0.0}).rgba;
  };
  const auto once = drawAt(10.0);
  const auto later = drawAt(10.001);
  CHECK(once != later);
  CHECK(drawAt(10.0) == once);
  for (const float v : once) CHECK((std::isfinite(v) && v >= 0.0F));
  CHECK(stage.device.messageCount() == 0);
}

}  // namespace welkin::tests
