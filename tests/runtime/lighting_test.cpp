// SPDX-License-Identifier: Apache-2.0
// Lighting from samples for renderers: packings against the irradiance itself, blends, the key light, unchanged
// results.
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "shared.h"
#include "welkin/welkin.h"

namespace welkin {
namespace {

WelkinSkySample randomSample(unsigned seed, std::uint32_t count) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> value(-0.3F, 0.3F);
  WelkinSkySample s{};
  s.coefficient_count = count;
  for (std::uint32_t i = 0; i < count; ++i)
    for (int c = 0; c < 3; ++c) s.ambient_sh[i][c] = i == 0 ? 3.0F + value(random) : value(random);
  return s;
}

const float kNormals[][3] = {{0, 1, 0}, {1, 0, 0}, {0, 0, -1}, {0.36F, 0.48F, 0.8F}, {-0.6F, -0.64F, 0.48F}};

TEST_CASE("Pack, FilamentPolynomialIsIrradianceOverPi") {
  for (const std::uint32_t count : {4U, 9U}) {
    const WelkinSkySample s = randomSample(3, count);
    WelkinFilamentIrradianceOverPi packed;
    REQUIRE(welkin_pack_filament(&s, &packed) == WELKIN_OK);
    for (const auto& n : kNormals) {
      const double x = double{n[0]}, y = double{n[1]}, z = double{n[2]};
      const double term[9] = {1, y, z, x, y * x, y * z, 3 * z * z - 1, z * x, x * x - y * y};
      float e[3];
      REQUIRE(welkin_sample_irradiance(&s, n, e) == WELKIN_OK);
      for (int c = 0; c < 3; ++c) {
        double sum = 0.0;
        for (int i = 0; i < 9; ++i) sum += term[i] * double{packed.sh[i][c]};
        CHECK(sum == Approx(double{e[c]} / M_PI).epsilon(1e-6));
      }
    }
  }
}

TEST_CASE("Pack, UnityConstantsAreIrradianceOverPi") {
  const WelkinSkySample s = randomSample(4, 9);
  WelkinUnityIrradianceOverPi u;
  REQUIRE(welkin_pack_unity(&s, &u) == WELKIN_OK);
  const float* const a[3] = {u.shar, u.shag, u.shab};
  const float* const b[3] = {u.shbr, u.shbg, u.shbb};
  for (const auto& n : kNormals) {
    float e[3];
    REQUIRE(welkin_sample_irradiance(&s, n, e) == WELKIN_OK);
    const float first[4] = {n[0], n[1], n[2], 1.0F};
    const float second[4] = {n[0] * n[1], n[1] * n[2], n[2] * n[2], n[2] * n[0]};
    for (int c = 0; c < 3; ++c) {
      double sum = double{u.shc[c]} * (double{n[0]} * double{n[0]} - double{n[1]} * double{n[1]});
      for (int i = 0; i < 4; ++i) sum += double{a[c][i]} * double{first[i]} + double{b[c][i]} * double{second[i]};
      CHECK(sum == Approx(double{e[c]} / M_PI).epsilon(1e-6));
    }
  }
}

TEST_CASE("Blend, LinearInWhatLightsTheScene") {
  WelkinSkySample a = randomSample(5, 9);
  WelkinSkySample b = randomSample(6, 9);
  a.sun.direction[0] = 1.0F;
  b.sun.direction[1] = 1.0F;
  a.sun.normal_irradiance[2] = 2.0F;
  b.sun.normal_irradiance[2] = 4.0F;
  b.polarising_tint[0] = 1.0F;
  WelkinSkySample blended{};
  REQUIRE(welkin_sample_blend(&a, &b, 0.25F, &blended) == WELKIN_OK);
  CHECK(double{blended.ambient_sh[5][1]} ==
        Approx(0.75 * double{a.ambient_sh[5][1]} + 0.25 * double{b.ambient_sh[5][1]}).epsilon(1e-6));
  CHECK(double{blended.sun.normal_irradiance[2]} == Approx(2.5));
  CHECK(double{blended.polarising_tint[0]} == Approx(0.25));
  CHECK(double{blended.sun.direction[0]} == Approx(0.75 / std::hypot(0.75, 0.25)).epsilon(1e-6));
  REQUIRE(welkin_sample_blend(&a, &b, 0.0F, &blended) == WELKIN_OK);
  CHECK(blended.ambient_sh[7][0] == a.ambient_sh[7][0]);
  REQUIRE(welkin_sample_blend(&a, &b, 1.0F, &a) == WELKIN_OK);  // in place
  CHECK(a.ambient_sh[7][0] == b.ambient_sh[7][0]);
  CHECK(welkin_sample_blend(&a, &b, NAN, &blended) == WELKIN_ERROR_ARGUMENT);
  b.coefficient_count = 4;
  CHECK(welkin_sample_blend(&a, &b, 0.5F, &blended) == WELKIN_ERROR_ARGUMENT);
}

TEST_CASE("KeyLight, HandsOverWithoutAJump") {
  WelkinSkySample s{};
  s.sun.direction[0] = 1.0F;
  s.moon.direction[0] = -1.0F;
  s.moon.visible = 1.0F;
  s.sun.visible = 1.0F;
  for (int c = 0; c < 3; ++c) s.moon.normal_irradiance[c] = 0.01F;
  double last = 0.0;
  float side = 0.0F;
  int changes = 0;
  for (int i = 0; i <= 2000; ++i) {  // the sun sets: its irradiance falls from 0.02 to 0
    for (int c = 0; c < 3; ++c) s.sun.normal_irradiance[c] = 0.02F * static_cast<float>(2000 - i) / 2000.0F;
    WelkinLight key{};
    REQUIRE(welkin_sample_key_light(&s, &key) == WELKIN_OK);
    const double x = double{key.normal_irradiance[1]} * double{key.direction[0]};  // Steps of this vector are visible.
    if (i > 0) REQUIRE(std::abs(x - last) < 2e-5);
    if (i > 0 && key.direction[0] != side) ++changes;
    side = key.direction[0];
    last = x;
  }
  CHECK(changes == 1);
  CHECK(last == Approx(-0.01));
}

}  // namespace
}  // namespace welkin
