// SPDX-License-Identifier: Apache-2.0
// Two pictures in one.
#include "view/beside.h"

#include <catch2/catch.hpp>

using namespace welkin;
using render::Picture;

namespace {

/// A picture whose pixels tell which one it is, and their column.
Picture columns(uint8_t red, uint32_t width) {
  Picture picture{width, 2, {}};
  for (uint32_t y = 0; y < 2; ++y)
    for (uint32_t x = 0; x < width; ++x) picture.rgb.insert(picture.rgb.end(), {red, static_cast<uint8_t>(x), 0});
  return picture;
}

/// Red and column of a pixel in both rows, which must be alike.
std::pair<int, int> at(const Picture& picture, uint32_t x) {
  REQUIRE(picture.rgb[3 * x] == picture.rgb[3 * (picture.width + x)]);
  REQUIRE(picture.rgb[3 * x + 1] == picture.rgb[3 * (picture.width + x) + 1]);
  return {picture.rgb[3 * x], picture.rgb[3 * x + 1]};
}

}  // namespace

TEST_CASE("Beside, AWipeKeepsEveryColumnInItsPlace") {
  const Picture a = columns(1, 8), b = columns(2, 8);
  const Picture half = view::wiped(a, b, 0.5);
  for (uint32_t x = 0; x < 4; ++x) CHECK(at(half, x) == std::pair(1, static_cast<int>(x)));
  CHECK(at(half, 4).first == 230);  // the line
  for (uint32_t x = 5; x < 8; ++x) CHECK(at(half, x) == std::pair(2, static_cast<int>(x)));
  CHECK(view::wiped(a, b, 1.0).rgb == a.rgb);
  CHECK(view::wiped(a, b, 0.0).rgb == b.rgb);
  CHECK(view::wiped(a, b, 7.0).rgb == a.rgb);  // clamped
}

TEST_CASE("Beside, SideBySideShowsTheSameMiddles") {
  for (const uint32_t width : {8U, 9U, 1U}) {
    const Picture both = view::sideBySide(columns(1, width), columns(2, width));
    const uint32_t half = width / 2;
    for (uint32_t x = 0; x + 1 < half; ++x) {
      CHECK(at(both, x).first == 1);
      if (x > 0) CHECK(at(both, half + x) == std::pair(2, at(both, x).second));
      CHECK(view::sideColumn(x, width) == at(both, x).second);
      if (x > 0) CHECK(view::sideColumn(half + x, width) == at(both, half + x).second);
    }
  }
}
