// SPDX-License-Identifier: Apache-2.0
// Filament's own library, without a GPU, lit by the code of docs/engines.md.
#include <filament/Engine.h>
#include <filament/IndirectLight.h>
#include <filament/LightManager.h>
#include <filament/Scene.h>
#include <math/vec3.h>
#include <math/vec4.h>
#include <utils/EntityManager.h>

#include <catch2/catch.hpp>

#include "tests/engines/engine_light.h"

namespace welkin::tests {
namespace {

#include "filament_light.inc"

/// An engine that draws nothing, with a scene and a sun.
struct Stage {
  filament::Engine* engine = filament::Engine::create(filament::Engine::Backend::NOOP);
  filament::Scene* scene = engine->createScene();
  utils::Entity sun = utils::EntityManager::get().create();
  filament::IndirectLight* light = nullptr;

  Stage() { filament::LightManager::Builder(filament::LightManager::Type::DIRECTIONAL).build(*engine, sun); }
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;
  ~Stage() {
    if (light != nullptr) engine->destroy(light);
    engine->destroy(sun);
    engine->destroy(scene);
    filament::Engine::destroy(&engine);
  }
};

/// Irradiance over pi that Filament keeps for a normal. getColorEstimate evaluates the coefficients as the shaders do,
/// for light that goes in a direction, and multiplies by pi. The member is deprecated, the static one wants
/// coefficients.
Vector filamentIrradiance(const filament::IndirectLight& light, const Vector& n) {
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wdeprecated-declarations"
  const filament::math::float4 c = light.getColorEstimate({-n[0], -n[1], -n[2]});
#pragma GCC diagnostic pop
  const double scale = double{c.w} / M_PI;
  if (!(c.w > 0.0F)) return {};
  return {static_cast<float>(double{c.x} * scale), static_cast<float>(double{c.y} * scale),
          static_cast<float>(double{c.z} * scale)};
}

TEST_CASE("Filament, CodeOfTheDocsLightsTheScene") {
  Stage stage;
  for (const EngineLight& light : engineLights()) {
    stage.light = lightScene(*stage.engine, *stage.scene, stage.sun, light.sample, stage.light);
    CHECK(stage.light->getIntensity() == 1.0F);
    const double error = largestError(light.sample, [&](const WelkinSkySample&, const Vector& normal) {
      return filamentIrradiance(*stage.light, normal);
    });
    INFO(light.name);
    CHECK(error < kRounding);
    printError("Filament's irradiance()", light, error);

    const auto& lights = stage.engine->getLightManager();
    const auto sun = lights.getInstance(stage.sun);
    const WelkinLight& key = light.sample.sun;
    for (std::size_t c = 0; c < 3; ++c) {
      CHECK(lights.getColor(sun)[c] * lights.getIntensity(sun) == Approx(key.normal_irradiance[c]).epsilon(1e-6));
      CHECK(lights.getDirection(sun)[c] == Approx(-key.direction[c]).margin(1e-6));
    }
  }
}

TEST_CASE("Filament, RadianceNegatesOddM") {
  Stage stage;
  for (const EngineLight& light : engineLights()) {
    WelkinFilamentRadiance packed{};
    REQUIRE(welkin_pack_filament_radiance(&light.sample, &packed) == WELKIN_OK);
    const auto error = [&](const float(*coefficients)[3]) {
      filament::math::float3 sh[9];
      for (int i = 0; i < 9; ++i) sh[i] = {coefficients[i][0], coefficients[i][1], coefficients[i][2]};
      if (stage.light != nullptr) stage.engine->destroy(stage.light);
      stage.light = filament::IndirectLight::Builder().radiance(3, sh).intensity(1.0F).build(*stage.engine);
      return largestError(light.sample, [&](const WelkinSkySample&, const Vector& normal) {
        return filamentIrradiance(*stage.light, normal);
      });
    };
    INFO(light.name);
    const double right = error(packed.sh), as_they_are = error(light.sample.ambient_sh);
    CHECK(right < kRounding);
    CHECK(as_they_are > 0.1);
    printError("Filament's radiance()", light, right);
    printError("ambient_sh in Filament's radiance()", light, as_they_are);
  }
}

}  // namespace
}  // namespace welkin::tests
