// SPDX-License-Identifier: Apache-2.0
// The tone table gives the codes of the curve itself.
#include "view/quick_tone.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <limits>

using namespace welkin;

TEST_CASE("QuickTone, CodesAreThoseOfTheCurve") {
  render::FloatImage image{512, 96, std::vector<float>(std::size_t{4} * 512 * 96)};
  for (std::size_t i = 0; i < image.rgba.size(); ++i)
    image.rgba[i] =
        static_cast<float>(std::exp2(-30.0 + 40.0 * static_cast<double>(i) / static_cast<double>(image.rgba.size())));
  constexpr float kStrange[] = {
      0.0F,     -1.0F, std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN(), 1e-30F, 128.0F,
      0x1p-24F, 1e30F};
  std::copy(std::begin(kStrange), std::end(kStrange), image.rgba.begin());
  for (const double exposure : {0.01, 1.0, 37.0}) {
    const render::Picture exact = render::tonemap(image, exposure), quick = view::quickTone(image, exposure);
    REQUIRE(quick.rgb.size() == exact.rgb.size());
    std::size_t others = 0;
    int worst = 0;
    for (std::size_t i = 0; i < exact.rgb.size(); ++i) {
      const int off = std::abs(int{exact.rgb[i]} - int{quick.rgb[i]});
      worst = std::max(worst, off);
      others += off > 0 ? 1 : 0;
    }
    CHECK(worst <= 1);
    CHECK(static_cast<double>(others) < 2e-3 * static_cast<double>(exact.rgb.size()));  // twice a thousandth of a code
  }
}
