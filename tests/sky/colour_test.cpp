// SPDX-License-Identifier: Apache-2.0
// Colours of other primaries: published matrices, whites, and primaries that are none.
#include "sky/image/colour.h"

#include <catch2/catch.hpp>

namespace welkin::tests {

using det::Number3;
using image::Chromaticities;
namespace {

const Chromaticities kAcesCg{{0.713, 0.293}, {0.165, 0.830}, {0.128, 0.044}, {0.32168, 0.33767}};
const Chromaticities kRec2020{{0.708, 0.292}, {0.170, 0.797}, {0.131, 0.046}, {0.3127, 0.3290}};

void requireRows(const Chromaticities& colours, const double (&row)[3][3], double digits) {
  const auto matrix = image::toRec709(colours);
  REQUIRE(matrix);
  for (std::size_t c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r) {
      CAPTURE(r, c);
      REQUIRE(matrix->column[c][r] == Approx(row[r][c]).margin(digits));
    }
}

}  // namespace

TEST_CASE("Colour, PublishedMatrices") {
  // ITU-R BT.2087-0, equation 4, to its four digits.
  requireRows(kRec2020, {{1.6605, -0.5876, -0.0728}, {-0.1246, 1.1329, -0.0083}, {-0.0182, -0.1006, 1.1187}}, 5.1e-5);
  // ACEScg to sRGB by Bradford, as OpenColorIO's ACES configuration has it, to its five digits.
  requireRows(kAcesCg, {{1.70505, -0.62179, -0.08326}, {-0.13026, 1.14080, -0.01055}, {-0.02400, -0.12897, 1.15297}},
              1e-5);
}

TEST_CASE("Colour, EveryWhiteBecomesWhite") {
  for (const Chromaticities& colours : {kAcesCg, kRec2020, image::kXyz, image::kRec709}) {
    const Number3 white = *image::toRec709(colours) * Number3(1.0);
    for (int c = 0; c < 3; ++c) REQUIRE(white[c] == Approx(1.0).epsilon(1e-12));
  }
}

TEST_CASE("Colour, Rec709IsLeftAlone") {
  Chromaticities near = image::kRec709;
  REQUIRE(image::isRec709(near));
  near.white = {0.31271, 0.32902};  // D65 to five digits
  REQUIRE(image::isRec709(near));
  near.red[0] += 0.001;
  REQUIRE_FALSE(image::isRec709(near));
  requireRows(image::kRec709, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, 1e-12);
}

TEST_CASE("Colour, PrimariesOnALineAreNone") {
  REQUIRE_FALSE(image::toRec709({{0.2, 0.2}, {0.3, 0.3}, {0.4, 0.4}, {0.3, 0.3}}));
  Chromaticities black = image::kRec709;
  black.white[1] = 0.0;
  REQUIRE_FALSE(image::toRec709(black));
}

}  // namespace welkin::tests
