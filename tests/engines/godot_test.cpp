// SPDX-License-Identifier: Apache-2.0
// Godot's light against this library's: the shader lines of docs/engines.md, and Godot's own formula for the probes of
// a lightmap, written anew.
#include <catch2/catch.hpp>

#include "tests/engines/engine_light.h"
#include "tests/engines/shader_types.h"

namespace welkin::tests {
namespace {

namespace godot {
using namespace shader;

vec4 welkin_0, welkin_1, welkin_2, welkin_3, welkin_4, welkin_5, welkin_6;
#include "godot_irradiance.inc"
}  // namespace godot

TEST_CASE("Godot, ShaderOfTheDocsGivesTheIrradiance") {
  for (const EngineLight& light : engineLights()) {
    WelkinGodotIrradianceOverPi packed{};
    REQUIRE(welkin_pack_godot(&light.sample, &packed) == WELKIN_OK);
    godot::vec4* const globals[7] = {&godot::welkin_0, &godot::welkin_1, &godot::welkin_2, &godot::welkin_3,
                                     &godot::welkin_4, &godot::welkin_5, &godot::welkin_6};
    for (int i = 0; i < 7; ++i) *globals[i] = godot::vec4(packed.vectors[i]);
    const double error = largestError(light.sample, [&](const WelkinSkySample&, const Vector& n) {
      const godot::vec3 e = godot::welkin_irradiance_over_pi({n[0], n[1], n[2]});
      return Vector{e.x, e.y, e.z};
    });
    INFO(light.name);
    CHECK(error < kRounding);
    printError("Godot's shader", light, error);
  }
}

/// A lightmap's probe lights an object by its coefficients times A_l and the basis' constants. Godot multiplies the
/// result by the albedo, so it has to be irradiance over pi. Godot's constants have six digits.
TEST_CASE("Godot, LightmapProbesGiveTheIrradiance") {
  for (const EngineLight& light : engineLights()) {
    WelkinGodotIrradianceOverPi packed{};
    REQUIRE(welkin_pack_godot(&light.sample, &packed) == WELKIN_OK);
    const double error = largestError(light.sample, [&](const WelkinSkySample&, const Vector& n) {
      const double x = double{n[0]}, y = double{n[1]}, z = double{n[2]};
      const double term[9] = {0.886227,
                              1.023327 * y,
                              1.023327 * z,
                              1.023327 * x,
                              0.858086 * x * y,
                              0.858086 * y * z,
                              0.247708 * (3.0 * z * z - 1.0),
                              0.858086 * x * z,
                              0.429043 * (x * x - y * y)};
      Vector e{};
      for (std::size_t c = 0; c < 3; ++c) {
        double sum = 0.0;
        for (std::size_t i = 0; i < 9; ++i) sum += term[i] * double{packed.probe[i][c]};
        e[c] = static_cast<float>(sum);
      }
      return e;
    });
    INFO(light.name);
    CHECK(error < 1e-5);
    printError("Godot's lightmap probe", light, error);
    for (const auto& colour : packed.probe) CHECK(colour[3] == 1.0F);
  }
}

}  // namespace
}  // namespace welkin::tests
