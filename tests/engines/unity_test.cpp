// SPDX-License-Identifier: Apache-2.0
// Unity's light against this library's, by the formula of Unity's built-in shaders (ShadeSH9 of UnityCG.cginc) and of
// SphericalHarmonicsL2, written anew.
#include <catch2/catch.hpp>

#include "tests/engines/engine_light.h"

namespace welkin::tests {
namespace {

/// Irradiance over pi of a normal in Unity's world, from the seven constants.
Vector unityShader(const WelkinUnityIrradianceOverPi& u, const Vector& n) {
  const float x = n[0], y = n[1], z = n[2];
  const float* const first[3] = {u.shar, u.shag, u.shab};
  const float* const second[3] = {u.shbr, u.shbg, u.shbb};
  Vector e{};
  for (std::size_t c = 0; c < 3; ++c)
    e[c] = first[c][0] * x + first[c][1] * y + first[c][2] * z + first[c][3] + second[c][0] * x * y +
           second[c][1] * y * z + second[c][2] * z * z + second[c][3] * z * x + u.shc[c] * (x * x - y * y);
  return e;
}

constexpr WelkinAxes kUnityWorlds[] = {WELKIN_AXES_UNITY, WELKIN_AXES_UNITY_IMPORT};

TEST_CASE("Unity, BuiltInShadersGiveTheIrradiance") {
  for (const EngineLight& light : engineLights()) {
    for (const WelkinAxes axes : kUnityWorlds) {
      const double error = largestError(light.sample, [&](const WelkinSkySample& sample, const Vector& normal) {
        WelkinUnityIrradianceOverPi packed{};
        REQUIRE(welkin_pack_unity_axes(&sample, axes, &packed) == WELKIN_OK);
        return unityShader(packed, inAxes(axes, normal));
      });
      INFO(light.name << ", axes " << axes);
      CHECK(error < kRounding);
      printError("Unity's shader", light, error);
    }
  }
}

TEST_CASE("Unity, TheRightHandedConstantsAreWrongInItsWorld") {
  for (const WelkinAxes axes : kUnityWorlds) {
    const double error =
        largestError(engineLights()[0].sample, [&](const WelkinSkySample& sample, const Vector& normal) {
          WelkinUnityIrradianceOverPi packed{};
          REQUIRE(welkin_pack_unity(&sample, &packed) == WELKIN_OK);
          return unityShader(packed, inAxes(axes, normal));
        });
    CHECK(error > 0.1);
  }
}

/// Unity makes a shader's constants of an ambient probe so: sh[channel][coefficient], irradiance over pi.
TEST_CASE("Unity, AmbientProbeBecomesTheShadersConstants") {
  for (const EngineLight& light : engineLights()) {
    for (const WelkinAxes axes : kUnityWorlds) {
      const double error = largestError(light.sample, [&](const WelkinSkySample& sample, const Vector& normal) {
        WelkinUnityProbe probe{};
        REQUIRE(welkin_pack_unity_probe(&sample, axes, &probe) == WELKIN_OK);
        WelkinUnityIrradianceOverPi u{};
        float* const first[3] = {u.shar, u.shag, u.shab};
        float* const second[3] = {u.shbr, u.shbg, u.shbb};
        for (std::size_t c = 0; c < 3; ++c) {
          const float* p = probe.sh[c];
          const float a[4] = {p[3], p[1], p[2], p[0] - p[6]}, b[4] = {p[4], p[5], 3.0F * p[6], p[7]};
          std::copy_n(a, 4, first[c]);
          std::copy_n(b, 4, second[c]);
          u.shc[c] = p[8];
        }
        return unityShader(u, inAxes(axes, normal));
      });
      INFO(light.name << ", axes " << axes);
      CHECK(error < kRounding);
      printError("Unity's ambient probe", light, error);
    }
  }
}

}  // namespace
}  // namespace welkin::tests
