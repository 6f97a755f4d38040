// SPDX-License-Identifier: Apache-2.0
// The level's own lights and its glass in the picture, against the formulas of the bake.
#include "level_stage.h"
#include "probes/geometry/tracer.h"
#include "probes/loader/surfaces_of.h"
#include "sky/image/image.h"

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

/// A room without a roof: a wall, a glowing slab above the ground and 40 small triangles in the air, no part like
/// another.
GltfText room() {
  GltfText gltf = ground();
  gltf.addNode(gltf.addMesh({{0, 0, -1.5, 0, 1.5, -1.5, 0, 1.5, 2, 0, 0, 2}, {0, 1, 2, 0, 2, 3}},
                            gltf.addMaterial({0.25, 0.5, 0.75}, true)),
               {{"translation", {0.7, 0, 0}}, {"rotation", {0, std::sin(0.15), 0, std::cos(0.15)}}});
  const int glowing = gltf.addMaterial({0.75, 0.25, 0.5}, true);
  gltf.json["materials"][static_cast<std::size_t>(glowing)]["emissiveFactor"] = {0.5, 1.0, 0.25};
  gltf.json["materials"][static_cast<std::size_t>(glowing)]["extensions"]["KHR_materials_emissive_strength"] = {
      {"emissiveStrength", 3.0}};
  gltf.addNode(gltf.addMesh(squareMesh(), glowing), {{"translation", {-1.2, 1, -0.6}}, {"scale", {0.5, 1, 0.7}}});
  MeshText pieces;
  std::uint32_t state = 7;
  const auto next = [&] { return static_cast<float>((state = state * 1664525U + 1013904223U) >> 8U) * 0x1p-24F; };
  for (std::uint16_t i = 0; i < 40; ++i) {
    const float middle[3] = {5.0F * next() - 2.5F, 0.2F + 0.8F * next(), 5.0F * next() - 2.5F};
    for (std::uint16_t corner = 0; corner < 3; ++corner) {
      for (const float at : middle) pieces.positions.push_back(at + 0.5F * next() - 0.25F);
      pieces.indices.push_back(static_cast<std::uint16_t>(3 * i + corner));
    }
  }
  gltf.addNode(gltf.addMesh(pieces, gltf.addMaterial({0.5, 0.5, 0.25}, true)));
  return gltf;
}

/// A ray's first surface, and which lamps it is lit by. Rays a little apart that differ straddle an edge.
struct Seen {
  std::uint32_t triangle = 0;
  std::vector<bool> lit;
  Number3 irradiance{0.0};  ///< by lamps
  geometry::Hit hit;

  bool isAs(const Seen& other) const { return triangle == other.triangle && lit == other.lit; }
};

Seen seenBy(const geometry::Tracer& tracer, const Number3& ray) {
  Seen seen;
  const auto hit = tracer.closest(kLampEye, ray, 1e9);
  REQUIRE(hit);
  seen.hit = *hit;
  seen.triangle = hit->triangle;
  const Number3 from = tracer.leaving(*hit);
  for (const geometry::StaticLight& light : tracer.surfaces().light) {
    const geometry::LightArriving arriving = geometry::arrivingAt(light, from, hit->normal);
    const bool lit =
        arriving.irradiance != Number3(0.0) && !tracer.occluded(from, arriving.direction, arriving.distance);
    seen.lit.push_back(lit);
    if (lit) seen.irradiance += arriving.irradiance;
  }
  return seen;
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

// Every pixel is as the bake's rays find it, but for those at edges.
TEST_CASE("LevelView, WallsStopTheLightOfLampsAndSurfacesGlow", "[vulkan]") {
  GltfText gltf = room();
  addLight(gltf, {{"type", "point"}, {"intensity", 40}, {"color", {1, 0.5, 0.25}}}, {{"translation", {1.7, 1, 0.4}}});
  addLight(gltf, {{"type", "spot"}, {"intensity", 90}, {"spot", {{"innerConeAngle", 0.3}, {"outerConeAngle", 0.7}}}},
           {{"translation", {-1.0, 3, -0.2}}, {"rotation", {-std::sqrt(0.5), 0, 0, std::sqrt(0.5)}}});
  addLight(gltf, {{"type", "directional"}, {"intensity", 2}, {"color", {0.25, 0.5, 1}}},
           {{"rotation", {-std::sin(0.5), 0, 0, std::cos(0.5)}}});
  Stage stage(sceneOf(gltf));
  const geometry::Surfaces surfaces = loader::surfacesOf(stage.scene, double{stage.sky.info().luminance_unit});
  const geometry::Tracer tracer(surfaces);
  stage.view->setTime(kDark_h);
  const WelkinSkySample& sample = stage.view->sample();
  const FloatImage image = stage.view->draw(96, 96, kDownward, kLampEye);
  Worst worst;
  int pixels = 0;
  int edges = 0;
  int glowing = 0;
  std::vector<int> dark(3);
  forEachPixel(image, kDownward, [&](const Pixel& pixel) {
    const Seen seen = seenBy(tracer, pixel.ray);
    constexpr double kApart = 1e-4;  // radians: 3 mm on the ground
    const auto near = [&](double x, double z) {
      const Number3 ray = pixel.ray + Number3(kApart * x, 0.0, kApart * z);
      return seenBy(tracer, ray / std::sqrt(dot(ray, ray)));
    };
    ++pixels;
    if (!seen.isAs(near(1, 0)) || !seen.isAs(near(-1, 0)) || !seen.isAs(near(0, 1)) || !seen.isAs(near(0, -1))) {
      ++edges;
      return;
    }
    for (std::size_t i = 0; i < 3; ++i) dark[i] += seen.lit[i] ? 0 : 1;
    const Number3 emission = tracer.emission(seen.hit);
    if (emission != Number3(0.0)) ++glowing;
    const Number3 irradiance = skyIrradiance(stage.sky, sample, seen.hit.normal) + seen.irradiance;
    compare(worst, image, pixel, tracer.albedo(seen.hit) / f64::kPi * irradiance + emission);
  });
  WARN("worst " << worst.error << " at " << worst.where << "; of " << pixels << " pixels " << edges << " at edges, "
                << glowing << " glow, dark of each lamp: " << dark[0] << ", " << dark[1] << ", " << dark[2]);
  CHECK(worst.error < kSurfaceTolerance);
  CHECK(edges < pixels / 8);
  CHECK(glowing > pixels / 100);
  for (const int of_lamp : dark) {
    CHECK(of_lamp > pixels / 20);
    CHECK(of_lamp < pixels - pixels / 20);
  }
  // The lamp stands 1 m behind the wall: the ground before it is dark.
  const Number3 before = Number3(-0.5, 0.0, 0.4) - kLampEye;
  const Seen wall = seenBy(tracer, before / std::sqrt(dot(before, before)));
  CHECK_FALSE(wall.lit[0]);
  CHECK(stage.device.messageCount() == 0);
}

TEST_CASE("LevelView, SurfacesEmitTheMeanOfTheirTexture", "[vulkan]") {
  const std::uint8_t texels[6] = {255, 0, 0, 0, 0, 255};
  const std::vector<std::byte> png = image::encodePng(2, 1, std::span<const std::uint8_t>(texels));
  std::vector<unsigned char> bytes;
  for (const std::byte b : png) bytes.push_back(std::to_integer<unsigned char>(b));
  for (const double alpha : {1.0, 0.5}) {
    GltfText gltf;
    gltf.addNode(gltf.addMesh(texturedSquareMesh(), gltf.addMaterial(listOf(kGround))), {{"scale", {60, 1, 60}}});
    gltf.json["images"].push_back({{"uri", "data:image/png;base64," + base64(bytes)}});
    gltf.json["textures"].push_back({{"source", 0}});
    nlohmann::json& material = gltf.json["materials"][0];
    material["emissiveFactor"] = {1.0, 1.0, 0.5};
    material["emissiveTexture"] = {{"index", 0}};
    material["alphaMode"] = "BLEND";
    material["pbrMetallicRoughness"]["baseColorFactor"][3] = alpha;
    gltf.addNode(gltf.addMesh(squareMesh(), gltf.addMaterial(listOf(kGround))),
                 {{"scale", {60, 1, 60}}, {"translation", {0, -1, 0}}});
    Scene scene = sceneOf(gltf);
    loader::useMeanColours(scene);
    Stage stage(std::move(scene));
    stage.view->setTime(kDark_h);
    const Number3 irradiance = skyIrradiance(stage.sky, stage.view->sample(), {0.0, 1.0, 0.0});
    const Number3 emission = Number3(0.5, 0.0, 0.25) * (alpha / double{stage.sky.info().luminance_unit});
    const FloatImage image = stage.view->draw(16, 16, kDownward, kLampEye);
    Worst worst;
    forEachPixel(image, kDownward,
                 [&](const Pixel& p) { compare(worst, image, p, kGround / f64::kPi * irradiance + emission); });
    WARN("alpha " << alpha << ": worst " << worst.error << " at " << worst.where);
    CHECK(worst.error < kSurfaceTolerance);
    CHECK(stage.device.messageCount() == 0);
  }
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
