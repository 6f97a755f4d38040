// SPDX-License-Identifier: Apache-2.0
// Output of welkin reference against closed forms, and its refusals.
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "run_tool.h"
#include "sky_text.h"

using namespace welkin::tests;
using nlohmann::json;

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kStandardErrors = 4.0;
constexpr double kLevel = 2e-3;  // The ground ends 500 m away; beyond it is black.

/// A level: a square of ground, 1 km wide at y = 0, of the albedo 0.2, 0.5, 0.9.
class Level {
 public:
  explicit Level(const std::string& sky) {
    folder_.write("sky.toml", sky);
    folder_.write("ground.gltf", R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
      "nodes": [{"mesh": 0}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "material": 0}]}],
      "materials": [{"pbrMetallicRoughness": {"baseColorFactor": [0.2, 0.5, 0.9, 1], "metallicFactor": 0}}],
      "accessors": [{"bufferView": 0, "componentType": 5126, "count": 6, "type": "VEC3",
                     "min": [-500, 0, -500], "max": [500, 0, 500]}],
      "bufferViews": [{"buffer": 0, "byteLength": 72}], "buffers": [{"byteLength": 72, "uri": "ground.bin"}]})");
    std::string bytes;
    for (const float v : {-500.0F, 0.0F, -500.0F, -500.0F, 0.0F, 500.0F, 500.0F, 0.0F, 500.0F,  //
                          -500.0F, 0.0F, -500.0F, 500.0F, 0.0F, 500.0F, 500.0F, 0.0F, -500.0F})
      bytes.append(reinterpret_cast<const char*>(&v), sizeof v);
    folder_.write("ground.bin", bytes);
    path_ = folder_.write("level.toml", "[level]\nsky = \"sky.toml\"\n[[geometry]]\nfile = \"ground.gltf\"\n");
  }

  void append(const std::string& text) const { folder_.write("level.toml", readBytes(path_) + text); }
  Run run(std::vector<std::string> more) const {
    std::vector<std::string> arguments = {"reference", path_, "--time", "12", "--progress", "none"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return runTool(arguments);
  }
  json value(std::vector<std::string> more) const {
    more.emplace_back("--json");
    const Run done = run(more);
    INFO(done.err);
    REQUIRE(done.status == 0);
    return json::parse(done.out);
  }

 private:
  Folder folder_;
  std::string path_;
};

void check(const json& printed, const std::string& component, const std::array<double, 3>& expected) {
  for (std::size_t c = 0; c < 3; ++c) {
    const double value = printed["components"][component][c];
    const double error = printed["component_standard_error"][component][c];
    INFO(component << ", channel " << c << ": " << value << " +- " << error);
    CHECK(std::abs(value - expected[c]) <= kStandardErrors * error + kLevel);
  }
}

}  // namespace

TEST_CASE("Reference, PrintsTheIrradianceOfAPlaneByComponents") {
  const Level level(skyText(kUniform, "path = [[0, 0, 30]]\nilluminance = 4.0"));
  const json e = level.value({"--position", "0,2,0", "--normal", "0,-1,0", "--light", "0,2,0,3,4,5"});
  check(e, "sky", {0.2 * kPi, 0.5 * kPi, 0.9 * kPi});
  check(e, "sun_bounce", {0.2 * 2.0, 0.5 * 2.0, 0.9 * 2.0});
  check(e, "local", {0.2 * 3.0 / 10.0, 0.5 * 4.0 / 10.0, 0.9 * 5.0 / 10.0});  // 2 rho I / (5 h^2)
  for (std::size_t c = 0; c < 3; ++c) {
    double sum = 0.0;
    for (const char* component : {"sky", "sun_bounce", "local"}) sum += double{e["components"][component][c]};
    CHECK(double{e["irradiance"][c]} == Approx(sum).epsilon(1e-12));
    CHECK(double{e["standard_error"][c]} > 0.0);
    CHECK(double{e["standard_error"][c]} < 0.02);
  }
  CHECK(e["samples"] == 65536);
  const Run text = level.run({"--position", "0,2,0", "--normal", "0,1,0", "--samples", "64"});
  CHECK(text.status == 0);
  CHECK(text.out.starts_with("irradiance 3.14159 3.14159 3.14159 +- "));
}

TEST_CASE("Reference, IsTheSameForAnyThreadsAndAnotherForAnotherSeed") {
  const Level level(skyText("luminance = \"cie-12\""));
  const auto at = [&](std::vector<std::string> more) {
    more.insert(more.end(), {"--position", "0,2,0", "--normal", "1,-1,.5", "--samples", "5000"});
    return level.value(more);
  };
  const json one = at({"--threads", "1"});
  CHECK(one == at({"--threads", "4"}));
  CHECK(one != at({"--seed", "1"}));
  CHECK(at({"--bounces", "0"})["irradiance"][0] < one["irradiance"][0]);
}

TEST_CASE("Reference, TakesNegativeNumbersAndRefusesWhatIsNoLight") {
  const Level level(skyText(kUniform));
  const std::vector<std::string> place = {"--position", "-1,2,0", "--normal", "-1,0,0", "--samples", "64"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.end(), place.begin(), place.end());
    return level.run(more);
  };
  CHECK(with({"--light", "-1,2,0,1,1,1,0.5"}).status == 0);
  for (const char* light :
       {"1,2,3,4,5", "1,2,3,4,5,-6", "1,2,3,4,5,6,-1", "1,2,3,4,5,6,7,8", "1,2,nan,4,5,6", "lamp"}) {
    const Run run = with({"--light", light});
    CHECK(run.status == 1);
    CHECK(run.said("--light: \"" + std::string(light) + "\" is not a light"));
  }
  const Run run = level.run({"--position", "1,2", "--normal", "0,1,0"});
  CHECK(run.status == 1);
  CHECK(run.said("--position: \"1,2\" is not a position"));
  CHECK(level.run({"--position", "1,2,3", "--normal", "0,0,0"}).status == 1);
  CHECK(level.run({"--position", "1,2,3", "--normal", "0,1,0", "--samples", "0"}).status == 1);
}

TEST_CASE("Reference, BouncesAreTheLevels") {
  const Level level(skyText(kUniform));
  const std::vector<std::string> point = {"--position", "0,1,0", "--normal=0,-1,0", "--samples", "256"};
  REQUIRE(level.value(point)["bounces"] == 2);
  level.append("[transfer]\nbounces = 0\n");
  const json none = level.value(point);
  REQUIRE(none["bounces"] == 0);
  REQUIRE(none["irradiance"] == json({0.0, 0.0, 0.0}));
  std::vector<std::string> one = point;
  one.insert(one.end(), {"--bounces", "1"});
  REQUIRE(level.value(one)["irradiance"][0] > 0.0);
}
