// SPDX-License-Identifier: Apache-2.0
// Every key of sky.toml has its effect, defaults included. tests/cli/sky_errors_test.cpp covers refusals.
#include "sky/bake/sky_file.h"

#include <OpenImageIO/imageio.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>

#include "degree.h"
#include "sky/base/error.h"
#include "tests/folder.h"

namespace welkin::tests {

using det::Number3;
namespace {

constexpr double kRounding = 1e-12;  // of a product or two in double
const std::string kStill = "[sun]\npath = [[0, 0, 45]]\n";

bake::SkyFile read(const std::string& text, const Folder& folder = Folder()) {
  return bake::readSkyFile(folder.write("sky.toml", text));
}

void writeExr(const std::string& path, int width, int height, const std::vector<float>& rgb) {
  auto output = OIIO::ImageOutput::create("a.exr");
  REQUIRE(output);
  REQUIRE(output->open(path, OIIO::ImageSpec(width, height, 3, OIIO::TypeDesc::FLOAT)));
  REQUIRE(output->write_image(OIIO::TypeDesc::FLOAT, rgb.data()));
  REQUIRE(output->close());
}

void requireColour(const Number3& c, double r, double g, double b, double tolerance = kRounding) {
  REQUIRE(c.x == Approx(r).margin(tolerance));
  REQUIRE(c.y == Approx(g).margin(tolerance));
  REQUIRE(c.z == Approx(b).margin(tolerance));
}

}  // namespace

TEST_CASE("SkyFile, Defaults") {
  const bake::SkyFile file = read("[sky]\n" + kStill);
  const model::Sky& sky = file.sky;
  REQUIRE(sky.luminance.c == 24.0);  // far-cry-3
  REQUIRE(sky.luminance.b == -0.08);
  REQUIRE(sky.normalise_to_sun);
  REQUIRE(sky.intensity.at(3.0) == 1.0);
  REQUIRE(sky.ambient_saturation.at(3.0) == 1.0);
  requireColour(sky.polarising_tint.colourAt(3.0), 1, 1, 1);
  requireColour(sky.gradient_sun.texel(0, 0), 1, 1, 1, 1e-6);  // a float, normalised to luminance 1
  requireColour(sky.gradient_anti.texel(0, 0), 1, 1, 1, 1e-6);
  requireColour(sky.ground_albedo, 0, 0, 0);
  REQUIRE(sky.luminance_unit == 1.0);
  REQUIRE(sky.sun.illuminance.at(12.0) == 0.0);
  requireColour(sky.sun.colour.colourAt(12.0), 1, 1, 1);
  REQUIRE(sky.sun.disc_radius_rad == Approx(0.27 * kDegree).margin(kRounding));
  REQUIRE_FALSE(sky.moon);
  REQUIRE(file.bake.bands == 2);
  REQUIRE(file.bake.key_time_h.size() == bake::kAutoKeys);
  REQUIRE(file.bake.key_time_h[1] == Approx(1.0 / 12.0).margin(kRounding));
  REQUIRE(file.bake.cubemap_size == 128);
  REQUIRE(file.bake.cubemap_time_h == std::vector<double>{0, 3, 6, 9, 12, 15, 18, 21});
}

TEST_CASE("SkyFile, AFileThatStatesNoBakeHasTheDefaultBudget") {
  const auto budgetOf = [](const std::string& keys) {
    return read("[sky]\n" + kStill + "[bake]\n" + keys).bake.max_error;
  };
  REQUIRE(budgetOf("") == 0.03);
  REQUIRE(budgetOf("bands = \"auto\"\nwindow = \"off\"\ncubemap_error = 0.2") == 0.03);
  REQUIRE(budgetOf("max_error = 0.5\nbands = 3") == 0.5);
  for (const char* stated :
       {"bands = 2", "keys = 288", "cubemap_size = 0", "cubemap_times = 8", "encoding = \"float32\"",
        "gradient_format = \"rgb32f\"", "reconstruction = \"fitted\"", "window = \"mildest\""}) {
    INFO(stated);
    REQUIRE_FALSE(budgetOf(stated));
  }
}

TEST_CASE("SkyFile, SkyKeys") {
  const bake::SkyFile file = read(R"([sky]
luminance = "cie-12"
normalise = "zenith"
intensity = [[0, 1], [6, 2.5]]
gradient_sun = [2, 2, 2]
gradient_anti = [1, 0.5, 0]
polarising_tint = [[0, [1, 2, 3]], [12, [3, 2, 1]]]
ambient_saturation = [[6, 0.25], [18, 0.75]]
ground_albedo = [0.1, 0.2, 0.3]
luminance_unit = 4000
)" + kStill);
  const model::Sky& sky = file.sky;
  const model::LuminanceModel& m = sky.luminance;
  REQUIRE(std::vector<double>{m.a, m.b, m.c, m.d, m.e, m.k} == std::vector<double>{-1, -0.32, 10, -3, 0.45, 0});
  REQUIRE_FALSE(sky.normalise_to_sun);
  REQUIRE(sky.intensity.at(3.0) == Approx(1.75).margin(kRounding));
  requireColour(sky.gradient_sun.texel(0, 0), 1, 1, 1, 1e-6);          // the brightest luminance becomes 1 ...
  requireColour(sky.gradient_anti.texel(0, 0), 0.5, 0.25, 0.0, 1e-6);  // ... and the other keeps its ratio
  requireColour(sky.polarising_tint.colourAt(6.0), 2, 2, 2);
  REQUIRE(sky.ambient_saturation.at(0.0) == Approx(0.5).margin(kRounding));  // over midnight
  requireColour(sky.ground_albedo, 0.1, 0.2, 0.3);
  REQUIRE(sky.luminance_unit == 4000.0);
}

TEST_CASE("SkyFile, FreeCoefficients") {
  const model::LuminanceModel m = read("[sky]\nluminance = [-1, -0.5, 3, -2, 0.25]\n" + kStill).sky.luminance;
  REQUIRE(std::vector<double>{m.a, m.b, m.c, m.d, m.e, m.k} == std::vector<double>{-1, -0.5, 3, -2, 0.25, 0});
}

TEST_CASE("SkyFile, SunByPlaceAndDay") {
  const auto sunOf = [](const std::string& more) {
    return read("[sky]\n[sun]\nlatitude_deg = 17\nyear = 2012\nday_of_year = 172\n" + more).sky.sun.path;
  };
  const model::LightPath greenwich = sunOf("");
  REQUIRE(greenwich.key_time_h.empty());
  REQUIRE(greenwich.latitude_rad == Approx(17 * kDegree).margin(kRounding));
  REQUIRE(greenwich.declination_rad == Approx(23.44 * kDegree).margin(0.02 * kDegree));  // the solstice of 2012
  REQUIRE(greenwich.transit_h == Approx(12.0).margin(0.05));                             // equation of time: 2 minutes
  const double cycle = greenwich.transit_h;
  REQUIRE(sunOf("longitude_deg = 30").transit_h == Approx(cycle).margin(1e-3));  // the clock follows the longitude
  REQUIRE(sunOf("longitude_deg = 30\nutc_offset_h = 3").transit_h == Approx(cycle + 1).margin(1e-3));
  REQUIRE(sunOf("utc_offset_h = -2").transit_h == Approx(cycle - 2).margin(1e-3));  // the frozen instant moves by hours
  REQUIRE(sunOf("north_offset_deg = 90").north_offset_rad == Approx(90 * kDegree).margin(kRounding));
}

TEST_CASE("SkyFile, SunByHand") {
  const model::Light sun = read(R"([sky]
[sun]
path = [[6, 90, 0], [12, 180, 60]]
north_offset_deg = 10
illuminance = [[6, 0], [12, 4]]
colour = [1, 0.5, 0.25]
disc_radius_deg = 1.5
)")
                               .sky.sun;
  REQUIRE(sun.path.key_time_h == std::vector<double>{6, 12});
  REQUIRE(sun.path.key_azimuth_rad[1] == Approx(190 * kDegree).margin(kRounding));
  REQUIRE(sun.path.key_elevation_rad[1] == Approx(60 * kDegree).margin(kRounding));
  const Number3 d = sun.path.directionAt(9.0);
  const Number3 expected = det::directionOf(145 * kDegree, 30 * kDegree);
  requireColour(d, expected.x, expected.y, expected.z);
  REQUIRE(sun.illuminance.at(9.0) == Approx(2.0).margin(kRounding));
  requireColour(sun.colour.colourAt(9.0), 1, 0.5, 0.25);
  REQUIRE(sun.disc_radius_rad == Approx(1.5 * kDegree).margin(kRounding));
}

TEST_CASE("SkyFile, MoonByHandOrByPhase") {
  const std::string place = "[sky]\n[sun]\nlatitude_deg = 17\nday_of_year = 172\nnorth_offset_deg = 5\n";
  const bake::SkyFile by_phase = read(place + "[moon]\ndeclination_deg = -20\nphase = 0.5\nilluminance = 0.1\n");
  REQUIRE(by_phase.sky.moon);
  const model::LightPath& moon = by_phase.sky.moon->path;
  const model::LightPath& sun = by_phase.sky.sun.path;
  REQUIRE(moon.latitude_rad == Approx(17 * kDegree).margin(kRounding));
  REQUIRE(moon.declination_rad == Approx(-20 * kDegree).margin(kRounding));
  REQUIRE(moon.transit_h == Approx(sun.transit_h + 12).margin(kRounding));  // full: opposite the sun
  REQUIRE(moon.north_offset_rad == Approx(5 * kDegree).margin(kRounding));
  REQUIRE(by_phase.sky.moon->illuminance.at(0.0) == 0.1);
  const bake::SkyFile by_hand = read(place + "[moon]\npath = [[0, 180, 50]]\nnorth_offset_deg = 0\n");
  REQUIRE(by_hand.sky.moon->path.key_azimuth_rad[0] == Approx(180 * kDegree).margin(kRounding));
}

TEST_CASE("SkyFile, BakeKeys") {
  const auto bakeOf = [](const std::string& text) { return read("[sky]\n" + kStill + "[bake]\n" + text).bake; };
  const bake::BakeSettings counted = bakeOf("bands = 5\nkeys = 4\ncubemap_size = 16\ncubemap_times = 3");
  REQUIRE(counted.bands == 5);
  REQUIRE(counted.key_time_h == std::vector<double>{0, 6, 12, 18});
  REQUIRE(counted.cubemap_size == 16);
  REQUIRE(counted.cubemap_time_h == std::vector<double>{0, 8, 16});
  const bake::BakeSettings listed = bakeOf("keys = [1, 2.5]\ncubemap_times = [0.25, 23]");
  REQUIRE(listed.key_time_h == std::vector<double>{1, 2.5});
  REQUIRE(listed.cubemap_time_h == std::vector<double>{0.25, 23});
  REQUIRE(bakeOf("keys = \"auto\"").key_time_h.size() == bake::kAutoKeys);
  REQUIRE(bakeOf("cubemap_size = 0").cubemap_time_h.empty());
}

TEST_CASE("SkyFile, GradientImagesStandOnTheHorizon") {
  const Folder folder;
  constexpr int kWidth = 4;
  constexpr int kHeight = 3;
  std::vector<float> rgb;  // from the top: the zenith first
  for (int row = 0; row < kHeight; ++row)
    for (int column = 0; column < kWidth; ++column)
      rgb.insert(rgb.end(), {static_cast<float>(column + 1), static_cast<float>(row + 1), 2.0F});
  writeExr(folder / "g.exr", kWidth, kHeight, rgb);
  const model::Sky sky = read("[sky]\ngradient_sun = \"g.exr\"\ngradient_anti = [1, 1, 1]\n" + kStill, folder).sky;
  REQUIRE(sky.gradient_sun.width == kWidth);
  REQUIRE(sky.gradient_sun.height == kHeight);
  const double brightest = 0.2126 * kWidth + 0.7152 * kHeight + 0.0722 * 2;  // becomes 1
  for (int column = 0; column < kWidth; ++column)
    for (int j = 0; j < kHeight; ++j) {
      const double r = (column + 1) / brightest;
      const double g = (kHeight - j) / brightest;  // the file's last row is the horizon's
      requireColour(sky.gradient_sun.texel(column, j), r, g, 2 / brightest, 1e-6);
      // Texels are centred on (column + 1/2) / width of the day and (j + 1/2) / height of a quarter turn.
      const model::GradientColumn at = model::columnAt(sky.gradient_sun, 24.0 * (column + 0.5) / kWidth);
      requireColour(at.at((j + 0.5) / kHeight * det::kHalfPi), r, g, 2 / brightest, 1e-6);
    }
}

TEST_CASE("SkyFile, TintImageIsAStripOverTheDay") {
  const Folder folder;
  std::vector<float> rgb;
  for (int row = 0; row < 2; ++row)
    for (int column = 0; column < 4; ++column)
      rgb.insert(rgb.end(), {static_cast<float>(column), static_cast<float>(row), 1.0F});
  writeExr(folder / "t.exr", 4, 2, rgb);
  const base::Curve tint = read("[sky]\npolarising_tint = \"t.exr\"\n" + kStill, folder).sky.polarising_tint;
  REQUIRE(tint.time_h == std::vector<double>{3, 9, 15, 21});
  requireColour(tint.colourAt(9.0), 1, 0.5, 1);  // rows are averaged
  requireColour(tint.colourAt(12.0), 1.5, 0.5, 1);
  requireColour(tint.colourAt(0.0), 1.5, 0.5, 1);  // between the last column and the first
}

TEST_CASE("SkyFile, InputsAreNamedAsWrittenAndHashedOnce") {
  const Folder folder;
  writeExr(folder / "g.exr", 1, 1, {1, 1, 1});
  const std::string text = "[sky]\ngradient_sun = \"g.exr\"\ngradient_anti = \"g.exr\"\n" + kStill;
  const bake::SkyFile file = read(text, folder);
  REQUIRE(file.inputs.size() == 2);
  REQUIRE(file.inputs[0].name == "sky.toml");
  REQUIRE(file.inputs[1].name == "g.exr");
  REQUIRE(file.inputs[1].path == folder.path() / "g.exr");
  const bake::SkyFile changed = read(text + "# a comment\n", folder);
  REQUIRE(changed.inputs[0].xxh3_low == file.inputs[0].xxh3_low);
  REQUIRE(changed.inputs[0].xxh3_high == file.inputs[0].xxh3_high);
  const bake::SkyFile other = read("[sky]\nintensity = 0.5\n" + text.substr(6), folder);
  REQUIRE(other.inputs[0].xxh3_low != file.inputs[0].xxh3_low);
  REQUIRE(changed.inputs[1].xxh3_low == file.inputs[1].xxh3_low);
  REQUIRE(changed.inputs[1].xxh3_high == file.inputs[1].xxh3_high);
  REQUIRE(file.settings == changed.settings);  // a comment is no setting
  REQUIRE(file.settings.find("\"g.exr\"") != std::string::npos);
}

TEST_CASE("SkyFile, SettingsAreJsonForAnyName") {
  const Folder folder;
  writeExr(folder / "a.exr", 1, 1, {1.0F, 1.0F, 1.0F});
  std::filesystem::copy_file(folder / "a.exr", folder / "\U0001f305.exr");
  const bake::SkyFile file = read("[sky]\ngradient_sun = \"\U0001f305.exr\"\nintensity = 0.5\n" + kStill, folder);
  const nlohmann::json settings = nlohmann::json::parse(file.settings);
  CHECK(settings["sky"]["gradient_sun"] == "\U0001f305.exr");
  CHECK(settings["sky"]["intensity"] == 0.5);
  CHECK(settings["sun"]["path"] == nlohmann::json::parse("[[0, 0, 45]]"));
}

TEST_CASE("SkyFile, ErrorsCarryTheirStatus") {
  const auto statusOf = [](const std::string& path) {
    try {
      bake::readSkyFile(path);
    } catch (const base::Error& e) {
      return e.status();
    }
    return base::ExitStatus::done;
  };
  const Folder folder;
  REQUIRE(statusOf(folder / "none.toml") == base::ExitStatus::file);
  REQUIRE(statusOf(folder.write("a.toml", "[sky]\nwrong = 1\n" + kStill)) == base::ExitStatus::content);
  REQUIRE(statusOf(folder.write("b.toml", "[sky]\n" + kStill)) == base::ExitStatus::done);
}

}  // namespace welkin::tests
