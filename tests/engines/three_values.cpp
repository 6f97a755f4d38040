// SPDX-License-Identifier: Apache-2.0
// Prints as JSON the samples that three_test.mjs gives to three.js: in the form of `welkin sample --json`, with this
// library's irradiance at many normals.
#include <cstdio>

#include "tests/engines/engine_light.h"

int main() {
  using namespace welkin::tests;
  std::printf("[");
  bool first = true;
  for (const EngineLight& light : engineLights()) {
    const WelkinSkySample& s = light.sample;
    WelkinRadianceSh packed{};
    if (welkin_pack_radiance(&s, WELKIN_AXES_WELKIN, &packed) != WELKIN_OK) return 1;
    std::printf("%s\n{\"name\": \"%s\", \"ambient_sh\": {", first ? "" : ",", light.name.c_str());
    for (int c = 0; c < 3; ++c) {
      std::printf("%s\"%c\": [", c == 0 ? "" : ", ", "rgb"[c]);
      for (std::uint32_t i = 0; i < s.coefficient_count; ++i)
        std::printf("%s%.9g", i == 0 ? "" : ", ", double{packed.sh[i][c]});
      std::printf("]");
    }
    const float *d = s.sun.direction, *e = s.sun.normal_irradiance;
    std::printf("}, \"sun\": {\"direction\": [%.9g, %.9g, %.9g], \"normal_irradiance\": [%.9g, %.9g, %.9g]},",
                double{d[0]}, double{d[1]}, double{d[2]}, double{e[0]}, double{e[1]}, double{e[2]});
    std::printf("\n \"irradiance\": [");
    bool first_normal = true;
    for (const Vector& n : engineNormals()) {
      const Vector v = welkinIrradiance(s, n);
      std::printf("%s\n  [[%.9g, %.9g, %.9g], [%.9g, %.9g, %.9g]]", first_normal ? "" : ",", double{n[0]}, double{n[1]},
                  double{n[2]}, double{v[0]}, double{v[1]}, double{v[2]});
      first_normal = false;
    }
    std::printf("]}");
    first = false;
  }
  std::printf("\n]\n");
}
