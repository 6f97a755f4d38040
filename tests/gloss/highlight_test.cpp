// SPDX-License-Identifier: Apache-2.0
// Filtered gloss keeps the highlight of bumps, and a filtered normal alone does not.
#include "highlight.h"

#include <catch2/catch.hpp>

namespace welkin::tests {

TEST_CASE("Highlight, ToksvigsGlossIsNearestToTheTexelsThemselves") {
  const gloss::NormalMap map = gaussianBumps(64, 0.1);
  gloss::GlossMap number;
  number.number = 9.0 / 13.0;  // m = 512
  const double m = 512.0;
  const auto mips = gloss::mipsOf(map, number);
  const double average = f64::powerOfGloss(gloss::averageFactorOf(mips).gloss);
  for (const auto& [k, side] : {std::pair<std::size_t, int>(2, 4), {4, 16}}) {
    const gloss::Mip& mip = mips[k];
    const Highlight none = highlightOf(map, m, mip, side, [&](std::size_t) { return m; });
    const Highlight one = highlightOf(map, m, mip, side, [&](std::size_t) { return average; });
    const Highlight full =
        highlightOf(map, m, mip, side, [&](std::size_t i) { return f64::powerOfGloss(double{mip.gloss[i]}); });
    CAPTURE(side, none.error, one.error, full.error, full.energy);
    REQUIRE(none.error > 0.8);  // most of the light is at the wrong angle
    REQUIRE(one.error < none.error / 2.0);
    REQUIRE(full.error < none.error / 2.0);
    REQUIRE(full.energy == Approx(1.0).margin(0.05));
  }
  const Highlight near =
      highlightOf(map, m, mips[0], 1, [&](std::size_t i) { return f64::powerOfGloss(double{mips[0].gloss[i]}); });
  REQUIRE(near.error < 1e-4);  // the gloss' and the normals' rounding to float
}

}  // namespace welkin::tests
