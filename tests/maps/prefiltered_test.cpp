// SPDX-License-Identifier: Apache-2.0
// Prefiltered chains: each engine finds the lobe's mean where it looks, and other programs read the mips.
#include "maps/prefiltered.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "engine_lookup.h"
#include "format/half.h"
#include "map_sky.h"
#include "maps/dds.h"
#include "maps/encoded_cube.h"
#include "maps/ktx2.h"
#include "sky/reflection/lobe_reference.h"
#include "tests/folder.h"

namespace welkin::tests {
namespace {

/// docs/export.md states it.
constexpr double kStatedError = 2e-3;

std::string bytesAsText(const std::vector<std::byte>& bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::vector<maps::Map> mapsOf(const std::vector<maps::PrefilteredMip>& chain) {
  std::vector<maps::Map> levels;
  for (const maps::PrefilteredMip& mip : chain) levels.push_back(mip.map);
  return levels;
}

const float* texelOfMip(const maps::Map& map, int column, int row) {
  return map.rgb.data() + 3 * (row * map.width + column);
}

}  // namespace

TEST_CASE("Prefiltered, EnginesFindTheLobesMeanWhereTheyLook") {
  const MapSky sky;
  for (const EngineLookup& lookup : engineLookups()) {
    const std::string engine = lookup.engine;
    if (engine == "godot" || engine == "filament") continue;  // as Welkin's own
    const maps::Orientation orientation = maps::orientationOf(engine).value_or(maps::welkinOrientation());
    const auto chain = maps::prefilter(sky.get(), sky.sample, orientation, maps::Projection::cube, 4);
    REQUIRE(chain.size() == 3);
    const maps::Light dome = maps::domeOf(sky.get(), sky.sample);
    for (std::size_t k = 0; k < chain.size(); ++k) {
      const maps::Map& map = chain[k].map;
      const int size = 4 >> k;
      CHECK(chain[k].gloss == 1.0 - static_cast<double>(k) / 2.0);
      CHECK(chain[k].power == Approx(std::exp2(13.0 * chain[k].gloss)));
      CHECK(chain[k].error < kStatedError);
      CHECK(chain[k].error > 0.0);
      REQUIRE(map.width == size);
      REQUIRE(map.height == 6 * size);
      for (int face = 0; face < 6; ++face) {
        const int column = face % size, row = face / 2 % size;
        const det::Number3 axis = maps::cubeDirection(orientation, face, (column + 0.5) / size, (row + 0.5) / size);
        const CubePlace place = lookup.cube(axis);
        REQUIRE(place.face == face);
        REQUIRE(place.s * size == Approx(column + 0.5));
        REQUIRE(place.t * size == Approx(row + 0.5));
        const det::Number3 expected = reflection::lobeReference(dome, chain[k].power, axis, {12, 16});
        const float* texel = texelOfMip(map, column, face * size + row);
        CAPTURE(engine, k, face);
        for (int c = 0; c < 3; ++c)
          CHECK(std::abs(double{texel[c]} - expected[c]) <
                kStatedError * std::max({expected.x, expected.y, expected.z}));
      }
    }
  }
}

TEST_CASE("Prefiltered, LatlongsHoldTheSame") {
  const MapSky sky;
  const maps::Orientation orientation = *maps::orientationOf("unity");
  const auto chain = maps::prefilter(sky.get(), sky.sample, orientation, maps::Projection::latlong, 2);
  REQUIRE(chain.size() == 2);
  CHECK(chain[0].map.width == 8);
  CHECK(chain[1].map.width == 4);
  CHECK(chain[1].map.height == 2);
  const maps::Light dome = maps::domeOf(sky.get(), sky.sample);
  for (int column = 0; column < 4; ++column) {
    const det::Number3 axis = maps::latlongDirection(orientation, (column + 0.5) / 4, 0.25);
    const det::Number3 expected = reflection::lobeReference(dome, 1.0, axis, {12, 16});
    for (int c = 0; c < 3; ++c)
      CHECK(double{texelOfMip(chain[1].map, column, 0)[c]} == Approx(expected[c]).epsilon(kStatedError));
  }
}

TEST_CASE("Prefiltered, OpenImageIoReadsTheLargestMipOfDds") {
  // It reads no smaller mips of cubes: it gives the largest one's size for them. Each mip is the largest of a file
  // here.
  const MapSky sky;
  const auto chain = maps::prefilter(sky.get(), sky.sample, maps::welkinOrientation(), maps::Projection::cube, 8);
  const Folder folder;
  for (std::size_t k = 0; k < 2; ++k) {  // smaller mips have no whole block
    std::vector<maps::Map> levels = mapsOf(chain);
    levels.erase(levels.begin(), levels.begin() + static_cast<std::ptrdiff_t>(k));
    const std::string path =
        folder.write("sky.dds", bytesAsText(maps::encodeDds(maps::encodeLevels(levels, maps::Format::bc6h))));
    const auto file = OIIO::ImageInput::open(path);
    REQUIRE(file != nullptr);
    const maps::Map& map = chain[k].map;
    REQUIRE(file->spec().width == map.width);
    REQUIRE(file->spec().height == map.height);
    std::vector<float> texels(map.rgb.size());
    REQUIRE(file->read_image(0, 0, 0, 3, OIIO::TypeDesc::FLOAT, texels.data()));
    // Blocks of both sky and ground have colours on no one line.
    double sum = 0.0;
    for (std::size_t i = 0; i < texels.size(); ++i) {
      const float* rgb = map.rgb.data() + i / 3 * 3;
      sum += std::abs(double{texels[i]} - double{map.rgb[i]}) / double{std::max({rgb[0], rgb[1], rgb[2]})};
    }
    CAPTURE(k, sum / static_cast<double>(texels.size()));
    CHECK(sum / static_cast<double>(texels.size()) < 0.05);
  }
}

TEST_CASE("Prefiltered, KtxParseReadsEveryMip") {
  if (!std::filesystem::exists(WELKIN_KTX_PARSE) || std::system("node --version >/dev/null 2>&1") != 0) {
    WARN("skipped: node or ktx-parse is missing; tools/setup.sh --tests fetches ktx-parse by npm");
    return;
  }
  const MapSky sky;
  const auto chain = maps::prefilter(sky.get(), sky.sample, maps::welkinOrientation(), maps::Projection::cube, 4);
  const Folder folder;
  const std::string path =
      folder.write("sky.ktx2", bytesAsText(maps::encodeKtx2(maps::encodeLevels(mapsOf(chain), maps::Format::rgba16f))));
  const std::string command =
      std::string("node ") + WELKIN_READ_KTX2 + " " + WELKIN_KTX_PARSE + " " + path + " > " + folder / "read.json";
  REQUIRE(std::system(command.c_str()) == 0);
  const auto read = nlohmann::json::parse(readBytes(folder / "read.json"));
  REQUIRE(read["levels"].size() == chain.size());
  for (std::size_t k = 0; k < chain.size(); ++k) {
    const std::string hex = read["levels"][k];
    const maps::Map& map = chain[k].map;
    REQUIRE(hex.size() == map.rgb.size() / 3 * 16);
    for (std::size_t i = 0; i < map.rgb.size(); ++i) {
      const std::string half = hex.substr(i / 3 * 16 + i % 3 * 4, 4);  // little-endian
      const auto bits = static_cast<std::uint16_t>(std::stoul(half.substr(2, 2) + half.substr(0, 2), nullptr, 16));
      REQUIRE(double{format::floatFromHalf(bits)} == Approx(double{map.rgb[i]}).epsilon(std::ldexp(1.0, -11)));
    }
  }
}

TEST_CASE("Prefiltered, JsonTellsGlossAndError") {
  std::vector<maps::PrefilteredMip> chain(2);
  chain[0] = {{2, 12, {}}, 1.0, 8192.0, 1e-4};
  chain[1] = {{1, 6, {}}, 0.0, 1.0, 2e-4};
  const auto json = nlohmann::json::parse(maps::prefilterJson(chain, 6.5));
  CHECK(json["time_h"] == 6.5);
  CHECK(json["mips"].size() == 2);
  CHECK(json["mips"][0]["gloss"] == 1.0);
  CHECK(json["mips"][0]["power"] == 8192.0);
  CHECK(json["mips"][1]["error"] == 2e-4);
  CHECK(json["mips"][1]["height"] == 6);
}

}  // namespace welkin::tests
