// SPDX-License-Identifier: Apache-2.0
// Output of eval, inspect and sample against closed forms.
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
constexpr double kQuadrature = 1e-8;  // eval's quadrature is converged to about 1e-9 of the mean
constexpr double kFloat = 1e-5;       // the table holds floats of a quadrature that is kept to 1e-5 of c0
constexpr double kRounding = 1e-12;   // formulas in double

json printed(const Run& run) {
  INFO(run.err);
  REQUIRE(run.status == 0);
  return json::parse(run.out);
}

/// The three channels of an eval.
std::array<double, 3> eval(const std::string& sky, const std::string& direction, const std::string& quantity,
                           const std::string& time = "12") {
  const Folder folder;
  const auto value = printed(runTool({"eval", folder.write("sky.toml", sky), "--time", time, "--direction", direction,
                                      "--quantity", quantity, "--json"}))["value"];
  REQUIRE(value.size() == 3);
  return {value[0], value[1], value[2]};
}

void requireAll(const std::array<double, 3>& value, double expected, double margin) {
  for (const double v : value) REQUIRE(v == Approx(expected).margin(margin));
}

/// A baked sky, sampled as JSON.
json sample(const std::string& sky, const std::string& time, const std::string& normal) {
  const Folder folder;
  const Run baked =
      runTool({"bake", folder.write("sky.toml", sky), "-o", folder / "out", "--progress", "none", "--certify", "none"});
  INFO(baked.err);
  REQUIRE(baked.status == 0);
  return printed(runTool({"sample", folder / "out", "--time", time, "--normal", normal, "--json"}));
}

}  // namespace

TEST_CASE("Eval, UniformSkyGivesPiUpAndHalfOfItSideways") {
  requireAll(eval(skyText(kUniform), "0,1,0", "irradiance"), kPi, kQuadrature);
  requireAll(eval(skyText(kUniform), "1,0,0", "irradiance"), kPi / 2, kQuadrature);
  requireAll(eval(skyText(kUniform), "0,-1,0", "irradiance"), 0.0, kQuadrature);
}

TEST_CASE("Eval, OvercastSkyGivesMoonAndSpencersIrradiance") {
  const std::string sky = skyText("luminance = \"cie-overcast\"\nnormalise = \"zenith\"");
  requireAll(eval(sky, "0,1,0", "irradiance"), 7.0 * kPi / 9.0, kQuadrature);
  // Vertical surface: the integral of (1 + 2 sin el)/3 cos^2 el over half the azimuths = pi/6 + 4/9.
  requireAll(eval(sky, "0,0,-1", "irradiance"), kPi / 6.0 + 4.0 / 9.0, kQuadrature);
}

TEST_CASE("Eval, LuminanceOfTypeTwelveIsTheStandards") {
  // Sun at elevation 60, azimuth 0; element at elevation 45, azimuth 180 (south is +z): evaluated in 50 digits.
  const std::string sky = skyText("luminance = \"cie-12\"\nnormalise = \"zenith\"");
  requireAll(eval(sky, "0,1,1", "luminance"), 0.45445243068520, kRounding);
  requireAll(eval(sky, "0,5,0", "luminance"), 1.0, kRounding);
}

TEST_CASE("Eval, LuminanceIsOneTowardsTheSunWhenNormalisedToIt") {
  const std::string half_root_three = "0.86602540378443865";
  requireAll(eval(skyText(""), "0," + half_root_three + ",-0.5", "luminance"), 1.0,
             1e-9);  // the cusp: 24 per radian
}

TEST_CASE("Eval, GroundReflectsTheSkyAndTheSun") {
  const std::string dark = skyText(kUniform + "\nground_albedo = [0.1, 0.2, 0.5]");
  const double albedo[3] = {0.1, 0.2, 0.5};
  const auto down = eval(dark, "0,-1,0", "sky");
  const auto side = eval(dark, "-1,0,0", "irradiance");
  const auto lit =
      eval(skyText(kUniform + "\nground_albedo = [0.1, 0.2, 0.5]", "path = [[0, 90, 30]]\nilluminance = 2"), "0,-1,0",
           "dome");
  for (std::size_t c = 0; c < 3; ++c) {
    REQUIRE(down[c] == Approx(albedo[c]).margin(kQuadrature));
    REQUIRE(side[c] == Approx(kPi * (1.0 + albedo[c]) / 2.0).margin(kQuadrature));
    REQUIRE(lit[c] == Approx(albedo[c] * (kPi + 2.0 * 0.5) / kPi).margin(kQuadrature));
  }
}

TEST_CASE("Eval, TintIsOnTheDomeAboveTheHorizonOnly") {
  const std::string sky = skyText(kUniform + "\npolarising_tint = [2, 3, 4]\nground_albedo = [0.5, 0.5, 0.5]");
  const auto dome = eval(sky, "1,1,0", "dome");
  for (std::size_t c = 0; c < 3; ++c) REQUIRE(dome[c] == Approx(2.0 + static_cast<double>(c)).margin(kRounding));
  requireAll(eval(sky, "1,1,0", "sky"), 1.0, kRounding);
  requireAll(eval(sky, "0,1,0", "irradiance"), kPi, kQuadrature);
  requireAll(eval(sky, "0,-1,0", "dome"), 0.5, kQuadrature);
}

TEST_CASE("Eval, ColourHasTheGradientsHueAndTheModelsLuminance") {
  const std::string colours = "\ngradient_sun = [0.2, 0.5, 0.9]\ngradient_anti = [0.2, 0.5, 0.9]";
  const double y = 0.2126 * 0.2 + 0.7152 * 0.5 + 0.0722 * 0.9;
  const auto value = eval(skyText(kUniform + colours + "\nintensity = 3"), "1,1,1", "sky");
  REQUIRE(value[0] == Approx(3.0 * 0.2 / y).margin(kRounding * 10));
  REQUIRE(value[1] == Approx(3.0 * 0.5 / y).margin(kRounding * 10));
  REQUIRE(value[2] == Approx(3.0 * 0.9 / y).margin(kRounding * 10));
  requireAll(eval(skyText(kUniform + colours + "\nambient_saturation = 0"), "0,1,0", "irradiance"), kPi, kQuadrature);
}

TEST_CASE("Eval, IntensityIsLinearBetweenKeysAndPeriodic") {
  const std::string sky = skyText(kUniform + "\nintensity = [[0, 1], [12, 3]]");
  for (const char* time : {"6", "18", "30", "-6"}) requireAll(eval(sky, "0,1,0", "sky", time), 2.0, kRounding);
}

TEST_CASE("Inspect, UniformSkysCoefficientsAreClosedForms") {
  const Folder folder;
  const std::string sky = folder.write("sky.toml", skyText(kUniform, kStillSun, "keys = [0, 7.5]\ncubemap_size = 0"));
  REQUIRE(runTool({"bake", sky, "-o", folder / "out"}).status == 0);
  const json file = printed(runTool({"inspect", folder / "out", "--json"}));
  REQUIRE(file["sky"]["bands"] == 2);
  REQUIRE(file["sky"]["keys"].size() == 2);
  REQUIRE(file["sky"]["keys"][1]["time_h"] == 7.5);
  REQUIRE(file["settings"]["sky"]["luminance"] == "cie-5");
  for (const json& key : file["sky"]["keys"])
    for (const char* table : {"radiance_sh", "ambient_sh"})
      for (const char* channel : {"r", "g", "b"}) {
        const json& c = key[table][channel];
        REQUIRE(c.size() == 4);
        REQUIRE(c[0].get<double>() == Approx(std::sqrt(kPi)).margin(kFloat));
        REQUIRE(c[1].get<double>() == Approx(std::sqrt(3.0 * kPi) / 2.0).margin(kFloat));
        REQUIRE(c[2].get<double>() == Approx(0.0).margin(kFloat));
        REQUIRE(c[3].get<double>() == Approx(0.0).margin(kFloat));
      }
}

TEST_CASE("Sample, IrradianceOfAUniformSkyIsExactWithTwoBands") {
  // E(n) = pi ((1 + rho)/2 + (1 - rho)/2 n_y) is linear in n: two bands hold all of it.
  const std::string sky = skyText(kUniform + "\nground_albedo = [0.2, 0.2, 0.2]");
  const struct {
    const char* normal;
    double up;
  } cases[] = {{"0,1,0", 1.0}, {"-1,0,0", 0.0}, {"-.5,0,1", 0.0}, {"0,-1,0", -1.0}, {"3,4,0", 0.8}};
  for (const auto& at : cases) {
    const json sampled = sample(sky, "6", at.normal);
    const double expected = kPi * (0.6 + 0.4 * at.up);
    for (const json& v : sampled["irradiance"]) REQUIRE(v.get<double>() == Approx(expected).margin(4 * kFloat));
    requireAll(eval(sky, at.normal, "irradiance", "6"), expected, kQuadrature);
  }
}

TEST_CASE("Sample, SunFollowsItsKeysAndIsApartFromTheSky") {
  const std::string sky =
      skyText(kUniform,
              "path = [[6, 90, 0], [12, 180, 60], [18, 270, 0]]\nilluminance = [[6, 0], [12, 4]]\ncolour = [1, 0, 0]");
  const json sun = sample(sky, "9", "0,1,0")["sun"];
  REQUIRE(sun["azimuth_deg"].get<double>() == Approx(135.0).margin(kFloat * 10));  // float directions, in degrees
  REQUIRE(sun["elevation_deg"].get<double>() == Approx(30.0).margin(kFloat * 10));
  REQUIRE(sun["illuminance"] == 2.0);
  REQUIRE(sun["normal_irradiance"][0].get<double>() == Approx(2.0 / 0.2126).epsilon(1e-6));  // float
  REQUIRE(sun["normal_irradiance"][1] == 0.0);
  const json sampled = sample(sky, "12", "0,1,0");
  REQUIRE(sampled["irradiance"][0].get<double>() == Approx(kPi).margin(kFloat));
}
