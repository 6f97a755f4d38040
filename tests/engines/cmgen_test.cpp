// SPDX-License-Identifier: Apache-2.0
// Filament's cmgen reads a latlong of this library as it is: its coefficients are ours with odd m negated.
#include <array>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>

#include "tests/engines/engine_light.h"
#include "tests/folder.h"

namespace welkin::tests {
namespace {

/// Radiance coefficients of a sky without symmetry, all above 0.05 and its radiance within [0, 1].
constexpr std::array<double, 9> kLatlongSky = {1.6, 0.1, -0.15, 0.2, 0.1, -0.12, 0.08, 0.14, -0.1};

/// The sky as a Radiance picture of 128 x 64: row 0 at +y, +z in the middle, +x to its left.
std::string latlongBytes() {
  constexpr int kWidth = 128, kHeight = 64;
  std::string bytes = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 64 +X 128\n";
  for (int row = 0; row < kHeight; ++row) {
    for (int column = 0; column < kWidth; ++column) {
      const double polar = M_PI * (row + 0.5) / kHeight, turn = M_PI * (1.0 - 2.0 * (column + 0.5) / kWidth);
      const auto basis = basisOf(std::sin(polar) * std::sin(turn), std::cos(polar), std::sin(polar) * std::cos(turn));
      double radiance = 0.0;
      for (std::size_t i = 0; i < 9; ++i) radiance += kLatlongSky[i] * basis[i];
      int exponent = 0;
      const double mantissa = std::frexp(radiance, &exponent);
      bytes.append(3, static_cast<char>(mantissa * 256.0));
      bytes.push_back(static_cast<char>(exponent + 128));
    }
  }
  return bytes;
}

TEST_CASE("Filament, CmgenReadsALatlongAsItIs") {
  const std::string cmgen = WELKIN_CMGEN;
  if (cmgen.empty()) {
    std::cout << "skipped: cmgen is not installed\n";
    return;
  }
  const Folder folder;
  const std::string sky = folder.write("sky.hdr", latlongBytes()), output = folder / "sh.txt";
  const std::string command = cmgen + " --quiet --size=32 --sh=3 --sh-window=no --sh-output=" + output + " " + sky;
  REQUIRE(std::system(command.c_str()) == 0);
  std::ifstream lines(output);
  std::string line;
  for (std::size_t i = 0; i < 9; ++i) {
    REQUIRE(std::getline(lines, line));
    const double value = std::stod(line.substr(line.find('(') + 1));
    // A byte of mantissa and cmgen's own sampling are off by 1 % of the first; another sign or order by 0.1 or more.
    CHECK(value == Approx(i % 2 == 0 ? kLatlongSky[i] : -kLatlongSky[i]).margin(0.02));
  }
}

}  // namespace
}  // namespace welkin::tests
