// SPDX-License-Identifier: Apache-2.0
// A day's modes: their number, the meaning of their weights, and their quality as a map.
#include "sky/table/modes.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "format/half.h"
#include "sampled_day.h"
#include "sky/table/key_placement.h"
#include "some_skies.h"

namespace welkin::tests {

using det::Number3;
namespace {

constexpr std::size_t kOrders = model::IrradianceProjector::kOrders;
constexpr std::size_t kRows = model::IrradianceProjector::kRows;

/// The modes and the runtime are floats and halfs that both sides read. Only the rounding of a sample and of a normal
/// remains, over the mean irradiance.
constexpr double kRuntime = 4e-6;

table::DayTable tableOf(const SampledDay& day, const table::Representation& r) {
  std::vector<std::size_t> keys(day.fields.instant.size());
  for (std::size_t i = 0; i < keys.size(); ++i) keys[i] = i;
  return table::tableAt(day.values, r, keys);
}

table::Representation modesOf(const SampledDay& day, std::size_t count, int columns, int rows, int bands = 3) {
  const table::ModeSet set = table::DayModes(day.fields, day.grid).best(count);
  return table::modesOf(day.values, set, table::weightsOf(day.values, set), columns, rows, bands);
}

}  // namespace

TEST_CASE("DayModes, AnEvenOrStillSkyHasOne") {
  model::Sky overcast = someSkies()[3].sky;
  REQUIRE(someSkies()[3].name == "cie-overcast");
  overcast.gradient_sun = overcast.gradient_anti = model::Gradient();
  const SampledDay even(overcast, {1.0, 6.0, 8.0, 12.0, 16.5});
  CHECK(table::DayModes(even.fields, even.grid).best(6).count() == 1);
  const SampledDay still(stillSky(*model::findLuminance("cie-12"), 20.0), {1.0, 6.0, 12.0});
  CHECK(table::DayModes(still.fields, still.grid).best(6).count() == 1);
  const SampledDay clear(someSkies()[0].sky, {1.0, 6.0, 8.0, 12.0, 16.5});
  CHECK(table::DayModes(clear.fields, clear.grid).best(6).count() == 6);
}

TEST_CASE("DayModes, WeightsOfACombinationAreItsFactors") {
  const SampledDay day(someSkies()[0].sky, {1.0, 6.0, 8.0, 12.0, 16.5});
  const table::ModeSet set = table::DayModes(day.fields, day.grid).best(5);
  REQUIRE(set.count() == 5);
  const double want[] = {3.0, -0.7, 0.25, 1e-3, 2.0};
  table::FieldChannel sum;
  for (std::size_t k = 0; k < 5; ++k) sum.add(set.mode[k], want[k]);
  const std::vector<double> got = set.weightsOf(table::DayModes::vectorOf(sum));
  for (std::size_t k = 0; k < 5; ++k) CHECK(got[k] == Approx(want[k]).margin(1e-9));
}

TEST_CASE("DayModes, AsManyAsTheDayHasGiveItBack") {
  // Five instants of three channels: fifteen fields, of which twelve modes leave next to nothing.
  const SampledDay day(someSkies()[0].sky, {1.0, 6.0, 12.0});
  const table::ModeSet set = table::DayModes(day.fields, day.grid).best(9);
  REQUIRE(set.count() == 9);
  for (const table::DayInstant& at : day.fields.instant)
    for (int c = 0; c < 3; ++c) {
      const table::FieldChannel want(at.field, c);
      table::FieldChannel left = want;
      const std::vector<double> weight = set.weightsOf(table::DayModes::vectorOf(want));
      for (std::size_t k = 0; k < weight.size(); ++k) left.add(set.mode[k], -weight[k]);
      for (const double off : day.grid.valuesOf(left)) CHECK(std::abs(off) < 1e-6 * at.field.mean[c]);
    }
}

TEST_CASE("ModeMap, ErrorOfAParabolaIsASixteenthOfItsBend") {
  // E = 2 + 4 u^2 + 8 v^2 of column u and row v in [0, 1]. Bilinear curves are off between the texels by at most an
  // eighth of the second differences, 8 / columns^2 and 16 / rows^2. Centring lowers that to a sixteenth. The grid has
  // normals at texels and near the middles between.
  table::ModeSet set;
  set.mode.emplace_back();
  for (std::size_t r = 0; r < kRows; ++r) {
    const double v = static_cast<double>(r) / (kRows - 1);
    double* series = set.mode[0].series.data() + r * kOrders;
    series[0] = 2.0 + 8.0 * v * v + 1.5;  // u = (1 + cos) / 2: u^2 = 3/8 + cos / 2 + cos(2 alpha) / 8
    series[1] = 2.0;
    series[2] = 0.5;
  }
  set.vector.push_back(table::DayModes::vectorOf(set.mode[0]));
  const table::ErrorGrid grid;
  const std::vector<double> want = grid.valuesOf(set.mode[0]);
  for (const auto& [columns, rows] : {std::pair(5, 5), {9, 5}, {5, 9}, {9, 9}, {17, 17}}) {
    CAPTURE(columns, rows);
    const std::vector<double> got = table::mapValues(table::mapOf(set, columns, rows, 2), grid);
    const double bound = (8.0 / ((columns - 1.0) * (columns - 1.0)) + 16.0 / ((rows - 1.0) * (rows - 1.0))) / 16.0;
    const double halfs = 14.0 * 0x1p-11;  // of the largest value
    double most = 0.0;
    double least = 0.0;
    for (std::size_t p = 0; p < grid.count() / 2; ++p) {
      if (1.0 - std::sqrt(1.0 - grid.y(p)) > 1.0 - 1.0 / (rows - 1)) continue;  // at the zenith it has many values
      most = std::max(most, got[p] - want[p]);
      least = std::min(least, got[p] - want[p]);
    }
    CHECK(most < bound + halfs);
    CHECK(-least < bound + halfs);
    if (columns > 9) continue;  // there halfs are as large
    CHECK(most > 0.9 * bound - halfs);
    CHECK(-least > 0.9 * bound - halfs);
  }
}

TEST_CASE("ModeMap, ReadsAsTheRuntimeReadsIt") {
  const SampledDay day(someSkies()[2].sky, {1.0, 6.0, 7.5, 12.0, 16.5});
  for (const auto& [columns, rows] : {std::pair(5, 3), {9, 13}}) {
    const table::Representation r = modesOf(day, 6, columns, rows);
    const OpenedTable opened(day.sky, tableOf(day, r));
    for (std::size_t i = 0; i < day.fields.instant.size(); ++i) {
      const table::DayInstant& at = day.fields.instant[i];
      const model::SkyInstant instant(day.sky, at.time_h);
      const WelkinSkySample sample = opened.at(at.time_h);
      for (std::size_t p = 0; p < day.grid.count(); p += 5) {
        const auto normal = day.grid.normal(p);
        if (p >= day.grid.count() / 2 && normal.y == 0.0) continue;  // from there on down; itself it is an upper one
        const double alpha = std::acos(std::clamp(normal.cos_alpha, -1.0, 1.0)) * (p % 2 == 0 ? 1.0 : -1.0);
        const Number3 got = opened.irradiance(sample, normalAt(instant, normal.y, alpha));
        Number3 want(0.0);
        for (std::size_t k = 0; k < 6; ++k) want += r.weight[i * 6 + k] * (r.values[p * 6 + k] * at.intensity);
        want = det::desaturate(want, at.saturation);
        for (int c = 0; c < 3; ++c)
          CHECK(got[c] == Approx(std::max(want[c], 0.0)).margin(kRuntime * at.divisor[c]).epsilon(0.0));
      }
    }
  }
}

TEST_CASE("ModeMap, ErrorFallsWithTheSquareOfItsTexels") {
  // Compares with direct integration, for normals above and below the horizon, for a sky without a cusp: overcast, in
  // colours.
  const SampledDay day(someSkies()[3].sky, {6.0, 12.0});
  double before = 0.0;
  for (const int rows : {3, 5, 9}) {
    const table::Representation r = modesOf(day, 6, 2 * rows - 1, rows);
    const OpenedTable opened(day.sky, tableOf(day, r));
    const model::SkyProjector direct(day.sky.luminance, 1, 1e-9);
    double worst = 0.0;
    for (const table::DayInstant& at : day.fields.instant) {
      const model::SkyInstant instant(day.sky, at.time_h);
      const WelkinSkySample sample = opened.at(at.time_h);
      for (const double y : {-1.0, -0.9, -0.6, -0.3, -0.1, 0.0, 0.05, 0.17, 0.35, 0.52, 0.7, 0.85, 0.95, 1.0})
        for (const double alpha : {0.3, -1.4, 2.5}) {
          const Number3 normal = normalAt(instant, y, alpha);
          const Number3 off = opened.irradiance(sample, normal) - direct.irradiance(instant, normal) * at.intensity;
          for (int c = 0; c < 3; ++c) worst = std::max(worst, std::abs(off[c]) / at.divisor[c]);
        }
    }
    CAPTURE(rows, worst, before);
    if (rows > 3) CHECK(worst < before / 2.5);  // a square is 4, less what halfs add
    if (rows == 9) CHECK(worst < 0.005);
    before = worst;
  }
}

TEST_CASE("ModeMap, AllColumnsAreTheSameAtTheZenith") {
  // Equal to the last bits of a half. Otherwise a surface that faces up would step with its azimuth.
  const SampledDay day(someSkies()[1].sky, {6.0, 9.0, 12.0, 16.5});
  const table::Representation r = modesOf(day, 8, 9, 7);
  const table::ModeTable& map = *r.modes;
  for (int k = 0; k < map.count; ++k) {
    const auto texel = [&](int i) {
      return double{format::floatFromHalf(
          map.texels[static_cast<std::size_t>(((map.rows - 1) * map.columns + i) * map.count + k)])};
    };
    for (int i = 1; i < map.columns; ++i) CHECK(texel(i) == Approx(texel(0)).epsilon(0x1p-10).margin(1e-4));
  }
}

TEST_CASE("ModeMap, ItsCoefficientsAreThoseOfTheSky") {
  // Where modes span the day, a sample has the coefficients of a projection.
  const SampledDay day(someSkies()[0].sky, {1.0, 6.0, 12.0});
  const table::Representation r = modesOf(day, 9, 9, 9, 5);
  const OpenedTable opened(day.sky, tableOf(day, r));
  const model::SkyProjector projector(day.sky.luminance, 5, 1e-9);
  constexpr double kFieldTolerance = 2e-5;  // of c0: that of sky/model/irradiance.h, and floats
  for (const table::DayInstant& at : day.fields.instant) {
    const model::SkyMoments want = projector.project(model::SkyInstant(day.sky, at.time_h));
    const WelkinSkySample sample = opened.at(at.time_h);
    for (std::size_t i = 0; i < 25; ++i)
      for (int c = 0; c < 3; ++c)
        CHECK(double{sample.radiance_sh[i][c]} == Approx(want.radiance_sh[i][c] * at.intensity)
                                                      .margin(kFieldTolerance * want.radiance_sh[0][c] * at.intensity)
                                                      .epsilon(0.0));
  }
}

}  // namespace welkin::tests
