// SPDX-License-Identifier: Apache-2.0
// Unreal's sky light against this library's: by its own formula, written anew, from a capture of the same sky, and by
// the material node of docs/engines.md.
#include <catch2/catch.hpp>

#include "tests/engines/engine_light.h"
#include "tests/engines/shader_types.h"

namespace welkin::tests {
namespace {

namespace unreal {
using namespace shader;

float3 node(const float3& N, const float4& V0, const float4& V1, const float4& V2, const float4& V3, const float4& V4,
            const float4& V5, const float4& V6) {
#include "unreal_node.inc"
}
}  // namespace unreal

TEST_CASE("Unreal, MaterialNodeOfTheDocsGivesTheIrradiance") {
  for (const EngineLight& light : engineLights()) {
    WelkinUnrealIrradianceOverPi packed{};
    REQUIRE(welkin_pack_unreal(&light.sample, &packed) == WELKIN_OK);
    const double error = largestError(light.sample, [&](const WelkinSkySample&, const Vector& normal) {
      const Vector n = inAxes(WELKIN_AXES_UNREAL, normal);
      const auto v = [&](int i) { return unreal::float4(packed.vectors[i]); };
      const unreal::float3 e = unreal::node({n[0], n[1], n[2]}, v(0), v(1), v(2), v(3), v(4), v(5), v(6));
      return Vector{e.x, e.y, e.z};
    });
    INFO(light.name);
    CHECK(error < kRounding);
    printError("Unreal's vectors", light, error);
  }
}

/// Radiance of a sample in a direction of Unreal's world.
std::array<double, 3> radianceAt(const WelkinSkySample& sample, double x, double y, double z) {
  const auto basis = basisOf(x, z, y);  // x east, y south, z up
  std::array<double, 3> sum{};
  for (std::size_t i = 0; i < 9; ++i)
    for (std::size_t c = 0; c < 3; ++c) sum[c] += basis[i] * double{sample.ambient_sh[i][c]};
  return sum;
}

/// A sky capture in Unreal projects radiance on its basis, whose odd m are negative, and packs the coefficients with
/// the cosine lobe and 1/pi into the seven vectors (SetupSkyIrradianceEnvironmentMapConstants). Three Gauss points in z
/// and eight azimuths are exact for polynomials of degree 5.
TEST_CASE("Unreal, VectorsAreThoseOfASkyCapture") {
  for (const EngineLight& light : engineLights()) {
    std::array<std::array<double, 3>, 9> v{};
    const double nodes[3] = {-std::sqrt(0.6), 0.0, std::sqrt(0.6)}, weights[3] = {5.0 / 9.0, 8.0 / 9.0, 5.0 / 9.0};
    for (int k = 0; k < 3; ++k) {
      for (int a = 0; a < 8; ++a) {
        const double z = nodes[k], radius = std::sqrt(1.0 - z * z), turn = a * M_PI / 4.0 + 0.1;
        const double x = radius * std::cos(turn), y = radius * std::sin(turn), solid_angle = weights[k] * M_PI / 4.0;
        auto basis = basisOf(x, y, z);
        for (const std::size_t odd : {1U, 3U, 5U, 7U}) basis[odd] = -basis[odd];
        const auto radiance = radianceAt(light.sample, x, y, z);
        for (std::size_t i = 0; i < 9; ++i)
          for (std::size_t c = 0; c < 3; ++c) v[i][c] += basis[i] * radiance[c] * solid_angle;
      }
    }
    const double root = std::sqrt(M_PI), c0 = 0.5 / root, c1 = std::sqrt(3.0) / (3.0 * root),
                 c2 = std::sqrt(15.0) / (8.0 * root), c3 = std::sqrt(5.0) / (16.0 * root);
    WelkinUnrealIrradianceOverPi packed{};
    REQUIRE(welkin_pack_unreal(&light.sample, &packed) == WELKIN_OK);
    INFO(light.name);
    for (std::size_t c = 0; c < 3; ++c) {
      const double first[4] = {-c1 * v[3][c], -c1 * v[1][c], c1 * v[2][c], c0 * v[0][c] - c3 * v[6][c]};
      const double second[4] = {c2 * v[4][c], -c2 * v[5][c], 3.0 * c3 * v[6][c], -c2 * v[7][c]};
      for (std::size_t i = 0; i < 4; ++i) {
        CHECK(double{packed.vectors[c][i]} == Approx(first[i]).margin(1e-6));
        CHECK(double{packed.vectors[3 + c][i]} == Approx(second[i]).margin(1e-6));
      }
      CHECK(double{packed.vectors[6][c]} == Approx(0.5 * c2 * v[8][c]).margin(1e-6));
    }
    CHECK(packed.vectors[6][3] == 1.0F);
  }
}

}  // namespace
}  // namespace welkin::tests
