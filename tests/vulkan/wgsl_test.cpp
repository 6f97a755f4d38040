// SPDX-License-Identifier: Apache-2.0
// The modes' include in WGSL, compiled and run by Dawn of npm on Mesa's OpenGL ES without a GPU.
#include <welkin/sky_constants.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "mode_normals.h"
#include "test_sky.h"
#include "tests/folder.h"
#include "worst.h"

namespace welkin::tests {

TEST_CASE("WgslModes, EqualRuntime") {
#ifdef WELKIN_MODES_WGSL
  if (!std::filesystem::exists(std::string(WELKIN_DAWN) + "/index.js") ||
      std::system("node --version >/dev/null 2>&1") != 0) {
    WARN("skipped: node or Dawn is missing; tools/setup.sh --tests fetches the package webgpu by npm");
    return;
  }
  // Mesa's software filters with floats. So the error has the bound of modes_test.cpp without a device's filter: 56
  // units of 2^-24.
  constexpr double kTolerance = 56.0 / 16777216.0;
  const Folder folder;
  nlohmann::json cases = nlohmann::json::array();
  std::vector<std::vector<Vector>> expected;
  const std::vector<Vector> directions = modeNormals();
  for (const uint8_t count : {3, 4, 5, 8, 12})
    for (const int holds : {4, 8, 12}) {
      const auto bytes = testSkyFile({.mode_count = count});
      const Sky sky = openTestSky(bytes);
      WelkinSkySample sample{};
      REQUIRE(sky.sample(12.2, sample));
      WelkinSkyConstants constants{};
      REQUIRE(welkin_sky_constants(sky.get(), &sample, &constants, sizeof constants) == WELKIN_OK);
      WelkinModes modes{};
      REQUIRE(welkin_sky_modes(sky.get(), &modes) == WELKIN_OK);
      const std::size_t layers = (modes.count + 3) / 4;
      const std::size_t size = std::size_t{modes.columns} * modes.rows;
      std::vector<uint16_t> texels(4 * layers * size);  // as docs/engines.md says
      for (std::size_t t = 0; t < size; ++t)
        for (std::size_t k = 0; k < modes.count; ++k)
          texels[4 * (k / 4 * size + t) + k % 4] = modes.texels[t * modes.count + k];
      const auto* floats = reinterpret_cast<const float*>(&constants);
      cases.push_back({{"count", count},
                       {"holds", holds},
                       {"constants", std::vector<float>(floats, floats + sizeof constants / sizeof(float))},
                       {"columns", modes.columns},
                       {"rows", modes.rows},
                       {"layers", layers},
                       {"texels", texels}});
      expected.emplace_back();
      for (const Vector& n : directions) expected.back().push_back(expectedOf(sky, sample, n));
    }
  const std::string input =
      folder.write("input.json", nlohmann::json{{"normals", directions}, {"cases", cases}}.dump());
  const std::string command = std::string("LIBGL_ALWAYS_SOFTWARE=1 EGL_PLATFORM=surfaceless node ") + WELKIN_RUN_WGSL +
                              " " + WELKIN_DAWN + " " + WELKIN_MODES_WGSL + " " + input + " > " +
                              folder / "output.json";
  const int status = std::system(command.c_str());
  const auto output = nlohmann::json::parse(readBytes(folder / "output.json"), nullptr, false);
  if (output.is_object() && output.contains("skipped")) {
    WARN("skipped: " << output["skipped"].get<std::string>());
    return;
  }
  REQUIRE(status == 0);
  REQUIRE(output.size() == expected.size());
  double most = 0.0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    CAPTURE(cases[i]["count"].dump(), cases[i]["holds"].dump());
    float largest = 0.0F;
    for (const Vector& e : expected[i])
      for (const float v : e) largest = std::max(largest, v);
    Worst worst;
    REQUIRE(output[i].size() == 8 * directions.size());
    for (std::size_t n = 0; n < directions.size(); ++n)
      for (std::size_t c = 0; c < 3; ++c) {
        const double e = double{expected[i][n][c]};
        const auto at = [&] { return "normal " + std::to_string(n); };
        worst.compare(output[i][8 * n + c].get<double>(), e, double{largest}, at);
        worst.compare(output[i][8 * n + 4 + c].get<double>(), e / M_PI, double{largest} / M_PI, at);
      }
    CAPTURE(worst.where);
    if (cases[i]["count"] > cases[i]["holds"]) {
      CHECK(worst.error > 0.01);  // a layer is not read
      continue;
    }
    CHECK(worst.error < kTolerance);
    most = std::max(most, worst.error);
  }
  WARN("WGSL differs from the runtime by " << most << " of the largest irradiance");
#else
  WARN("skipped: the build has no spirv-cross, so there is no WGSL");
#endif
}

}  // namespace welkin::tests
