// SPDX-License-Identifier: Apache-2.0
// Radiance pictures, and all files of an export, as OpenImageIO reads them.
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <random>

#include "map_sky.h"
#include "maps/radiance_hdr.h"
#include "maps/write_maps.h"
#include "tests/folder.h"

namespace welkin::tests {
namespace {

maps::Map readPicture(const std::string& path) {
  const auto file = OIIO::ImageInput::open(path);
  REQUIRE(file != nullptr);
  REQUIRE(file->spec().nchannels == 3);
  maps::Map map{file->spec().width, file->spec().height, {}};
  map.rgb.resize(std::size_t{3} * static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.height));
  REQUIRE(file->read_image(0, 0, 0, 3, OIIO::TypeDesc::FLOAT, map.rgb.data()));
  return map;
}

/// Largest error of a component, relative to the largest component of its texel.
double largestError(const maps::Map& map, const maps::Map& expected) {
  REQUIRE(map.width == expected.width);
  REQUIRE(map.height == expected.height);
  double worst = 0.0;
  for (std::size_t i = 0; i < map.rgb.size(); i += 3) {
    double largest = 0.0, error = 0.0;
    for (std::size_t c = i; c < i + 3; ++c) {
      largest = std::max(largest, double{expected.rgb[c]});
      error = std::max(error, std::abs(double{map.rgb[c]} - double{expected.rgb[c]}));
    }
    if (error > 0.0) worst = std::max(worst, error / largest);
  }
  return worst;
}

constexpr double kHalf = 0x1p-11;     // rounding to half floats
constexpr double kRadiance = 0x1p-8;  // rounding to 8 bits of the largest component

}  // namespace

TEST_CASE("RadianceHdr, NoiseRunsAndNarrowPicturesAreRead") {
  const Folder folder;
  std::mt19937 random(7);
  std::uniform_real_distribution<float> exponent(-20.0F, 20.0F);
  for (const int width : {1, 7, 8, 300, 1000}) {  // narrower than 8 has no runs
    maps::Map map{width, 6, {}};
    for (int i = 0; i < width * 6; ++i) {
      const bool noise = i / width < 2, black = i / width == 5;
      for (int c = 0; c < 3; ++c)
        map.rgb.push_back(black ? 0.0F : noise ? std::exp2(exponent(random)) : static_cast<float>(1 + i / 150 + c));
    }
    const maps::RadianceFile file = maps::encodeRadiance(map);
    CHECK(file.saturated == 0);
    const std::string path =
        folder.write("map.hdr", {reinterpret_cast<const char*>(file.bytes.data()), file.bytes.size()});
    CAPTURE(width);
    CHECK(largestError(readPicture(path), map) <= kRadiance);
  }
}

TEST_CASE("RadianceHdr, RoundsUpIntoTheNextExponent") {
  const Folder folder;
  const maps::Map map{1, 3, {0.999F, 0.5F, 0.0F, 255.9F, 1.0F, 2.0F, 3e38F, 1.0F, 0.0F}};
  const maps::RadianceFile file = maps::encodeRadiance(map);
  const std::string path =
      folder.write("map.hdr", {reinterpret_cast<const char*>(file.bytes.data()), file.bytes.size()});
  const maps::Map read = readPicture(path);
  CHECK(read.rgb[0] == 1.0F);  // 255.7 of 256
  CHECK(read.rgb[3] == 256.0F);
  CHECK(file.saturated == 1);
}

TEST_CASE("WriteMaps, PicturesAreReadByOpenImageIo") {
  const MapSky sky;
  const Folder folder;
  const maps::Orientation three = *maps::orientationOf("three");
  for (const auto picture : {maps::PictureFormat::exr, maps::PictureFormat::hdr}) {
    const bool exr = picture == maps::PictureFormat::exr;
    const double error = exr ? kHalf : kRadiance;
    maps::Request request;
    request.engine = three;
    request.picture = picture;
    request.size = 12;
    request.container = maps::Container::faces;
    const auto faces = maps::writeMaps(sky.get(), sky.sample, request, folder.path());
    REQUIRE(faces.size() == 7);
    const char* names[6] = {"px", "nx", "py", "ny", "pz", "nz"};
    const maps::Map cube = maps::renderCube(sky.get(), sky.sample, three, 12);
    for (int face = 0; face < 6; ++face) {
      const std::string name = std::string("sky_000000000_three_") + names[face] + (exr ? ".exr" : ".hdr");
      CHECK(faces[static_cast<std::size_t>(face)].path == folder.path() / name);
      CHECK(largestError(readPicture(folder / name), maps::faceOf(cube, face)) <= error);
    }
    request.container = maps::Container::latlong;
    const auto latlong = maps::writeMaps(sky.get(), sky.sample, request, folder.path());
    REQUIRE(latlong.size() == 2);
    CHECK(largestError(readPicture(latlong[0].path.string()), maps::renderLatlong(sky.get(), sky.sample, three, 24)) <=
          error);
  }
}

TEST_CASE("WriteMaps, JsonHasTheCoefficients") {
  const MapSky sky;
  const Folder folder;
  maps::Request request;
  request.size = 4;
  const auto files = maps::writeMaps(sky.get(), sky.sample, request, folder.path());
  REQUIRE(files.size() == 2);
  CHECK(files[0].path.filename() == "sky_000000000.ktx2");
  CHECK(files[1].path.filename() == "sky_000000000_sh.json");
  const auto json = nlohmann::json::parse(readBytes(files[1].path));
  CHECK(json["time_h"] == 0.0);
  CHECK(json["luminance_unit"] == 1.0);
  CHECK(json["bands"] == 3);
  for (std::size_t c = 0; c < 3; ++c) {
    const auto& channel = json["radiance_sh"][std::string(1, "rgb"[c])];
    REQUIRE(channel.size() == 9);
    for (std::size_t i = 0; i < 9; ++i)
      CHECK(static_cast<float>(channel[i].get<double>()) == sky.sample.radiance_sh[i][c]);
  }
}

}  // namespace welkin::tests
