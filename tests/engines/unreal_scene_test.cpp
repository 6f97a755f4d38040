// SPDX-License-Identifier: Apache-2.0
// The C++ of docs/engines.md for Unreal, compiled against stand-ins of its types and run: vectors, direction and colour
// that it hands to the engine.
#include <welkin/welkin.h>

#include <catch2/catch.hpp>

#include "tests/engines/engine_light.h"
#include "tests/engines/unreal_types.h"

namespace welkin::tests {
namespace {

namespace unreal_code {
using namespace unreal_stub;
#include "unreal_scene.inc"
}  // namespace unreal_code

/// A light's colour has 8 bits in sRGB: half a step, where the curve is steepest.
constexpr double kEightBits = 0.5 / 255.0 * 2.3;

TEST_CASE("Unreal, SceneCodeOfTheDocsLightsTheScene") {
  for (const EngineLight& light : engineLights()) {
    INFO(light.name);
    unreal_stub::UWorld world;
    unreal_stub::UMaterialParameterCollection sky;
    unreal_stub::UDirectionalLightComponent sun;
    unreal_code::LightScene(&world, &sky, &sun, light.sample);
    WelkinUnrealIrradianceOverPi packed{};
    REQUIRE(welkin_pack_unreal(&light.sample, &packed) == WELKIN_OK);
    REQUIRE(sky.vectors.size() == 7);
    for (std::size_t i = 0; i < 7; ++i) {
      const unreal_stub::FLinearColor& v = sky.vectors.at("V" + std::to_string(i));
      const float expected[4] = {packed.vectors[i][0], packed.vectors[i][1], packed.vectors[i][2],
                                 packed.vectors[i][3]};
      CHECK(v.R == expected[0]);
      CHECK(v.G == expected[1]);
      CHECK(v.B == expected[2]);
      CHECK(v.A == expected[3]);
    }
    // The light shines along its forward vector: from the sun.
    WelkinLight key{};
    REQUIRE(welkin_sample_key_light(&light.sample, &key) == WELKIN_OK);
    const double pitch = sun.rotation.Pitch * M_PI / 180.0, yaw = sun.rotation.Yaw * M_PI / 180.0;
    const double forward[3] = {std::cos(pitch) * std::cos(yaw), std::cos(pitch) * std::sin(yaw), std::sin(pitch)};
    const Vector towards = inAxes(WELKIN_AXES_UNREAL, {key.direction[0], key.direction[1], key.direction[2]});
    const float* e = key.normal_irradiance;
    const double largest = double{std::max({e[0], e[1], e[2]})};
    REQUIRE(largest > 1.0);
    for (std::size_t c = 0; c < 3; ++c) {
      CHECK(forward[c] == Approx(-double{towards[c]}).margin(1e-6));
      CHECK(double{sun.colour[c]} * double{sun.intensity} == Approx(double{e[c]}).margin(kEightBits * largest));
    }
  }
}

}  // namespace
}  // namespace welkin::tests
