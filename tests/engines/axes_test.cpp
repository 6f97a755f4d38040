// SPDX-License-Identifier: Apache-2.0
// Axes of engines: compass points, handedness, what is refused.
#include <catch2/catch.hpp>

#include "tests/engines/engine_light.h"

namespace welkin::tests {
namespace {

constexpr WelkinAxes kAllAxes[] = {WELKIN_AXES_WELKIN, WELKIN_AXES_UNITY, WELKIN_AXES_UNITY_IMPORT, WELKIN_AXES_UNREAL};

TEST_CASE("Axes, CompassPoints") {
  const Vector east = {1, 0, 0}, up = {0, 1, 0}, north = {0, 0, -1};
  struct Point {
    WelkinAxes axes;
    Vector east, up, north;
  };
  const Point points[] = {{WELKIN_AXES_WELKIN, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}},
                          {WELKIN_AXES_UNITY, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                          {WELKIN_AXES_UNITY_IMPORT, {-1, 0, 0}, {0, 1, 0}, {0, 0, -1}},
                          {WELKIN_AXES_UNREAL, {1, 0, 0}, {0, 0, 1}, {0, -1, 0}}};
  for (const Point& p : points) {
    INFO("axes " << p.axes);
    CHECK(inAxes(p.axes, east) == p.east);
    CHECK(inAxes(p.axes, up) == p.up);
    CHECK(inAxes(p.axes, north) == p.north);
  }
}

TEST_CASE("Axes, LeftHandedButThisLibrarys") {
  for (const WelkinAxes axes : kAllAxes) {
    const Vector x = inAxes(axes, {1, 0, 0}), y = inAxes(axes, {0, 1, 0}), z = inAxes(axes, {0, 0, 1});
    const float triple =
        x[0] * (y[1] * z[2] - y[2] * z[1]) + x[1] * (y[2] * z[0] - y[0] * z[2]) + x[2] * (y[0] * z[1] - y[1] * z[0]);
    CHECK(triple == (axes == WELKIN_AXES_WELKIN ? 1.0F : -1.0F));
  }
}

TEST_CASE("Axes, RadianceIsTheSameFunctionInTheOtherAxes") {
  for (const EngineLight& light : engineLights()) {
    for (const WelkinAxes axes : kAllAxes) {
      WelkinRadianceSh packed{};
      REQUIRE(welkin_pack_radiance(&light.sample, axes, &packed) == WELKIN_OK);
      for (const Vector& d : engineNormals()) {
        const Vector e = inAxes(axes, d);
        const auto here = basisOf(double{d[0]}, double{d[1]}, double{d[2]});
        const auto there = basisOf(double{e[0]}, double{e[1]}, double{e[2]});
        for (std::size_t c = 0; c < 3; ++c) {
          double expected = 0.0, value = 0.0;
          for (std::size_t i = 0; i < 9; ++i) {
            expected += here[i] * double{light.sample.ambient_sh[i][c]};
            value += there[i] * double{packed.sh[i][c]};
          }
          REQUIRE(value == Approx(expected).margin(1e-6));
        }
      }
      if (axes != WELKIN_AXES_WELKIN) continue;
      for (std::size_t i = 0; i < 9; ++i)
        for (std::size_t c = 0; c < 3; ++c) CHECK(packed.sh[i][c] == light.sample.ambient_sh[i][c]);
    }
  }
}

TEST_CASE("Axes, OthersAndNullAreRefused") {
  const EngineLight light = engineLights()[0];
  const auto other = static_cast<WelkinAxes>(4);
  Vector v = {1, 0, 0};
  WelkinRadianceSh radiance{};
  WelkinUnityIrradianceOverPi unity{};
  WelkinUnityProbe probe{};
  CHECK(welkin_axes_vector(other, v.data(), v.data()) == WELKIN_ERROR_ARGUMENT);
  CHECK(welkin_axes_vector(WELKIN_AXES_UNITY, nullptr, v.data()) == WELKIN_ERROR_ARGUMENT);
  CHECK(welkin_pack_radiance(&light.sample, other, &radiance) == WELKIN_ERROR_ARGUMENT);
  CHECK(welkin_pack_unity_axes(&light.sample, other, &unity) == WELKIN_ERROR_ARGUMENT);
  CHECK(welkin_pack_unity_axes(nullptr, WELKIN_AXES_UNITY, &unity) == WELKIN_ERROR_ARGUMENT);
  CHECK(welkin_pack_unity_probe(&light.sample, other, &probe) == WELKIN_ERROR_ARGUMENT);
  CHECK(welkin_pack_filament_radiance(&light.sample, nullptr) == WELKIN_ERROR_ARGUMENT);
  CHECK(welkin_pack_unreal(&light.sample, nullptr) == WELKIN_ERROR_ARGUMENT);
  CHECK(welkin_pack_godot(nullptr, nullptr) == WELKIN_ERROR_ARGUMENT);
  CHECK(v == Vector{1, 0, 0});
}

}  // namespace
}  // namespace welkin::tests
