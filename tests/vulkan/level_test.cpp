// SPDX-License-Identifier: Apache-2.0
// The level picture against the CPU. The test's own ray finds every pixel's surface. Its radiance is albedo / pi
// (irradiance of the sky + irradiance of the light where its ray is free).
#include <optional>

#include "level_stage.h"
#include "render/shaders/level_formulas.h"

namespace welkin::tests {
namespace {

const Number3 kGroundAlbedo{0.3, 0.5, 0.2};
constexpr double kBoxHeight = 4.0;

/// Ground at y = 0, 40 m wide, with a box of 2 x 4 x 3 m in its middle.
Scene groundAndBox() {
  GltfText gltf;
  gltf.addNode(gltf.addMesh(squareMesh(), gltf.addMaterial(listOf(kGroundAlbedo))), {{"scale", {20, 1, 20}}});
  gltf.addNode(gltf.addMesh(boxMesh(), gltf.addMaterial({0.8, 0.1, 0.1})),
               {{"scale", {1, kBoxHeight / 2, 1.5}}, {"translation", {0, kBoxHeight / 2, 0}}});
  return sceneOf(gltf);
}

const Camera kDown{0.4, -f64::kHalfPi, 0.9};
const Number3 kAbove{1.0, 30.0, -2.0};

/// Finds where a ray from above meets the ground. Returns false within `margin` metres of the ground's edge or over the
/// box.
bool groundAt(const Number3& ray, double margin, Number3& p) {
  p = kAbove + ray * (kAbove.y / -ray.y);
  const Number3 m(margin);
  if (meets(kAbove, ray, Number3(-1.0, 0.0, -1.5) - m, Number3(1.0, kBoxHeight, 1.5) + m)) return false;
  return std::abs(p.x) < 20.0 - margin && std::abs(p.z) < 20.0 - margin;
}

/// Whether the light's ray from `p` meets the box. Nothing within `margin` metres of the shadow's edge.
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
  // The map spans about 57 m in 2048 texels of 28 mm. The filter reaches two texels, and the offset along the normal as
  // far.
  constexpr double kShadowEdge_m = 0.2;
  struct Light {
    const char* name;
    bool flat;
    uint8_t mode_count;
  };
  for (const auto& [name, flat, mode_count] :
       {Light{"sh", false, 0}, Light{"flat", true, 0}, Light{"modes", false, 7}}) {
    render::LevelOptions options = kPlain;
    options.flat_light = flat;
    Stage stage(groundAndBox(), options, {.mode_count = mode_count});
    for (const double time_h : {8.5, 12.3, 15.0, 19.0, 2.0}) {
      stage.view->setTime(time_h);
      const WelkinSkySample& sample = stage.view->sample();
      const WelkinLight* light = render::lightOf(sample);
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
  // A square turned about x and z and stretched. Its mirrored twin must not be culled.
  for (const double mirror : {1.0, -1.0}) {
    GltfText gltf;
    const double s = std::sin(0.3);
    const double c = std::cos(0.3);
    gltf.addNode(gltf.addMesh(squareMesh(), gltf.addMaterial({0.5, 0.5, 0.5})),
                 {{"rotation", {s, 0, 0, c}}, {"scale", {30 * mirror, 1, 9}}});
    // The scale of a child is in its parent's axes, so the normal needs the cofactor matrix.
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
  render::Views views(stage.device, stage.sky, WELKIN_VULKAN_ANALYTIC);
  views.setTime(9.0);
  CHECK(image.rgba == views.perspective(96, 64, camera, true).rgba);
  CHECK(stage.device.messageCount() == 0);
}

TEST_CASE("LevelView, TintCanBeLeftOut", "[vulkan]") {
  const Camera camera{2.0, 0.6, 0.8};
  render::LevelOptions options = kPlain;
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
  render::LevelOptions options = kPlain;
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
    compare(worst, image, p, mix(horizon, ground, shaders::transmittance(0.02, distance_m)));
  });
  WARN("worst " << worst.error << " at " << worst.where << " of " << worst.count);
  CHECK(worst.count > 3000);
  CHECK(worst.error < kSurfaceTolerance + shaderTolerance(stage.device));
  CHECK(stage.device.messageCount() == 0);
}

}  // namespace welkin::tests
