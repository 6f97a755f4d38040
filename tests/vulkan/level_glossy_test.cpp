// SPDX-License-Identifier: Apache-2.0
// Materials of glTF in the level picture against the integral of the sky over the lobe, a furnace, and a closed room.
#include <algorithm>
#include <optional>

#include "level_stage.h"
#include "materials.h"
#include "sky/reflection/lobe_reference.h"
#include "tests/probes/rooms.h"
#include "tests/sky/baked.h"
#include "tests/sky/some_skies.h"
#include "wall_level.h"

namespace welkin::tests {
namespace {

constexpr uint32_t kGlossyWidth = 24, kGlossyHeight = 18;
const Camera kAslant{0.7, -0.5, 0.8};
const Number3 kGlossyEye(-5.0, 6.0, 9.0);

render::LevelOptions glossyOptions() {
  render::LevelOptions options = kPlain;
  options.glossy = true;
  return options;
}

struct Metal {
  std::vector<double> base;
  double metallic, roughness;
};

/// Ground at y = 0, 40 m wide, with a box of 2 x 4 x 3 m in its middle.
Scene glossyScene(const Metal& metal) {
  GltfText gltf;
  const int material = gltf.addMaterial(metal.base);
  auto& pbr = gltf.json["materials"][0]["pbrMetallicRoughness"];
  pbr["metallicFactor"] = metal.metallic;
  pbr["roughnessFactor"] = metal.roughness;
  gltf.addNode(gltf.addMesh(squareMesh(), material), {{"scale", {20, 1, 20}}});
  gltf.addNode(gltf.addMesh(boxMesh(), material), {{"scale", {1, 2, 1.5}}, {"translation", {0, 2, 0}}});
  return sceneOf(gltf);
}

/// A model's sky and a scene under it.
struct GlossyStage {
  GlossyStage(const model::Sky& model, Scene made, const render::LevelOptions& options)
      : baked(model, 5, 48), scene(std::move(made)), view(device, baked.sky, scene, options) {}

  Baked baked;
  render::VulkanDevice device{true};
  Scene scene;
  render::LevelView view;
};

/// Radiance 1 in every direction, with the ground.
model::Sky evenSky() {
  model::Sky sky = someSkies().front().sky;
  sky.luminance = {0.0, -1.0, 0.0, -1.0, 0.0, 0.0};
  sky.intensity = base::Curve::constant(1.0);
  sky.polarising_tint = base::Curve::constant(det::Number3(1.0));
  sky.gradient_sun = sky.gradient_anti = {1, 1, {1.0F, 1.0F, 1.0F}};
  sky.ground_albedo = det::Number3(1.0);
  sky.sun.illuminance = base::Curve::constant(0.0);
  return sky;
}

}  // namespace

TEST_CASE("LevelGlossy, AWhiteFurnaceStaysEven", "[vulkan]") {
  for (const double roughness : {0.0, 0.3, 0.6, 1.0})
    for (const double metallic : {0.0, 1.0}) {
      GlossyStage stage(evenSky(), glossyScene({{1, 1, 1}, metallic, roughness}), glossyOptions());
      stage.view.setTime(12.0);
      const FloatImage image = stage.view.draw(kGlossyWidth, kGlossyHeight, kAslant, kGlossyEye);
      float least = 2.0F, most = 0.0F;
      for (uint32_t y = 0; y < kGlossyHeight; ++y)
        for (uint32_t x = 0; x < kGlossyWidth; ++x) {
          least = std::min(least, image.pixel(x, y)[1]);
          most = std::max(most, image.pixel(x, y)[1]);
        }
      CAPTURE(roughness, metallic, least, most);
      CHECK(double{most} < 1.0 + kSurfaceTolerance);
      if (metallic == 0.0) CHECK(double{least} > 1.0 - kSurfaceTolerance);
      if (metallic == 1.0 && roughness == 1.0) CHECK(least < 0.6F);  // one bounce between facets alone
      CHECK(stage.device.messageCount() == 0);
    }
}

TEST_CASE("LevelGlossy, GroundReflectsTheSkyAndTheSun", "[vulkan]") {
  // Of a reflection the chain's error between texels and mips, which docs/materials.md states: of the shown sky's
  // directions it is below 3 %.
  constexpr double kChain = 0.03;
  model::Sky sky = someSkies().front().sky;
  sky.ground_albedo = {0.3, 0.2, 0.1};
  sky.sun.illuminance = base::Curve::constant(4.0);
  sky.sun.colour = base::Curve::constant(det::Number3(1.0, 0.8, 0.5));
  for (const Metal& metal : {Metal{{0.9, 0.6, 0.3}, 0.0, 0.45}, Metal{{0.9, 0.6, 0.3}, 0.75, 0.3},
                             Metal{{0.9, 0.6, 0.3}, 1.0, 0.8}, Metal{{0.2, 0.4, 0.6}, 0.0, 0.1}}) {
    GlossyStage stage(sky, glossyScene(metal), glossyOptions());
    stage.view.setTime(9.5);
    const WelkinSkySample& sample = stage.view.sample();
    const Number3 light = vectorOf(sample.sun.direction), direct = vectorOf(sample.sun.normal_irradiance);
    REQUIRE(light.y > 0.2);
    const FloatImage image = stage.view.draw(kGlossyWidth, kGlossyHeight, kAslant, kGlossyEye);
    const reflection::Radiance dome = [&](const det::Number3& d) {
      return det::Number3(domeRadiance(stage.baked.sky, sample, Number3(d)));
    };
    const Number3 base(metal.base[0], metal.base[1], metal.base[2]), n(0.0, 1.0, 0.0);
    const double power = f64::powerOfRoughness(metal.roughness);
    const Number3 c = f64::specularColourOf(base, metal.metallic), of = f64::diffuseColourOf(base, metal.metallic);
    Worst worst;
    std::size_t shadowed = 0;
    forEachPixel(image, kAslant, [&](const Pixel& pixel) {
      if (pixel.ray.y > -0.1) return;
      const Number3 p = kGlossyEye + pixel.ray * (kGlossyEye.y / -pixel.ray.y), m(0.3);
      const Number3 low(-1.0, 0.0, -1.5), high(1.0, 4.0, 1.5);
      if (meets(kGlossyEye, pixel.ray, low - m, high + m) || std::max(std::abs(p.x), std::abs(p.z)) > 19.0) return;
      const bool in_shadow = meets(p, light, low, high);
      if (meets(p, light, low - m, high + m) != meets(p, light, low + m, high - m)) return;
      shadowed += in_shadow ? 1 : 0;
      const Number3 v = -pixel.ray, sun = in_shadow ? Number3(0.0) : direct * light.y;
      const Number3 share = f64::reflectedShare(c, power, v.y);
      const Number3 mirrored(pixel.ray.x, -pixel.ray.y, pixel.ray.z);
      const Number3 reflected = Number3(reflection::lobeReference(dome, power, det::Number3(mirrored), {8, 8})) * share;
      const Number3 diffuse =
          of * (Number3(1.0) - share) / f64::kPi * (skyIrradiance(stage.baked.sky, sample, n) + sun);
      const Number3 expected = diffuse + reflected + f64::schlickSmithSpecular(c, power, n, light, v) * sun;
      for (int i = 0; i < 3; ++i)
        worst.compare(double{image.pixel(pixel.x, pixel.y)[i]}, expected[i], reflected[i] * kChain + expected[i] * 3e-3,
                      [&] { return "pixel " + std::to_string(pixel.x) + "," + std::to_string(pixel.y); });
    });
    WARN("metallic " << metal.metallic << ", roughness " << metal.roughness << ": worst " << worst.error
                     << " of the tolerance at " << worst.where);
    CHECK(worst.count > 300);
    CHECK(shadowed > 5);
    CHECK(worst.error < 1.0);
    CHECK(stage.device.messageCount() == 0);
  }
}

TEST_CASE("LevelGlossy, AClosedRoomReflectsNothingOfABrightSky", "[vulkan]") {
  const Number3 low(18, 0, 22), high(33, 5, 41);
  geometry::Surfaces s;
  const std::uint32_t plain = addMaterial(s, Number3(0.3));
  const Number3 from = low - Number3(0.1), to = high + Number3(0.1);
  addQuad(s, {-40, 0, -40}, {0, 0, 160}, {from.x + 40, 0, 0}, plain);  // around the room, not under it
  addQuad(s, {to.x, 0, -40}, {0, 0, 160}, {120 - to.x, 0, 0}, plain);
  addQuad(s, {from.x, 0, -40}, {0, 0, from.z + 40}, {to.x - from.x, 0, 0}, plain);
  addQuad(s, {from.x, 0, to.z}, {0, 0, 120 - to.z}, {to.x - from.x, 0, 0}, plain);
  addBoxOutside(s, from, to, plain);
  addBoxInside(s, low, high, addMaterial(s, Number3(0.5)));
  const RandomLevel baked = bakedLevel(s, {{0, 0}}, 1);
  const OpenedLevel opened(baked);
  Sky sky;
  REQUIRE(sky.open(baked.sky.data(), baked.sky.size()));
  GltfText gltf;
  const int metal = gltf.addMaterial({0.9, 0.9, 0.9}, true);
  gltf.json["materials"][0]["pbrMetallicRoughness"]["roughnessFactor"] = 0.3;
  const Number3 size = (high - low) * 0.5, middle = (high + low) * 0.5;
  gltf.addNode(gltf.addMesh(boxMesh(), metal), {{"scale", listOf(size)}, {"translation", listOf(middle)}});
  const Scene scene = sceneOf(gltf);
  render::VulkanDevice device(true);
  render::LevelOptions options = glossyOptions();
  options.direct = false;
  {
    render::LevelView view(device, sky, scene, options, opened.level);
    view.setTime(12.0);
    const FloatImage inside = view.draw(32, 24, {0.3, 0.1, 1.0}, middle);
    for (uint32_t y = 0; y < 24; ++y)
      for (uint32_t x = 0; x < 32; ++x)
        for (int c = 0; c < 3; ++c) REQUIRE(inside.pixel(x, y)[c] == 0.0F);
    // The same wall from outside, where it is open.
    const FloatImage outside = view.draw(32, 24, {0.0, 0.0, 0.1}, {25.0, 2.5, 60.0});
    CHECK(outside.pixel(16, 12)[1] > 0.01F);
  }
  CHECK(device.messageCount() == 0);
}

}  // namespace welkin::tests
