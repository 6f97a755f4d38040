// SPDX-License-Identifier: Apache-2.0
// The level's own lights and its glass in the picture, against the formulas of the bake.
#include "level_stage.h"
#include "probes/loader/surfaces_of.h"

namespace welkin::tests {
namespace {

constexpr double kDark_h = 19.0;  // neither sun nor moon
const Number3 kGround(0.5, 0.25, 0.125);
const Camera kDownward{0.0, -f64::kHalfPi, 0.2};
const Number3 kLampEye(0.0, 30.0, 0.0);

/// A square of ground that fills the picture.
GltfText ground() {
  GltfText gltf;
  gltf.addNode(gltf.addMesh(squareMesh(), gltf.addMaterial(listOf(kGround))), {{"scale", {60, 1, 60}}});
  return gltf;
}

void addLight(GltfText& gltf, const nlohmann::json& light, const nlohmann::json& node) {
  nlohmann::json& lights = gltf.json["extensions"]["KHR_lights_punctual"]["lights"];
  lights.push_back(light);
  nlohmann::json placed = node;
  placed["extensions"]["KHR_lights_punctual"]["light"] = lights.size() - 1;
  gltf.json["nodes"].push_back(placed);
  gltf.json["scenes"][0]["nodes"].push_back(gltf.json["nodes"].size() - 1);
}

}  // namespace

TEST_CASE("LevelView, LampsOfEachKindShineByTheirFormulas", "[vulkan]") {
  const double half = std::sqrt(0.5);
  GltfText gltf = ground();
  addLight(gltf, {{"type", "point"}, {"intensity", 40}, {"color", {1, 0.5, 0.25}}}, {{"translation", {1, 2, 0}}});
  addLight(gltf, {{"type", "point"}, {"intensity", 60}, {"range", 3}}, {{"translation", {-2, 1, 0}}});
  addLight(gltf, {{"type", "spot"}, {"intensity", 90}, {"spot", {{"innerConeAngle", 0.2}, {"outerConeAngle", 0.5}}}},
           {{"translation", {0, 3, 1}}, {"rotation", {-half, 0, 0, half}}});
  addLight(gltf, {{"type", "directional"}, {"intensity", 0.75}}, {{"rotation", {-half, 0, 0, half}}});
  Stage stage(sceneOf(gltf));
  REQUIRE(stage.scene.lights.size() == 4);
  stage.view->setTime(kDark_h);
  const Number3 up(0.0, 1.0, 0.0);
  const Number3 ambient = skyIrradiance(stage.sky, stage.view->sample(), up);
  const FloatImage image = stage.view->draw(64, 64, kDownward, kLampEye);
  Worst worst;
  double least = 1e30;
  double most = 0.0;
  forEachPixel(image, kDownward, [&](const Pixel& pixel) {
    const Number3 p = kLampEye + pixel.ray * (kLampEye.y / -pixel.ray.y);
    Number3 irradiance = ambient;
    for (const geometry::StaticLight& light : stage.scene.lights)
      irradiance += geometry::arrivingAt(light, p, up).irradiance;
    least = std::min(least, irradiance.x);
    most = std::max(most, irradiance.x);
    compare(worst, image, pixel, kGround / f64::kPi * irradiance);
  });
  WARN("worst " << worst.error << " at " << worst.where);
  CHECK(most > 3.0 * least);  // their cones and ranges are in sight
  CHECK(worst.error < kSurfaceTolerance);
  CHECK(stage.device.messageCount() == 0);
}

TEST_CASE("LevelView, GlassPassesItsShareOfWhatIsBehind", "[vulkan]") {
  const Number3 pane(0.8, 0.5, 0.25);
  for (const double transmission : {0.0, 0.75})
    for (const double alpha : {0.5, 1.0}) {
      GltfText gltf = ground();
      const int glass = gltf.addMaterial(listOf(pane));
      nlohmann::json& material = gltf.json["materials"][1];
      material["alphaMode"] = "BLEND";
      material["pbrMetallicRoughness"]["baseColorFactor"][3] = alpha;
      material["extensions"]["KHR_materials_transmission"]["transmissionFactor"] = transmission;
      gltf.addNode(gltf.addMesh(squareMesh(), glass), {{"scale", {60, 1, 60}}, {"translation", {0, 5, 0}}});
      Scene scene = sceneOf(gltf);
      loader::useMeanColours(scene);
      Stage stage(std::move(scene));
      const Number3 share = pane * (alpha * transmission) + Number3(1.0 - alpha);
      for (const double time_h : {kDark_h, 12.3}) {
        stage.view->setTime(time_h);
        const WelkinSkySample& sample = stage.view->sample();
        const Number3 up(0.0, 1.0, 0.0);
        Number3 irradiance = skyIrradiance(stage.sky, sample, up);
        if (time_h == 12.3) irradiance += vectorOf(sample.sun.normal_irradiance) * double{sample.sun.direction[1]};
        // A pane that light passes casts no shadow on the ground; an opaque one hides it.
        const Number3 expected =
            (pane * (alpha * (1.0 - transmission)) + share * kGround) * (1.0 / f64::kPi) * irradiance;
        const FloatImage image = stage.view->draw(16, 16, kDownward, kLampEye);
        Worst worst;
        forEachPixel(image, kDownward, [&](const Pixel& pixel) { compare(worst, image, pixel, expected); });
        WARN("transmission " << transmission << ", alpha " << alpha << ": worst " << worst.error << " at "
                             << worst.where);
        CHECK(worst.error < kSurfaceTolerance);
      }
      CHECK(stage.device.messageCount() == 0);
    }
}

}  // namespace welkin::tests
