// SPDX-License-Identifier: Apache-2.0
// KTX2 and DDS files, field by field as their specifications have them, and as other programs read them.
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "format/half.h"
#include "map_sky.h"
#include "maps/dds.h"
#include "maps/ktx2.h"
#include "tests/folder.h"

namespace welkin::tests {
namespace {

using maps::EncodedCube;
using maps::Format;

constexpr Format kFormats[] = {Format::rgba16f, Format::rgb9e5, Format::bc6h};

EncodedCube encodedSky(Format format, int size, bool mips) {
  const MapSky sky;
  return maps::encodeCube(maps::renderCube(sky.get(), sky.sample, maps::welkinOrientation(), size), format, mips);
}

/// Bytes of a face of a mip, from the format's definition.
std::size_t bytesOfFace(Format format, std::size_t size) {
  const std::size_t blocks = (size + 3) / 4;
  return format == Format::rgba16f  ? 8 * size * size
         : format == Format::rgb9e5 ? 4 * size * size
                                    : 16 * blocks * blocks;
}

std::uint64_t numberAt(const std::vector<std::byte>& file, std::size_t at, std::size_t bytes = 4) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < bytes; ++i) value |= std::to_integer<std::uint64_t>(file.at(at + i)) << (8 * i);
  return value;
}

std::vector<std::byte> part(const std::vector<std::byte>& file, std::size_t start, std::size_t size) {
  REQUIRE(start + size <= file.size());
  return {file.begin() + static_cast<std::ptrdiff_t>(start), file.begin() + static_cast<std::ptrdiff_t>(start + size)};
}

std::string hexOf(const std::vector<std::byte>& bytes) {
  std::string text;
  for (const std::byte byte : bytes) {
    text += "0123456789abcdef"[std::to_integer<unsigned>(byte) >> 4];
    text += "0123456789abcdef"[std::to_integer<unsigned>(byte) & 15];
  }
  return text;
}

std::string textOf(const std::vector<std::byte>& bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace

TEST_CASE("EncodedCube, MipsGoDownToOneTexel") {
  for (const Format format : kFormats) {
    const EncodedCube one = encodedSky(format, 12, false), all = encodedSky(format, 12, true);
    REQUIRE(one.levels.size() == 1);
    REQUIRE(all.levels.size() == 4);
    CHECK(one.levels[0] == all.levels[0]);
    const std::size_t sizes[] = {12, 6, 3, 1};
    for (std::size_t level = 0; level < 4; ++level)
      CHECK(all.levels[level].size() == 6 * bytesOfFace(format, sizes[level]));
  }
}

TEST_CASE("Ktx2, HeaderIndexAndLevelsAreTheSpecifications") {
  for (const Format format : kFormats)
    for (const bool mips : {false, true}) {
      const EncodedCube cube = encodedSky(format, 8, mips);
      const auto file = maps::encodeKtx2(cube);
      CAPTURE(maps::factsOf(format).name, mips);
      CHECK(hexOf(part(file, 0, 12)) == "ab4b5458203230bb0d0a1a0a");
      const std::uint64_t vulkan = format == Format::rgba16f ? 97 : format == Format::rgb9e5 ? 123 : 143;
      const std::uint64_t scalar = format == Format::rgba16f ? 2 : format == Format::rgb9e5 ? 4 : 1;
      const std::uint64_t header[9] = {vulkan, scalar, 8, 8, 0, 0, 6, mips ? 4U : 1U, 0};
      for (std::size_t i = 0; i < 9; ++i) CHECK(numberAt(file, 12 + 4 * i) == header[i]);
      const std::size_t descriptor = numberAt(file, 48), metadata = numberAt(file, 56);
      CHECK(descriptor == 80 + 24 * cube.levels.size());
      CHECK(numberAt(file, descriptor) == numberAt(file, 52));  // the descriptor begins with its size
      CHECK(metadata == descriptor + numberAt(file, 52));
      CHECK(textOf(part(file, metadata + 4, 18)) == std::string("KTXorientation\0rd\0", 18));
      CHECK(numberAt(file, 64, 8) == 0);
      CHECK(numberAt(file, 72, 8) == 0);
      std::size_t end = file.size();
      for (std::size_t level = 0; level < cube.levels.size(); ++level) {  // the largest is the last
        const std::size_t start = numberAt(file, 80 + 24 * level, 8), bytes = numberAt(file, 88 + 24 * level, 8);
        CHECK(numberAt(file, 96 + 24 * level, 8) == bytes);
        CHECK(start % (format == Format::bc6h ? 16 : format == Format::rgba16f ? 8 : 4) == 0);
        CHECK(start + bytes <= end);
        CHECK(end - start - bytes < 16);  // padding alone
        CHECK(part(file, start, bytes) == cube.levels[level]);
        end = start;
      }
    }
}

TEST_CASE("Ktx2, KtxParseReadsIt") {
  if (!std::filesystem::exists(WELKIN_KTX_PARSE) || std::system("node --version >/dev/null 2>&1") != 0) {
    WARN("skipped: node or ktx-parse is missing; tools/setup.sh --tests fetches ktx-parse by npm");
    return;
  }
  const Folder folder;
  for (const Format format : kFormats) {
    const EncodedCube cube = encodedSky(format, 8, true);
    const auto bytes = maps::encodeKtx2(cube);
    const std::string path = folder.write("sky.ktx2", textOf(bytes));
    const std::string command =
        std::string("node ") + WELKIN_READ_KTX2 + " " + WELKIN_KTX_PARSE + " " + path + " > " + folder / "read.json";
    REQUIRE(std::system(command.c_str()) == 0);
    const auto read = nlohmann::json::parse(readBytes(folder / "read.json"));
    CAPTURE(maps::factsOf(format).name, read.dump());
    CHECK(read["vkFormat"] == maps::factsOf(format).vulkan);
    CHECK(read["size"] == nlohmann::json({8, 8, 0}));
    CHECK(read["layers"] == 0);
    CHECK(read["faces"] == 6);
    CHECK(read["supercompression"] == 0);
    CHECK(read["primaries"] == 1);  // Rec. 709
    CHECK(read["transfer"] == 1);   // linear
    CHECK(read["values"]["KTXorientation"] == "rd");
    const bool blocks = format == Format::bc6h;
    CHECK(read["model"] == (blocks ? 133 : 1));
    CHECK(read["block"][0] == (blocks ? 3 : 0));
    CHECK(read["bytesPlane"][0] == maps::factsOf(format).block_bytes);
    CHECK(read["samples"].size() == (blocks ? 1 : format == Format::rgba16f ? 4 : 6));
    REQUIRE(read["levels"].size() == cube.levels.size());
    for (std::size_t level = 0; level < cube.levels.size(); ++level)
      CHECK(read["levels"][level] == hexOf(cube.levels[level]));
  }
}

TEST_CASE("Dds, HeaderAndFacesAreMicrosofts") {
  for (const Format format : kFormats)
    for (const bool mips : {false, true}) {
      const EncodedCube cube = encodedSky(format, 8, mips);
      const auto file = maps::encodeDds(cube);
      CAPTURE(maps::factsOf(format).name, mips);
      CHECK(textOf(part(file, 0, 4)) == "DDS ");
      CHECK(numberAt(file, 4) == 124);
      CHECK((numberAt(file, 8) & 0x1007) == 0x1007);
      CHECK(((numberAt(file, 8) & 0x20000) != 0) == mips);
      CHECK(numberAt(file, 12) == 8);
      CHECK(numberAt(file, 16) == 8);
      CHECK(numberAt(file, 28) == (mips ? 4 : 1));
      CHECK(numberAt(file, 76) == 32);
      CHECK(numberAt(file, 80) == 4);
      CHECK(textOf(part(file, 84, 4)) == "DX10");
      CHECK(numberAt(file, 108) == (mips ? 0x401008 : 0x1008));
      CHECK(numberAt(file, 112) == 0xFE00);  // a cube with all six faces
      CHECK(numberAt(file, 128) == (format == Format::rgba16f ? 10 : format == Format::rgb9e5 ? 67 : 95));
      CHECK(numberAt(file, 132) == 3);  // 2D
      CHECK(numberAt(file, 136) == 4);  // a cube
      CHECK(numberAt(file, 140) == 1);  // one cube
      std::size_t at = 148;
      for (std::size_t face = 0; face < 6; ++face)
        for (std::size_t level = 0; level < cube.levels.size(); ++level) {
          const std::size_t bytes = bytesOfFace(format, std::size_t{8} >> level);
          CHECK(part(file, at, bytes) == part(cube.levels[level], face * bytes, bytes));
          at += bytes;
        }
      CHECK(at == file.size());
    }
}

TEST_CASE("Dds, OpenImageIoReadsTheFacesAndTheBlocks") {
  // OpenImageIO reads no half floats in DDS, but BC6H. It sees a cube as six tiles, one above the other.
  constexpr int kFace = 16;
  const MapSky sky;
  const maps::Map cube = maps::renderCube(sky.get(), sky.sample, maps::welkinOrientation(), kFace);
  const Folder folder;
  const std::string path =
      folder.write("sky.dds", textOf(maps::encodeDds(maps::encodeCube(cube, Format::bc6h, false))));
  const auto file = OIIO::ImageInput::open(path);
  REQUIRE(file != nullptr);
  CHECK(file->spec().width == kFace);
  CHECK(file->spec().height == 6 * kFace);
  CHECK(file->spec().nchannels == 3);
  std::vector<float> texels(cube.rgb.size());
  REQUIRE(file->read_image(0, 0, 0, 3, OIIO::TypeDesc::FLOAT, texels.data()));
  // Relative to the texel's largest component. The sun's cusp and the horizon make the worst blocks.
  double worst = 0.0, sum = 0.0;
  for (std::size_t i = 0; i < texels.size(); ++i) {
    const float* expected = cube.rgb.data() + i / 3 * 3;
    const double largest = double{std::max({expected[0], expected[1], expected[2]})};
    const double difference = std::abs(double{texels[i]} - double{cube.rgb[i]});
    const double error = difference > 0.0 ? difference / largest : 0.0;
    worst = std::max(worst, error);
    sum += error;
  }
  CAPTURE(worst, sum / static_cast<double>(texels.size()));
  CHECK(sum / static_cast<double>(texels.size()) < 0.02);
  CHECK(worst < 0.5);
}

}  // namespace welkin::tests
