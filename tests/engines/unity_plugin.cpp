// SPDX-License-Identifier: Apache-2.0
// A native plugin as docs/engines.md describes it: the functions of welkin.h in a shared library. Beside them the
// samples that unity_test.cs compares.
#include "tests/engines/engine_light.h"

namespace {

using welkin::tests::EngineLight;
using welkin::tests::Vector;

const std::vector<EngineLight>& lights() {
  static const std::vector<EngineLight> kLights = welkin::tests::engineLights();
  return kLights;
}

}  // namespace

extern "C" {
#define PLUGIN_API __attribute__((visibility("default")))

PLUGIN_API int test_light_count() {
  return static_cast<int>(lights().size());
}

PLUGIN_API const WelkinSkySample* test_sample(int light) {
  return &lights()[static_cast<std::size_t>(light)].sample;
}

PLUGIN_API int test_normal(int index, float* normal) {
  static const std::vector<Vector> kNormals = welkin::tests::engineNormals();
  if (static_cast<std::size_t>(index) >= kNormals.size()) return 0;
  std::copy_n(kNormals[static_cast<std::size_t>(index)].data(), 3, normal);
  return 1;
}

PLUGIN_API void test_sun(int light, float* direction, float* irradiance) {
  const WelkinLight& sun = test_sample(light)->sun;
  std::copy_n(sun.direction, 3, direction);
  std::copy_n(sun.normal_irradiance, 3, irradiance);
}

PLUGIN_API void test_irradiance(int light, const float* normal, float* irradiance) {
  const Vector e = welkin::tests::welkinIrradiance(*test_sample(light), {normal[0], normal[1], normal[2]});
  std::copy_n(e.data(), 3, irradiance);
}
}
