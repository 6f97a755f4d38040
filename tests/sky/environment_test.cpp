// SPDX-License-Identifier: Apache-2.0
// Cubemaps and latlongs from files: every layout, orientation and texel rule, against a function of known coefficients.
#include "sky/cubemap/environment.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenImageIO/imageio.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <optional>

#include "sky/base/error.h"
#include "sky/cubemap/cubemap.h"
#include "tests/folder.h"

namespace welkin::tests {

using det::Number3;
namespace {

/// Nine different coefficients per channel, so that every swap, mirror and turn of faces changes some.
const double kCoefficient[9] = {3.0, 0.5, -0.7, 0.9, 0.2, -0.3, 0.4, -0.6, 0.8};

Number3 radianceAt(const Number3& d) {
  const auto basis = det::shBasis(d);
  Number3 sum(0.0);
  for (int k = 0; k < 9; ++k) sum += Number3(1.0, 2.0, k == 0 ? 3.0 : 1.5) * (kCoefficient[k] * basis.v[k]);
  return sum;
}

/// Sampling at the centres of N texels a quarter turn costs up to 2.1 / N^2 of this function (measured).
void requireCoefficients(const cubemap::Environment& environment, int size) {
  for (std::size_t k = 0; k < 9; ++k) {
    const Number3 difference = environment.radiance_sh[k] - Number3(1.0, 2.0, k == 0 ? 3.0 : 1.5) * kCoefficient[k];
    CAPTURE(environment.layout, k, difference.x, difference.y, difference.z);
    for (int c = 0; c < 3; ++c) REQUIRE(std::abs(difference[c]) < 3.0 / (size * size));
  }
}

using DirectionOf = std::function<Number3(int column, int row)>;

void writeExr(const std::string& path, int width, int height, const std::vector<float>& rgb, Imf::Envmap envmap) {
  Imf::Header header(width, height);
  Imf::addEnvmap(header, envmap);
  Imf::FrameBuffer frame;
  auto* base = const_cast<char*>(reinterpret_cast<const char*>(rgb.data()));  // only read by writePixels
  const char* names[3] = {"R", "G", "B"};
  for (std::size_t c = 0; c < 3; ++c) {
    header.channels().insert(names[c], Imf::Channel(Imf::FLOAT));
    frame.insert(names[c], Imf::Slice(Imf::FLOAT, base + c * sizeof(float), 3 * sizeof(float),
                                      3 * sizeof(float) * static_cast<std::size_t>(width)));
  }
  Imf::OutputFile file(path.c_str(), header);
  file.setFrameBuffer(frame);
  file.writePixels(height);
}

void writeImage(const std::string& path, int width, int height, const std::vector<float>& rgb) {
  auto output = OIIO::ImageOutput::create(path);
  REQUIRE(output->open(path, OIIO::ImageSpec(width, height, 3, OIIO::TypeDesc::FLOAT)));
  REQUIRE(output->write_image(OIIO::TypeDesc::FLOAT, rgb.data()));
  REQUIRE(output->close());
}

/// Writes the function seen along `direction` as floats, black where the direction is zero, and projects the picture.
cubemap::Environment projected(int width, int height, const DirectionOf& direction,
                               std::optional<Imf::Envmap> envmap = std::nullopt, const char* name = "a.exr") {
  std::vector<float> rgb;
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column) {
      const Number3 d = direction(column, row);
      const Number3 radiance = dot(d, d) > 0.0 ? radianceAt(d) : Number3(0.0);
      for (int c = 0; c < 3; ++c) rgb.push_back(static_cast<float>(radiance[c]));
    }
  const Folder folder;
  if (envmap)
    writeExr(folder / name, width, height, rgb, *envmap);
  else
    writeImage(folder / name, width, height, rgb);
  return cubemap::projectImage(folder / name, 3);
}

constexpr int kSize = 48;

/// Direction of a texel in a picture of faces. `faces` lists the lines from the left, +x = '0' ... -z = '5', '.' for no
/// face.
Number3 directionOn(const std::vector<std::string>& faces, int column, int row) {
  const char face = faces[static_cast<std::size_t>(row / kSize)][static_cast<std::size_t>(column / kSize)];
  if (face == '.') return Number3(0.0);
  return cubemap::directionOfTexel(cubemap::Layout::vulkan_cube, kSize, column % kSize,
                                   (face - '0') * kSize + row % kSize);
}

}  // namespace

TEST_CASE("ProjectImage, CubemapsWithoutAnAttribute") {
  for (const auto& [layout, faces] :
       {std::pair<std::string, std::vector<std::string>>{"strip", {"0", "1", "2", "3", "4", "5"}},
        {"strip", {"012345"}},
        {"cross", {".2..", "1405", ".3.."}}}) {
    const cubemap::Environment environment =
        projected(static_cast<int>(faces[0].size()) * kSize, static_cast<int>(faces.size()) * kSize,
                  [&, &rows = faces](int column, int row) { return directionOn(rows, column, row); });
    REQUIRE(environment.layout == layout);
    REQUIRE(environment.width == kSize);
    REQUIRE(environment.rule == sh::TexelRule::half_texel);
    requireCoefficients(environment, kSize);
  }
}

TEST_CASE("ProjectImage, TheVerticalCrossFoldsIntoACube") {
  // -z hangs below -y, upside down, so that the picture continues without a seam.
  const auto direction = [](int column, int row) {
    if (row >= 3 * kSize && column / kSize == 1)
      return cubemap::directionOfTexel(cubemap::Layout::vulkan_cube, kSize, 2 * kSize - 1 - column,
                                       5 * kSize + 4 * kSize - 1 - row);
    return directionOn({".2.", "140", ".3.", "..."}, column, row);
  };
  const Number3 above = direction(kSize + 7, 3 * kSize - 1);
  const Number3 below = direction(kSize + 7, 3 * kSize);
  REQUIRE(dot(above, below) > 0.99);
  const cubemap::Environment environment = projected(3 * kSize, 4 * kSize, direction);
  REQUIRE(environment.layout == "cross");
  requireCoefficients(environment, kSize);
}

TEST_CASE("ProjectImage, OpenExrsRuleAndOrientation") {
  const cubemap::Environment cube = projected(
      kSize, 6 * kSize,
      [](int column, int row) { return cubemap::directionOfTexel(cubemap::Layout::exr_cube, kSize, column, row); },
      Imf::ENVMAP_CUBE);
  REQUIRE(cube.layout == "cube");
  REQUIRE(cube.rule == sh::TexelRule::edge_centres);
  requireCoefficients(cube, kSize - 1);

  const cubemap::Environment latlong = projected(
      4 * kSize, 2 * kSize,
      [](int column, int row) { return cubemap::directionOfTexel(cubemap::Layout::exr_latlong, kSize, column, row); },
      Imf::ENVMAP_LATLONG);
  REQUIRE(latlong.layout == "latlong");
  REQUIRE(latlong.rule == sh::TexelRule::edge_centres);
  requireCoefficients(latlong, kSize - 1);
}

TEST_CASE("ProjectImage, LatlongByTheHalfTexelRule") {
  for (const char* name : {"a.exr", "a.tif"}) {
    const cubemap::Environment environment = projected(
        4 * kSize, 2 * kSize,
        [](int column, int row) {  // the middle column is +z, south, and +x is left of it
          const double longitude = det::kPi - det::kTwoPi * (column + 0.5) / (4 * kSize);
          const double latitude = det::kHalfPi - det::kPi * (row + 0.5) / (2 * kSize);
          return Number3(std::cos(latitude) * std::sin(longitude), std::sin(latitude),
                         std::cos(latitude) * std::cos(longitude));
        },
        std::nullopt, name);
    REQUIRE(environment.layout == "latlong");
    REQUIRE(environment.rule == sh::TexelRule::half_texel);
    requireCoefficients(environment, kSize);
  }
}

TEST_CASE("ProjectImage, NegativeValuesAreCountedAndTaken") {
  const Folder folder;
  writeImage(folder / "a.exr", 2, 1, {-1.0F, 2.0F, 3.0F, -1.0F, 2.0F, 3.0F});
  const cubemap::Environment environment = cubemap::projectImage(folder / "a.exr", 2);
  REQUIRE(environment.negative == 2);
  REQUIRE(environment.radiance_sh[0].x == Approx(-2.0 * std::sqrt(M_PI)));
  REQUIRE(environment.radiance_sh[1].z == Approx(0.0).margin(1e-12));
}

TEST_CASE("ProjectImage, OtherShapesAreRefused") {
  const auto any = [](int, int) { return Number3(0.0, 1.0, 0.0); };
  for (const auto& [width, height] : {std::pair(5, 5), {7, 6}, {6, 35}, {8, 7}})
    REQUIRE_THROWS_WITH(projected(width, height, any),
                        Catch::Contains("a latlong is 2:1, a cubemap 1:6, 6:1, 4:3 or 3:4"));
  REQUIRE_THROWS_WITH(projected(8, 6, any, Imf::ENVMAP_CUBE), Catch::Contains("six faces"));
  REQUIRE_THROWS_WITH(projected(1, 6, any, Imf::ENVMAP_CUBE), Catch::Contains("six faces of 2 or more"));
  REQUIRE_THROWS_AS(projected(1, 1, any, Imf::ENVMAP_LATLONG), base::Error);
}

}  // namespace welkin::tests
