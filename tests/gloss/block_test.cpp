// SPDX-License-Identifier: Apache-2.0
// Blocks of texels: their errors, and the files as OpenImageIO decodes them.
#include <OpenImageIO/imageio.h>

#include <catch2/catch.hpp>

#include "bumps.h"
#include "gloss/block_texture.h"
#include "gloss/write_blocks.h"
#include "tests/folder.h"

namespace welkin::tests {
namespace {

std::vector<gloss::Mip> mipsOfBumps(int width, int height, double steepness) {
  gloss::GlossMap number;
  number.number = 0.8;
  return gloss::mipsOf(bumps(width, height, steepness), number);
}

/// The bumps under a gloss of noise, which no line of colours in a block follows.
std::vector<gloss::Mip> mipsUnderNoise(int size) {
  gloss::GlossMap noise;
  noise.width = noise.height = size;
  std::uint32_t random = 1;
  for (int i = 0; i < size * size; ++i) {
    random = random * 1664525U + 1013904223U;
    noise.variance.push_back(std::exp2(-13.0F * static_cast<float>(random >> 8U) / 0x1p24F));
  }
  return gloss::mipsOf(bumps(size, size, 0.5), noise);
}

struct Decoded {
  int width = 0, height = 0, channels = 0;
  std::vector<float> value;
};

Decoded decode(const std::string& path, int mip) {
  const auto file = OIIO::ImageInput::open(path);
  REQUIRE(file);
  REQUIRE(file->seek_subimage(0, mip));
  Decoded decoded{file->spec().width, file->spec().height, file->spec().nchannels, {}};
  decoded.value.resize(static_cast<std::size_t>(decoded.width * decoded.height * decoded.channels));
  REQUIRE(file->read_image(0, mip, 0, decoded.channels, OIIO::TypeDesc::FLOAT, decoded.value.data()));
  return decoded;
}

std::string written(const Folder& folder, const gloss::NamedBytes& file) {
  return folder.write(file.name, {reinterpret_cast<const char*>(file.bytes.data()), file.bytes.size()});
}

}  // namespace

TEST_CASE("Blocks, ABlockByHand") {
  const auto bytes = [](std::initializer_list<int> list) {
    std::vector<std::byte> block;
    for (const int v : list) block.push_back(static_cast<std::byte>(v));
    return block;
  };
  // 210 and 0 with indices 0 to 7: 210, 0, 180, 150, ... 30.
  const auto eight = gloss::decodeBc4(bytes({210, 0, 0x88, 0xc6, 0xfa, 0, 0, 0}).data());
  const double shares[8] = {210, 0, 180, 150, 120, 90, 60, 30};
  for (std::size_t i = 0; i < 8; ++i) REQUIRE(eight[i] * 255.0 == Approx(shares[i]).margin(1e-9));
  REQUIRE(eight[8] * 255.0 == Approx(210.0));
  const auto six = gloss::decodeBc4(bytes({0, 100, 0x88, 0xc6, 0xfa, 0, 0, 0}).data());
  const double others[8] = {0, 100, 20, 40, 60, 80, 0, 255};
  for (std::size_t i = 0; i < 8; ++i) REQUIRE(six[i] * 255.0 == Approx(others[i]).margin(1e-9));
  // Red 31 and green 0 against red 0 and green 63, with indices 0 to 3.
  const auto colours = gloss::decodeBc3Colours(bytes({0, 0xf8, 0xe0, 0x07, 0xe4, 0, 0, 0}).data());
  const double reds[4] = {1.0, 0.0, 2.0 / 3.0, 1.0 / 3.0};
  for (std::size_t i = 0; i < 4; ++i) {
    REQUIRE(colours[i].red == Approx(reds[i]).margin(1e-12));
    REQUIRE(colours[i].green == Approx(1.0 - reds[i]).margin(1e-12));
  }
}

TEST_CASE("Blocks, AGlossMapInRedCostsYAndANumberDoesNot") {
  const auto mips = mipsUnderNoise(64);
  const gloss::BlockError map = gloss::packBc3(mips, std::nullopt).error;
  const gloss::BlockError number = gloss::packBc3(mips, 0.5).error;
  const gloss::BlockError apart = gloss::packBc5(mips).error;
  REQUIRE(map.y_rms > 2.0 * number.y_rms);  // 2.6 measured
  REQUIRE(map.gloss_rms < number.gloss_rms);
  REQUIRE(number.angle_rms > apart.angle_rms);
  REQUIRE(apart.gloss_rms == 0.0);
  // 2.1 measured: the bumps are steep, and a block of a coarse mip spans most of the axis in eight steps.
  REQUIRE(apart.angle_rms < 2.5);
  REQUIRE(gloss::packBc4(mips).error.gloss_rms < map.gloss_rms);
}

TEST_CASE("Blocks, TheBudgetChoosesMapOrNumber") {
  const auto mips = mipsUnderNoise(32);
  gloss::BlockReport report;
  gloss::bc3Files("a", mips, std::nullopt, report);
  REQUIRE(report.holds_map);
  const double cost = report.with_map.angle_rms;
  gloss::bc3Files("a", mips, 1.01 * cost, report);
  REQUIRE(report.holds_map);
  const auto files = gloss::bc3Files("a", mips, 0.99 * cost, report);
  REQUIRE_FALSE(report.holds_map);
  const Folder folder;
  const Decoded decoded = decode(written(folder, files[0]), 0);
  for (std::size_t i = 0; i < decoded.value.size(); i += 4) REQUIRE(decoded.value[i] == decoded.value[0]);
}

TEST_CASE("Blocks, OpenImageIoReadsEveryMip") {
  const Folder folder;
  for (const auto& [width, height] : {std::pair(32, 16), {13, 7}}) {
    const auto mips = mipsOfBumps(width, height, 0.5);
    gloss::BlockReport report;
    const std::string bc3 = written(folder, gloss::bc3Files("three", mips, std::nullopt, report)[0]);
    const auto apart = gloss::bc5Files("five", mips, report);
    const std::string bc5 = written(folder, apart[0]), bc4 = written(folder, apart[1]);
    for (std::size_t k = 0; k < mips.size(); ++k) {
      CAPTURE(width, height, k);
      const Decoded three = decode(bc3, static_cast<int>(k)), five = decode(bc5, static_cast<int>(k)),
                    four = decode(bc4, static_cast<int>(k));
      for (const Decoded& d : {three, five, four}) {
        REQUIRE(d.width == mips[k].width);
        REQUIRE(d.height == mips[k].height);
      }
      // Six steps of five bits, and a line that gloss and y share: 0.2 is a third of what the bumps span in a block.
      for (std::size_t i = 0; i < mips[k].gloss.size(); ++i) {
        const double x = (double{mips[k].normal[3 * i]} + 1.0) / 2.0,
                     y = (double{mips[k].normal[3 * i + 1]} + 1.0) / 2.0;
        REQUIRE(double{three.value[4 * i + 3]} == Approx(x).margin(0.06));
        REQUIRE(double{three.value[4 * i + 1]} == Approx(y).margin(0.2));
        REQUIRE(double{five.value[static_cast<std::size_t>(five.channels) * i]} == Approx(x).margin(0.06));
        REQUIRE(double{five.value[static_cast<std::size_t>(five.channels) * i + 1]} == Approx(y).margin(0.06));
        REQUIRE(double{four.value[static_cast<std::size_t>(four.channels) * i]} ==
                Approx(double{mips[k].gloss[i]}).margin(0.03));
      }
    }
  }
}

}  // namespace welkin::tests
