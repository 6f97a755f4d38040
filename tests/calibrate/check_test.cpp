// SPDX-License-Identifier: Apache-2.0
#include <catch2/catch.hpp>

#include "calibrate/albedo_check.h"
#include "sh/deterministic.h"

using namespace welkin;
using namespace welkin::calibrate;

namespace {

const ReferenceChart& classic() {
  static const ReferenceChart kChart = referenceChart(Edition::after_2014);
  return kChart;
}

image::Image texels(std::initializer_list<Colour> colours) {
  image::Image image;
  image.width = static_cast<int>(colours.size());
  image.height = 1;
  for (const Colour& c : colours)
    for (const double v : c) image.rgb.push_back(static_cast<float>(v));
  return image;
}

Colour greyOfCode(double code) {
  return Colour::Constant(det::srgbDecode(code / 255.0));
}

}  // namespace

TEST_CASE("Gamut, HoldsTheChartAndItsMixturesAndNoStrongColour") {
  const Gamut gamut(classic());
  for (const Colour& patch : classic()) {
    CHECK(gamut.holds(patch));
    CHECK(gamut.holds(0.5 * patch));
    for (const Colour& other : classic()) CHECK(gamut.holds(0.3 * patch + 0.7 * other));
  }
  for (const Colour& primary : {Colour(1, 0, 0), Colour(0, 1, 0), Colour(0, 0, 1), Colour(1, 0, 1)})
    CHECK_FALSE(gamut.holds(primary));
  CHECK(gamut.holds(Colour::Zero()));  // the white's chromaticity
}

TEST_CASE("Gamut, AColourPastASideByMoreThanTheMarginIsOutside") {
  // Red, green and blue alone make a triangle with known sides.
  ReferenceChart chart;
  chart.fill(Colour(1, 0, 0));
  chart[1] = Colour(0, 1, 0);
  chart[2] = Colour(0, 0, 1);
  const Gamut gamut(chart);
  // The side from blue (0.15, 0.06) to red (0.64, 0.33); its outward normal points to more x and less y.
  const Eigen::Vector2d middle(0.395, 0.195), outward = Eigen::Vector2d(0.27, -0.49).normalized();
  const auto at = [&](double distance) {
    const Eigen::Vector2d p = middle + distance * outward;
    return rgbOfXyz(xyzOfXyY({p.x(), p.y(), 0.2}));
  };
  CHECK(gamut.holds(at(0.9 * Gamut::kMargin)));
  CHECK_FALSE(gamut.holds(at(1.1 * Gamut::kMargin)));
}

TEST_CASE("AlbedoCheck, CountsEveryTexelOnce") {
  const Gamut gamut(classic());
  const AlbedoShares shares =
      sharesOf(texels({greyOfCode(29.0), greyOfCode(31.0), greyOfCode(239.0), greyOfCode(241.0), Colour(0.5, 0, 0),
                       Colour(0.001, 0, 0), Colour(0, 0, 0), Colour(0.2, 0.2, 0.2)}),
               Colour::Ones(), gamut);
  CHECK(shares.dark == 3.0 / 8.0);
  CHECK(shares.bright == 1.0 / 8.0);
  CHECK(shares.outside == 1.0 / 8.0);
  CHECK(shares.wrong() == 5.0 / 8.0);
  CHECK(sharesOf({}, Colour::Ones(), gamut).wrong() == 0.0);
}

TEST_CASE("AlbedoCheck, TheTintMultipliesEveryChannel") {
  const Gamut gamut(classic());
  const image::Image grey = texels({Colour(0.5, 0.5, 0.5)});
  CHECK(sharesOf(grey, Colour::Ones(), gamut).wrong() == 0.0);
  CHECK(sharesOf(grey, Colour::Constant(0.02), gamut).dark == 1.0);
  CHECK(sharesOf(grey, Colour::Constant(1.9), gamut).bright == 1.0);
  CHECK(sharesOf(grey, Colour(1.0, 0.0, 0.0), gamut).outside == 1.0);
  CHECK(sharesOf(grey, Colour(0.0, 1.0, 0.0), gamut).outside == 1.0);
  CHECK(sharesOf(grey, Colour(0.0, 0.0, 1.0), gamut).outside == 1.0);
}

TEST_CASE("AlbedoCheck, TheWorstIsFirstAndDecides") {
  std::vector<CheckedAlbedo> checked = {
      {"b", {0.0, 0.1, 0.0}}, {"d", {0.0, 0.0, 0.0}}, {"a", {0.1, 0.0, 0.0}}, {"c", {0.1, 0.1, 0.2}}};
  sortByWrong(checked);
  std::string names;
  for (const CheckedAlbedo& c : checked) names += c.name;
  CHECK(names == "cabd");
  CHECK(checkJson(checked, 0.5)["passed"] == true);
  const auto json = checkJson(checked, 0.3);
  CHECK(json["passed"] == false);
  CHECK(json["albedo"][0]["name"] == "c");
  CHECK(json["albedo"][0]["outside"] == 0.2);
}
