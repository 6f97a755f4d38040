// SPDX-License-Identifier: Apache-2.0
// Cubemaps: the direction of every texel, its content, and EXR files as other programs read them.
#include "sky/cubemap/cubemap.h"

#include <Imath/half.h>
#include <OpenEXR/ImfEnvmap.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfRgbaFile.h>
#include <OpenEXR/ImfStandardAttributes.h>

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "sky/base/atomic_file.h"
#include "sky/cubemap/exr.h"
#include "tests/folder.h"

namespace welkin::tests {

using det::Number3;
namespace {

model::Sky clearSky(double azimuth_rad, double elevation_rad) {
  model::Sky sky;
  sky.luminance = *model::findLuminance("cie-12");
  sky.sun.path.key_time_h = {0.0};
  sky.sun.path.key_azimuth_rad = {azimuth_rad};
  sky.sun.path.key_elevation_rad = {elevation_rad};
  return sky;
}

float value(const cubemap::DomeImage& image, int column, int row, int channel) {
  Imath::half h;
  h.setBits(image.rgb_half[(static_cast<std::size_t>(row) * static_cast<std::size_t>(image.extent.width) +
                            static_cast<std::size_t>(column)) *
                               3 +
                           static_cast<std::size_t>(channel)]);
  return h;
}

double angle(const Number3& a, const Imath::V3f& b) {
  return f64::angleBetween(a, Number3(double{b.x}, double{b.y}, double{b.z}) / double{b.length()});
}

TEST_CASE("CubemapTexel, VulkanFaceSelection") {
  // Vulkan 1.3, "Cube Map Face Selection": (face, s right, t down) of the six axes and of one corner each.
  const Number3 centre[6] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  const Number3 right[6] = {{0, 0, -1}, {0, 0, 1}, {1, 0, 0}, {1, 0, 0}, {1, 0, 0}, {-1, 0, 0}};
  const Number3 down[6] = {{0, -1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}, {0, -1, 0}, {0, -1, 0}};
  for (int face = 0; face < 6; ++face) {
    const Number3 c = cubemap::directionOfTexel(cubemap::Layout::vulkan_cube, 3, 1, 3 * face + 1);
    CHECK(dot(c, centre[face]) == Approx(1.0));
    const Number3 d = cubemap::directionOfTexel(cubemap::Layout::vulkan_cube, 4, 3,
                                                4 * face);  // top right, centre at s = 3/4, t = -3/4
    CAPTURE(face);
    CHECK(dot(d, right[face]) / dot(d, centre[face]) == Approx(0.75));
    CHECK(dot(d, down[face]) / dot(d, centre[face]) == Approx(-0.75));
  }
}

TEST_CASE("CubemapTexel, OpenExrDirections") {
  constexpr double kFloat = 1e-6;  // OpenEXR computes in float
  constexpr int kSize = 9;
  const Imath::Box2i cube({0, 0}, {kSize - 1, 6 * kSize - 1});
  for (int row = 0; row < 6 * kSize; ++row)
    for (int column = 0; column < kSize; ++column) {
      const auto face = static_cast<Imf::CubeMapFace>(row / kSize);
      const auto d =
          Imf::CubeMap::direction(face, cube, Imath::V2f(static_cast<float>(column), static_cast<float>(row % kSize)));
      // OpenEXR's positions are relative to the face; its own function tells where that is in the file.
      const auto place = Imf::CubeMap::pixelPosition(
          face, cube, Imath::V2f(static_cast<float>(column), static_cast<float>(row % kSize)));
      CAPTURE(row, column);
      REQUIRE(angle(cubemap::directionOfTexel(cubemap::Layout::exr_cube, kSize, static_cast<int>(place.x),
                                              static_cast<int>(place.y)),
                    d) < kFloat);
    }
  const cubemap::Extent extent = cubemap::extentOf(cubemap::Layout::exr_latlong, kSize);
  const Imath::Box2i latlong({0, 0}, {extent.width - 1, extent.height - 1});
  for (int row = 0; row < extent.height; ++row)
    for (int column = 0; column < extent.width; ++column) {
      const auto d =
          Imf::LatLongMap::direction(latlong, Imath::V2f(static_cast<float>(column), static_cast<float>(row)));
      CAPTURE(row, column);
      REQUIRE(angle(cubemap::directionOfTexel(cubemap::Layout::exr_latlong, kSize, column, row), d) < kFloat);
    }
}

TEST_CASE("CubemapTexel, SixColourCubeGivesTheAxes") {
  // Faces +x -x +y -y +z -z of radiance 1..6: the linear coefficients are the differences of opposite faces, in the
  // order y, z, x, with one factor: the integral of the axis over a face.
  constexpr int kSize = 64;
  for (const cubemap::Layout layout : {cubemap::Layout::vulkan_cube, cubemap::Layout::exr_cube}) {
    std::array<double, 9> sum{};
    for (int row = 0; row < 6 * kSize; ++row)
      for (int column = 0; column < kSize; ++column) {
        const Number3 d = cubemap::directionOfTexel(layout, kSize, column, row);
        const double along = std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
        const double area = along * along * along;  // of the texel, seen from the centre; a common factor is left out
        const auto basis = f64::shBasis(d);
        for (std::size_t i = 0; i < 9; ++i) sum[i] += (1.0 + row / kSize) * area * basis.v[i];
      }
    CAPTURE(int(layout));
    const double unit = sum[3] / (1.0 - 2.0);
    CHECK(unit > 0.0);
    CHECK(sum[1] / unit == Approx(3.0 - 4.0).epsilon(1e-10));
    CHECK(sum[2] / unit == Approx(5.0 - 6.0).epsilon(1e-10));
    CHECK(sum[4] / unit == Approx(0.0).margin(1e-10));
    // 3 z^2 - 1 and x^2 - y^2 tell which pair of faces is brightest.
    CHECK(sum[6] > 0.0);
    CHECK(sum[8] < 0.0);
  }
}

TEST_CASE("Cubemap, SunIsWhereTheSunIs") {
  // The brightest texel of every layout looks at the sun, for a sun in every quarter.
  for (const double azimuth : {0.3, 2.0, 3.6, 5.5}) {
    const model::Sky sky = clearSky(azimuth, 0.5);
    const model::SkyInstant instant(sky, 0.0);
    for (const cubemap::Layout layout :
         {cubemap::Layout::vulkan_cube, cubemap::Layout::exr_cube, cubemap::Layout::exr_latlong}) {
      const auto image = cubemap::renderDome(instant, Number3(0.0), layout, 32);
      int best_row = 0;
      int best_column = 0;
      for (int row = 0; row < image.extent.height; ++row)
        for (int column = 0; column < image.extent.width; ++column)
          if (value(image, column, row, 1) > value(image, best_column, best_row, 1))
            best_row = row, best_column = column;
      const double off =
          f64::angleBetween(cubemap::directionOfTexel(layout, 32, best_column, best_row), instant.sunDirection());
      CAPTURE(azimuth, int(layout));
      CHECK(off < 0.05);  // half a texel's diagonal
    }
  }
}

TEST_CASE("Cubemap, ProjectsBackToTheTable") {
  // A double sum over texels weighted by solid angle; the half floats' rounding averages out.
  constexpr int kSize = 128;
  constexpr double kTexel = 2e-4;  // midpoint rule at the cusp and the horizon at this size, of c0
  model::Sky sky = clearSky(0.8, 0.6);
  sky.gradient_sun = model::Gradient::constant({0.9, 0.6, 0.3});
  sky.gradient_anti = model::Gradient::constant({0.2, 0.4, 0.9});
  model::normalise(sky.gradient_sun, sky.gradient_anti);
  const model::SkyInstant instant(sky, 0.0);
  const auto moments = model::SkyProjector(instant.sky().luminance, 5).project(instant);
  const auto image = cubemap::renderDome(instant, Number3(0.0), cubemap::Layout::vulkan_cube, kSize);
  std::array<Number3, 25> sum{};
  for (int row = 0; row < 6 * kSize; ++row)
    for (int column = 0; column < kSize; ++column) {
      const double s = (2.0 * column + 1.0) / kSize - 1.0;
      const double t = (2.0 * (row % kSize) + 1.0) / kSize - 1.0;
      const double area = 4.0 / (kSize * kSize) / std::pow(1.0 + s * s + t * t, 1.5);
      const auto basis = f64::shBasis(cubemap::directionOfTexel(cubemap::Layout::vulkan_cube, kSize, column, row));
      const Number3 texel(double{value(image, column, row, 0)}, double{value(image, column, row, 1)},
                          double{value(image, column, row, 2)});
      for (std::size_t i = 0; i < 25; ++i) sum[i] += texel * (basis.v[i] * area);
    }
  for (std::size_t i = 0; i < 25; ++i)
    for (int c = 0; c < 3; ++c) {
      CAPTURE(i, c);
      CHECK(sum[i][c] == Approx(moments.radiance_sh[i][c]).margin(kTexel * moments.radiance_sh[0][c]));
    }
}

TEST_CASE("Cubemap, TintAboveTheHorizonGroundBelow") {
  model::Sky sky = clearSky(0.0, 0.7);
  sky.polarising_tint = base::Curve::constant(Number3(0.5, 0.25, 2.0));
  sky.intensity = base::Curve::constant(3.0);
  const model::SkyInstant instant(sky, 0.0);
  const auto image = cubemap::renderDome(instant, Number3(0.125, 0.25, 0.5), cubemap::Layout::vulkan_cube, 4);
  for (int row = 12; row < 16; ++row)  // face -y
    CHECK(value(image, 1, row, 2) == 0.5F);
  const Number3 up = cubemap::directionOfTexel(cubemap::Layout::vulkan_cube, 4, 1, 9);
  const double radiance = 3.0 * instant.luminance(up);
  constexpr double kHalf = 1.0 / 1024.0;  // a step of a half float
  CHECK(double{value(image, 1, 9, 0)} == Approx(0.5 * radiance).epsilon(kHalf));
  CHECK(double{value(image, 1, 9, 2)} == Approx(2.0 * radiance).epsilon(kHalf));
}

TEST_CASE("Cubemap, SaturatesAndCounts") {
  model::Sky sky = clearSky(0.0, 0.7);
  sky.intensity =
      base::Curve::constant(65504.0 * 4.0);  // the luminance is 1 at the sun: a part of the dome is past half
  const auto image = cubemap::renderDome(model::SkyInstant(sky, 0.0), Number3(0.0), cubemap::Layout::exr_latlong, 16);
  std::size_t at_limit = 0;
  for (int row = 0; row < image.extent.height; ++row)
    for (int column = 0; column < image.extent.width; ++column)
      for (int c = 0; c < 3; ++c) {
        REQUIRE(std::isfinite(value(image, column, row, c)));
        if (value(image, column, row, c) == 65504.0F) ++at_limit;
      }
  CHECK(image.saturated > 0);
  CHECK(at_limit >= image.saturated);
}

TEST_CASE("Exr, HeaderSaysWhatIsInIt") {
  const Folder folder;
  const model::Sky sky = clearSky(0.0, 0.7);
  const auto image = cubemap::renderDome(model::SkyInstant(sky, 0.0), Number3(0.0), cubemap::Layout::exr_latlong, 8);
  const auto path = std::filesystem::path(folder / "latlong.exr");
  base::writeFile(path, cubemap::encodeExr(image, cubemap::Layout::exr_latlong, 4000.0));
  Imf::InputFile file(path.c_str());
  CHECK(Imf::envmap(file.header()) == Imf::ENVMAP_LATLONG);
  CHECK(Imf::whiteLuminance(file.header()) == 4000.0F);
  CHECK(Imf::chromaticities(file.header()).red == Imf::Chromaticities().red);
  CHECK(file.header().find("capDate") == file.header().end());
  CHECK_FALSE(file.header().hasTileDescription());
}

TEST_CASE("Exr, CubeAgreesWithLatlongThroughExrenvmap") {
  // OpenEXR's own converter makes a cube of our latlong; it must be our cube.
  if (std::system("exrenvmap -h >/dev/null 2>&1; test $? -ne 127") != 0)
    FAIL("exrenvmap is missing: tools/setup.sh installs it");
  constexpr int kSize = 64;
  const Folder folder;
  const model::Sky sky = clearSky(0.8, 0.9);
  const model::SkyInstant instant(sky, 0.0);
  const Number3 ground(0.2);
  const auto latlong = folder / "latlong.exr";
  const auto cube = folder / "cube.exr";
  base::writeFile(latlong,
                  cubemap::encodeExr(cubemap::renderDome(instant, ground, cubemap::Layout::exr_latlong, 4 * kSize),
                                     cubemap::Layout::exr_latlong, 1.0));
  const std::string command = "exrenvmap -c -w " + std::to_string(kSize) + " -f 0.1 1 " + latlong + " " + cube;
  REQUIRE(std::system(command.c_str()) == 0);
  Imf::RgbaInputFile file(cube.c_str());
  const auto window = file.dataWindow();
  REQUIRE(window.max.x == kSize - 1);
  std::vector<Imf::Rgba> texel(static_cast<std::size_t>(kSize) * 6 * kSize);
  file.setFrameBuffer(texel.data(), 1, kSize);
  file.readPixels(0, 6 * kSize - 1);
  const auto ours = cubemap::renderDome(instant, ground, cubemap::Layout::exr_cube, kSize);
  for (int row = 0; row < 6 * kSize; ++row)
    for (int column = 0; column < kSize; ++column) {
      const double y = cubemap::directionOfTexel(cubemap::Layout::exr_cube, kSize, column, row).y;
      if (std::abs(y) < 0.02) continue;  // the filter crosses the step at the horizon
      const double want = double{value(ours, column, row, 1)};
      const double got = double{static_cast<float>(texel[static_cast<std::size_t>(row * kSize + column)].g)};
      CAPTURE(row, column, y);
      REQUIRE(got == Approx(want).epsilon(0.02));  // bilinear filter of a sky that changes by that over a texel
    }
}

TEST_CASE("Dome, ByTheTableIsTheExactOne") {
  // The table's error, times c over the least indicatrix, 0.05 for this model. The sun itself and its antipode are
  // included.
  model::Sky sky;
  sky.sun.path.key_time_h = {0.0};
  sky.sun.path.key_azimuth_rad = {0.7};
  sky.sun.path.key_elevation_rad = {0.4};
  const model::SkyInstant instant(sky, 0.0);
  const model::IndicatrixTable table(sky.luminance.d);
  const double bound = model::IndicatrixTable::kError * sky.luminance.c / 0.05;
  std::vector<Number3> directions = {instant.sunDirection(), {0, 1, 0}, {1, 0, 0}, {0, -0.6, 0.8}};
  for (int row = 0; row < 32; ++row)
    for (int column = 0; column < 64; ++column)
      directions.push_back(cubemap::directionOfTexel(cubemap::Layout::exr_latlong, 16, column, row));
  for (const Number3& d : directions) {
    const auto exact = instant.dome(d, Number3(0.25));
    const auto quick = instant.dome(d, Number3(0.25), &table);
    CAPTURE(d.x, d.y, d.z);
    for (int c = 0; c < 3; ++c) CHECK(quick[c] == Approx(exact[c]).epsilon(bound));
  }
}

}  // namespace
}  // namespace welkin::tests
