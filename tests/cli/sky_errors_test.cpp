// SPDX-License-Identifier: Apache-2.0
// Sky files with wrong content: status 3. The message names the file, the line, the key, the value and the allowed
// range. Nothing crashes, hangs or is written.
#include <catch2/catch.hpp>
#include <string>

#include "run_tool.h"
#include "sky_text.h"

using namespace welkin::tests;
namespace fs = std::filesystem;

namespace {

struct Case {
  std::string text;
  std::vector<std::string> said;
};

void requireInvalid(const std::vector<Case>& cases) {
  for (const Case& c : cases) {
    const Folder folder;
    const Run run = runTool({"bake", folder.write("sky.toml", c.text), "-o", folder / "out"}, {{}, "", "", 0, 30.0});
    INFO(c.text.substr(0, 300) << "\n" << run.err.substr(0, 600));
    REQUIRE(run.status == 3);
    REQUIRE(run.said(folder / "sky.toml"));
    REQUIRE(run.err.size() < 1000);
    for (const auto& part : c.said) {
      INFO(part);
      REQUIRE(run.said(part));
    }
    REQUIRE_FALSE(fs::exists(folder / "out"));
  }
}

Case sky(const std::string& key, std::vector<std::string> said) {
  said.push_back("sky." + key.substr(0, key.find(' ')));
  said.push_back(":2:");  // the line
  return {skyText(key), said};
}
Case sun(const std::string& keys, const std::vector<std::string>& said) {
  return {skyText(kUniform, keys), said};
}
Case bake(const std::string& keys, const std::vector<std::string>& said) {
  return {skyText(kUniform, kStillSun, keys), said};
}

}  // namespace

TEST_CASE("SkyErrors, KeysOfTheSky") {
  requireInvalid({sky("lumninance = 1", {"unknown key", "\"luminance\""}),
                  sky("luminance = \"cie-16\"", {"cie-16", "\"cie-15\"", "far-cry-3"}),
                  sky("luminance = 3", {"= 3", "name or five coefficients"}),
                  sky("luminance = [1, 2, 3, 4]", {"five coefficients"}),
                  sky("luminance = [1, 2, \"c\", 4, 5]", {"coefficient c"}),
                  sky("luminance = [nan, -1, 1, -1, 0]", {"coefficient a", "nan"}),
                  sky("normalise = \"moon\"", {"moon", "\"zenith\""}),
                  sky("intensity = nan", {"= nan", "0 to 1"}),
                  sky("intensity = inf", {"= inf"}),
                  sky("intensity = -1", {"= -1", "0 to"}),
                  sky("intensity = true", {"= true", "a number"}),
                  sky("intensity = []", {"at least one key"}),
                  sky("intensity = [[0, 1], [0, 2]]", {"must ascend"}),
                  sky("intensity = [[6, 1], [3, 2]]", {"must ascend", "3"}),
                  sky("intensity = [[24, 1]]", {"[0, 24)", "24"}),
                  sky("intensity = [[-1, 1]]", {"[0, 24)"}),
                  sky("intensity = [[nan, 1]]", {"[0, 24)", "nan"}),
                  sky("intensity = [[1, nan]]", {"nan"}),
                  sky("intensity = [[\"noon\", 1]]", {"[0, 24)", "noon"}),
                  sky("intensity = [[1, 1, 1]]", {"[time_h, value]"}),
                  sky("gradient_sun = [1, 2]", {"[r, g, b]"}),
                  sky("gradient_sun = [1, -2, 3]", {"-2"}),
                  sky("gradient_anti = 1979-05-27", {"1979-05-27", "[r, g, b]"}),
                  sky("polarising_tint = [[1, 2, 3]]", {"[time_h, [r, g, b]]"}),
                  sky("ambient_saturation = 1.5", {"1.5", "0 to 1"}),
                  sky("ground_albedo = [0, 0, 1.01]", {"1.01", "0 to 1"}),
                  sky("luminance_unit = 0", {"= 0"})});
}

TEST_CASE("SkyErrors, SunAndMoon") {
  requireInvalid({{"[sky]\n", {"[sun]", "missing"}},
                  {"[sun]\nlatitude_deg = 1\nday_of_year = 1\n", {"[sky]", "missing"}},
                  {"sky = 3\n[sun]\n", {"sky = 3", "table"}},
                  {"[[sky]]\n[sun]\n", {"sky", "table"}},
                  sun("", {"sun.latitude_deg", "missing"}),
                  sun("latitude_deg = 10", {"sun.day_of_year", "missing"}),
                  sun("latitude_deg = 91\nday_of_year = 1", {"sun.latitude_deg = 91", "-90 to 90"}),
                  sun("latitude_deg = 10\nday_of_year = 1.5", {"sun.day_of_year = 1.5", "1 to 366"}),
                  sun("latitude_deg = 10\nday_of_year = 367", {"sun.day_of_year = 367", "1 to 366"}),
                  sun("latitude_deg = 10\nday_of_year = 9223372036854775807", {"1 to 366"}),
                  sun(kStillSun + "\nlatitude_deg = 10", {"sun.latitude_deg = 10", "beside path"}),
                  sun(kStillSun + "\nday_of_year = 10", {"sun.day_of_year = 10", "beside path"}),
                  sun("path = [[0, 0]]", {"sun.path", "3 numbers"}),
                  sun("path = []", {"sun.path", "at least one"}),
                  sun("path = [[0, 0, 91]]", {"sun.path = 91", "-90 to 90"}),
                  sun("path = [[0, 0, 0], [0, 1, 1]]", {"sun.path", "ascend"}),
                  sun(kStillSun + "\ncolour = [0, 0, 0]", {"sun.colour", "black"}),
                  sun(kStillSun + "\ncolour = [[0, [1, 1, 1]], [1, [0, 0, 0]]]", {"sun.colour", "black"}),
                  sun(kStillSun + "\nilluminance = -1", {"sun.illuminance = -1"}),
                  sun(kStillSun + "\ndisc_radius_deg = 46", {"sun.disc_radius_deg = 46", "0 to 45"}),
                  sun(kStillSun + "\nphase = 0", {"sun.phase", "unknown key"}),
                  sun(kStillSun + "\n[moon]", {"moon.path", "declination_deg"}),
                  sun(kStillSun + "\n[moon]\ndeclination_deg = 0\nphase = 0", {"moon.latitude_deg", "missing"}),
                  sun(kStillSun + "\n[moon]\npath = [[0, 0, 0]]\nphase = 0", {"moon.phase", "beside path"}),
                  sun(kStillSun + "\n[mon]", {"mon", "unknown key", "\"moon\""})});
}

TEST_CASE("SkyErrors, Bake") {
  requireInvalid(
      {bake("bands = 6", {"bake.bands = 6", "2 to 5"}),
       bake("bands = 2.0", {"bake.bands = 2.0", "whole number"}),
       bake("bands = \"many\"", {"bake.bands = 'many'", "2 to 5"}),
       bake("keys = 0", {"bake.keys = 0", "1 to 86400"}),
       bake("keys = 1.5", {"bake.keys = 1.5"}),
       bake("keys = [1, 1]", {"bake.keys", "ascending"}),
       bake("keys = [23, 24]", {"bake.keys", "[0, 24)"}),
       bake("keys = [nan]", {"bake.keys"}),
       bake("keys = [\"a\"]", {"bake.keys"}),
       bake("cubemap_size = 1", {"bake.cubemap_size = 1", "2 to 4096"}),
       bake("cubemap_size = 4097", {"bake.cubemap_size = 4097", "4096"}),
       bake("cubemap_size = 4096\ncubemap_times = 1440", {"bake.cubemap_size = 4096", "1440", "1.5e9"}),
       bake("cubemap_format = \"rgb9e4\"", {"bake.cubemap_format = 'rgb9e4'", "rgba16f", "rgb9e5", "b10g11r11"}),
       bake("gradient_format = \"half\"", {"bake.gradient_format = 'half'", "rgb32f", "rgb9e5"}),
       bake("cubemap_format = 1", {"bake.cubemap_format"}),
       bake("cubemap_times = \"all\"", {"bake.cubemap_times"}),
       bake("cubemap_times = [1, 1.0000000001]", {"bake.cubemap_times", "millisecond"}),
       bake("max_error = 0", {"bake.max_error = 0", "1e-05 to 1"}),
       bake("max_error = 2", {"bake.max_error = 2", "to 1"}),
       bake("max_error = nan", {"bake.max_error"}),
       bake("max_error = \"draft\"", {"bake.max_error = 'draft'"}),
       bake("reconstruction = \"best\"", {"bake.reconstruction = 'best'", "projected", "fitted", "modes"}),
       bake("encoding = \"half\"", {"bake.encoding = 'half'", "float16", "fixed8"}),
       bake("window = \"soft\"", {"bake.window = 'soft'", "mildest"})});
}

TEST_CASE("SkyErrors, FreeCoefficientsMustKeepTheSkyBright") {
  // Type 12 with the misprint c = -10 and Far Cry 3 with -24 are negative at the sun.
  const std::string high = "path = [[0, 180, 30]]";
  requireInvalid(
      {{skyText("luminance = [-1, -0.32, -10, -3, 0.45]", high),
        {"sky.luminance", "c = -10", "negative", "sun elevation 30.00", "direction (0.0000, 0.5000, 0.8660)"}},
       {skyText("luminance = [-1, -0.08, -24, -3, 0.3]", high), {"c = -24", "sun elevation 30.00"}},
       {skyText("luminance = [0, -1, 0, -1, -1.5]", high), {"e = -1.5", "negative", "direction"}},
       {skyText("luminance = [-2, -0.1, 1, -1, 0]", high), {"a = -2", "zenith"}},
       {skyText("luminance = [0, 0.5, 1, -1, 0]", high), {"b = 0.5", "below 0"}},
       {skyText("luminance = [0, -0.5, 1, 1, 0]", high), {"d = 1", "below 0"}}});
}

TEST_CASE("SkyErrors, HostileText") {
  const auto repeat = [](const std::string& part, int times) {
    std::string text;
    for (int i = 0; i < times; ++i) text += part;
    return text;
  };
  constexpr int kDeep = 100000;
  requireInvalid({{"", {"[sky]", "missing"}},
                  {"this is not TOML", {":1:", "not TOML"}},
                  {"[sky]\nintensity = 1\nintensity = 2", {":3:", "not TOML"}},
                  {"[sky]\nx = " + repeat("[", kDeep), {":2:", "more than 16 lists"}},
                  {"[sky]\nx = " + repeat("[", kDeep) + repeat("]", kDeep), {":2:", "more than 16 lists"}},
                  {"[sky]\nx = " + repeat("{a=", kDeep), {":2:", "more than 16 lists"}},
                  {"[sky]\n\na" + repeat(".a", kDeep) + " = 1", {":3:", "parts"}},
                  {"[sky]\na" + repeat(" . \"a\"", kDeep) + " = 1", {":2:", "parts"}},
                  {"[sky" + repeat(".a", kDeep) + "]", {":1:", "parts"}},
                  {"[sky]\nx = " + repeat("{a.a.a.a.a.a.a.a.a.a.a.a = ", 200) + "1" + repeat("}", 200),
                   {":2:", "more than 16 lists"}},
                  {"[sky]\n" + std::string(1 << 20, 'a') + " = 1", {"unknown key", "..."}},
                  {"#" + std::string(20 << 20, ' '), {"bytes", "16777216"}},
                  {std::string(1000, '\0'), {"not TOML"}},
                  {std::string("[sky]\nnormalise = \"s\0n\"", 22), {"not TOML"}},
                  {"[sky]\nnormalise = \"\xff\xfe\"", {"not TOML"}},
                  {"\x89PNG\r\n\x1a\n", {"not TOML"}}});
}

TEST_CASE("SkyErrors, DotsOutsideKeysAreNotParts") {
  const Folder folder;
  const std::string dots(100, '.');
  const std::string text =
      "# " + dots + "\n" +
      skyText(kUniform + "\nintensity = [[0, 1.5], [1, 2.5], [2, 3.5], [3, .5e1]" + "\n# \"" + dots + "\n]");
  const Run run = runTool({"validate", folder.write("sky.toml", text)});
  INFO(run.err);
  REQUIRE(run.status == 3);  // ".5e1" is not TOML; toml++ complains about it, not about the dots.
  REQUIRE(run.said("not TOML"));
  std::string good = text;
  good.replace(good.find(".5e1"), 4, "0.5");
  REQUIRE(runTool({"validate", folder.write("sky.toml", good)}).status == 0);
}
