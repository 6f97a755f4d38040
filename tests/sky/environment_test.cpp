// SPDX-License-Identifier: Apache-2.0
// Cubemaps and latlongs from files: every layout, orientation and texel rule, against a function of known coefficients.
#include "sky/cubemap/environment.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenImageIO/imageio.h>

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

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

Number3 normalised(const Number3& v) {
  return v * (1.0 / std::sqrt(dot(v, v)));
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
                               std::optional<Imf::Envmap> envmap = std::nullopt, const char* name = "a.exr",
                               const cubemap::PictureChoice& choice = {}) {
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
  return cubemap::projectImage(folder / name, 3, choice);
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
       {std::pair<std::string, std::vector<std::string>>{"vstrip", {"0", "1", "2", "3", "4", "5"}},
        {"hstrip", {"012345"}},
        {"hcross:+z+x", {".2..", "1405", ".3.."}}}) {
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
  REQUIRE(environment.layout == "vcross:+z+x");
  requireCoefficients(environment, kSize);
}

TEST_CASE("ProjectImage, AnUprightLastFaceIsToldApartByItsSeams") {
  const auto direction = [](int column, int row) { return directionOn({".2.", "140", ".3.", ".5."}, column, row); };
  const cubemap::Environment environment = projected(3 * kSize, 4 * kSize, direction);
  REQUIRE(environment.layout == "vcross:+z+x:upright");
  REQUIRE(environment.notes.size() == 2);
  requireCoefficients(environment, kSize);
}

TEST_CASE("ProjectImage, AStripInOpenExrsOrientationIsToldApartByItsSeams") {
  const cubemap::Environment environment = projected(kSize, 6 * kSize, [](int column, int row) {
    return cubemap::directionOfTexel(cubemap::Layout::exr_cube, kSize, column, row);
  });
  REQUIRE(environment.layout == "exr-cube");
  REQUIRE(environment.rule == sh::TexelRule::edge_centres);
  requireCoefficients(environment, kSize - 1);
}

TEST_CASE("ProjectImage, EveryCrossByItsName") {
  // The direction is found from the middle and right axes alone: a walk over the unfolded cube by quarter turns.
  const auto axis = [](const std::string& text) {
    const double sign = text[0] == '+' ? 1.0 : -1.0;
    return text[1] == 'x' ? Number3(sign, 0.0, 0.0) : Number3(0.0, 0.0, sign);
  };
  for (const std::string name :
       {"hcross:+z+x", "hcross:+z-x", "hcross:-z+x", "hcross:-z-x", "hcross:+x+z", "hcross:+x-z", "hcross:-x+z",
        "vcross:-z+x", "vcross:-z-x", "vcross:+x+z", "vcross:+z-x", "vcross:-x-z:upright"}) {
    INFO(name);
    const bool across = name[0] == 'h';
    const Number3 middle = axis(name.substr(7, 2)), right = axis(name.substr(9, 2)), up(0.0, 1.0, 0.0);
    const auto direction = [&](int column, int row) {
      const int i = column / kSize, j = row / kSize;
      double s = 2.0 * (column % kSize + 0.5) / kSize - 1.0, t = 2.0 * (row % kSize + 0.5) / kSize - 1.0;
      if (j == 1 && (across || i < 3)) {  // the belt: from the left -right, middle, right, -middle
        const Number3 normal = i == 0 ? right * -1.0 : i == 1 ? middle : i == 2 ? right : middle * -1.0;
        const Number3 along = i == 0 ? middle : i == 1 ? right : i == 2 ? middle * -1.0 : right * -1.0;
        return normalised(normal + along * s - up * t);
      }
      if (i != 1) return Number3(0.0);
      if (j == 0) return normalised(up + right * s + middle * t);
      if (j == 2) return normalised(up * -1.0 + right * s - middle * t);
      if (name.ends_with("upright")) s = -s, t = -t;
      return normalised(middle * -1.0 + right * s + up * t);
    };
    cubemap::PictureChoice choice;
    choice.layout = name;
    const cubemap::Environment environment = projected(across ? 4 * kSize : 3 * kSize, across ? 3 * kSize : 4 * kSize,
                                                       direction, std::nullopt, "a.exr", choice);
    REQUIRE(environment.layout == name);
    REQUIRE(environment.notes.empty());
    requireCoefficients(environment, kSize);
  }
}

TEST_CASE("ProjectImage, SixFaces") {
  const Folder folder;
  std::array<std::filesystem::path, 6> paths;
  for (int face = 0; face < 6; ++face) {
    std::vector<float> rgb;
    for (int row = 0; row < kSize; ++row)
      for (int column = 0; column < kSize; ++column) {
        const Number3 radiance =
            radianceAt(cubemap::directionOfTexel(cubemap::Layout::vulkan_cube, kSize, column, face * kSize + row));
        for (int c = 0; c < 3; ++c) rgb.push_back(static_cast<float>(radiance[c]));
      }
    paths[static_cast<std::size_t>(face)] = folder / (std::to_string(face) + ".exr");
    writeImage(paths[static_cast<std::size_t>(face)], kSize, kSize, rgb);
  }
  const cubemap::Environment environment = cubemap::projectFaces(paths, 3);
  REQUIRE(environment.layout == "faces");
  REQUIRE(environment.width == kSize);
  requireCoefficients(environment, kSize);

  writeImage(paths[4], 2, 2, std::vector<float>(12, 1.0F));
  REQUIRE_THROWS_WITH(cubemap::projectFaces(paths, 3),
                      Catch::Contains("4.exr: 2 x 2 texels: the first face has 48 x 48"));
  writeImage(paths[0], 4, 2, std::vector<float>(24, 1.0F));
  REQUIRE_THROWS_WITH(cubemap::projectFaces(paths, 3), Catch::Contains("0.exr: 4 x 2 texels: a face is square"));
}

TEST_CASE("ProjectImage, LayoutsThatDoNotFitAreRefused") {
  const auto any = [](int, int) { return Number3(0.0, 1.0, 0.0); };
  for (const char* layout : {"hcross:+z+z", "hcross:+z-z", "hcross:+y+x", "hcross:", "hcross:+z", "hcross:+z+x:upright",
                             "cross", "vcross:+z+x:", "strip"}) {
    cubemap::PictureChoice choice;
    choice.layout = layout;
    REQUIRE_THROWS_WITH(projected(12, 9, any, std::nullopt, "a.exr", choice),
                        Catch::Contains(std::string("no layout '") + layout));
  }
  for (const char* layout : {"vstrip", "hstrip", "exr-cube", "vcross:+z+x"}) {
    cubemap::PictureChoice choice;
    choice.layout = layout;
    REQUIRE_THROWS_WITH(projected(12, 9, any, std::nullopt, "a.exr", choice),
                        Catch::Contains(std::string(layout) + " is "));
  }
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
