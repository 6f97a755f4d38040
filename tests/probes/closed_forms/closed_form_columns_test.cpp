// SPDX-License-Identifier: Apache-2.0
#include "closed_form_columns.h"

#include <catch2/catch.hpp>

#include "closed_forms.h"
#include "tests/probes/sky_polygon.h"

namespace welkin::tests {
namespace {

void check(const ClosedForm& form, const Compared& compared) {
  const auto text = [](const Number3& v) { return Catch::Detail::stringify(std::array{v.x, v.y, v.z}); };
  INFO(text(compared.found) << " +- " << text(compared.standard_error) << ", expected " << text(compared.expected));
  CHECK(agrees(form, compared));
}

}  // namespace

TEST_CASE("ClosedFormColumns, HoldInAllThreeWithBothSunModes") {
  constexpr std::size_t kPaths = 16384;
  for (const ClosedForm& form : closedForms()) {
    CAPTURE(form.name, form.bounces);
    const ClosedFormColumns columns = columnsOf(form, kPaths);
    for (std::size_t i = 0; i < columns.path_tracer.size(); ++i) {
      INFO("path tracer, " << i);
      check(form, columns.path_tracer[i]);
    }
    for (std::size_t b = 0; b < columns.transfer.size(); ++b) {
      INFO("transfer, direction " << b);
      check(form, columns.transfer[b]);
    }
    for (std::size_t i = 0; i < columns.four_directions.size(); ++i) {
      INFO("four directions, " << form.asked[i].name);
      check(form, columns.four_directions[i]);
    }
  }
}

TEST_CASE("SkyPolygon, AgreesWithTheFormsOfLevelGround") {
  constexpr double kRounding = 1e-14;
  const Number3 up(0, 1, 0);
  for (const double g : {0.3, 0.8, 1.3})
    CHECK(irradianceOverPi(skyOverWall(g), up) == Approx(skyViewOfWall(g)).epsilon(kRounding));
  for (const double h : {2.0, 8.0, 20.0})
    CHECK(irradianceOverPi(skyOfCanyon(8, h), up) == Approx(skyViewOfCanyon(8, h)).epsilon(kRounding));
  for (const int sides : {3, 4, 256})
    CHECK(irradianceOverPi(skyOfWell(3, 4, sides), up) == Approx(skyViewOfWell(3, 4, sides)).epsilon(kRounding));
}

TEST_CASE("SkyPolygon, IsCutAtTheHorizonOfATiltedSurface") {
  constexpr double kRounding = 1e-14;
  for (const Number3& n :
       {Number3(0.6, 0.8, 0), geometry::unit({0.3, 0.5, -0.7}), geometry::unit({-0.8, -0.3, 0.4}), Number3(0, -1, 0)})
    CHECK(irradianceOverPi(openSky(), n) == Approx(0.5 * (1.0 + n.y)).margin(kRounding));
  // An upright wall leaves the southern half; a wall that leans back by g leaves a lune of pi - g.
  for (const double g : {0.4, 1.2})
    CHECK(irradianceOverPi(skyOverWall(g), {0, std::cos(g), std::sin(g)}) ==
          Approx(0.5 * (1.0 + std::cos(g))).epsilon(kRounding));
}

}  // namespace welkin::tests
