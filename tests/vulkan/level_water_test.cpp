// SPDX-License-Identifier: Apache-2.0
// The sea of the level picture against the CPU: the mirror image in a calm sea, and the dependence of waves on the
// hour.
#include "level_stage.h"
#include "render/shaders/level_formulas.h"

namespace welkin::tests {

TEST_CASE("LevelView, CalmSeaMirrorsTheSkyAndTheLevel", "[vulkan]") {
  constexpr double kSea = 1.5;
  GltfText gltf;
  gltf.addNode(gltf.addMesh(squareMesh()),
               {{"scale", {100, 1, 100}}, {"translation", {0, kSea, 0}}, {"extras", {{"role", "water"}}}});
  // A box that floats in the air, so that only water is seen through the water.
  const Number3 low(-2.0, kSea + 0.5, -12.0);
  const Number3 high(2.0, kSea + 3.5, -10.0);
  const Number3 albedo(0.8, 0.1, 0.4);
  gltf.addNode(gltf.addMesh(boxMesh(), gltf.addMaterial(listOf(albedo))),
               {{"scale", {2, 1.5, 1}}, {"translation", {0, kSea + 2.0, -11}}});
  for (const uint8_t mode_count : {0, 7}) {
    Stage stage(sceneOf(gltf), kPlain, {.mode_count = mode_count});
    stage.view->setTime(15.5);
    const WelkinSkySample& sample = stage.view->sample();
    const Number3 sun = vectorOf(sample.sun.direction);
    REQUIRE(sun.x < -0.3);  // In the west: no glitter to the north, and no shadow of the box there.
    const Camera camera{0.0, -0.25, 1.0};
    const Number3 position(0.0, kSea + 4.0, 3.0);
    const FloatImage image = stage.view->draw(160, 120, camera, position);
    const Number3 irradiance =
        skyIrradiance(stage.sky, sample, {0.0, 1.0, 0.0}) + vectorOf(sample.sun.normal_irradiance) * sun.y;
    const Number3 body = shaders::kWaterAlbedo / f64::kPi * irradiance;
    // The sun's irradiance on the box's south face.
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
      const double fresnel = shaders::schlick(shaders::kWaterReflectance, -p.ray.y);
      if (meets(at, sun, low - Number3(0.3), high + Number3(0.3))) return;  // near its shadow
      const bool near = meets(at, mirrored, low - Number3(0.3), high + Number3(0.3));
      // The ray meets the middle of the box's south face, because the reflection has half the picture's resolution.
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
  // With a level view the sea's pixel mirrors the sky's pixel above it. The difference between the formulas and the
  // cubemaps of noise then changes the sea's pixel by the mirrored share.
  GltfText gltf;
  gltf.addNode(gltf.addMesh(squareMesh()), {{"scale", {100, 1, 100}}, {"extras", {{"role", "water"}}}});
  const Camera camera{0.3, 0.0, 1.0};
  const auto drawn = [&](bool cubemaps) {
    render::LevelOptions options = kPlain;
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
    const double fresnel = shaders::schlick(shaders::kWaterReflectance, -p.ray.y);
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
  CHECK(largest > 0.1);  // The two pictures differ.
  CHECK(worst.error < kSurfaceTolerance);
}

TEST_CASE("LevelView, WavesDependOnTheHourAlone", "[vulkan]") {
  GltfText gltf;
  gltf.addNode(gltf.addMesh(squareMesh()), {{"scale", {100, 1, 100}}, {"extras", {{"role", "water"}}}});
  render::LevelOptions options = kPlain;
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
