// SPDX-License-Identifier: Apache-2.0
// Keys of a day's table: their target error, recomputed by other means, and their positions.
#include "sky/table/key_placement.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "sampled_day.h"
#include "some_skies.h"

namespace welkin::tests {

using det::Number3;
namespace {

/// The error includes that of the stored floats.
constexpr double kFloats = 1e-5;

/// An instant's error when its rows lie between those of two others, `share` of the way. It follows the definition,
/// from the values of the functions.
double errorBetween(const SampledDay& day, const table::Representation& r, std::size_t first, std::size_t second,
                    double share, std::size_t instant) {
  const table::DayInstant& at = day.fields.instant[instant];
  double worst = 0.0;
  for (std::size_t p = 0; p < day.grid.count(); ++p)
    for (int c = 0; c < 3; ++c) {
      double got = 0.0;
      for (std::size_t k = 0; k < r.functions; ++k)
        got += r.values[p * r.functions + k] *
               ((1.0 - share) * r.weight[first * r.rows + k][c] + share * r.weight[second * r.rows + k][c]);
      const double off = got - day.values.value[instant * day.grid.count() + p][c];
      worst = std::max(worst, std::abs(off) * at.intensity / at.divisor[c]);
    }
  return worst;
}

/// The largest error of the instants from one key to the next, counted round the day.
double errorOfStretch(const SampledDay& day, const table::Representation& r, std::size_t first, std::size_t last) {
  const std::size_t count = day.fields.instant.size();
  const auto hour = [&](std::size_t i) { return day.fields.instant[i % count].time_h + (i >= count ? 24.0 : 0.0); };
  double worst = 0.0;
  for (std::size_t i = first; i <= last; ++i)
    worst = std::max(worst, errorBetween(day, r, first, last % count,
                                         (hour(i) - hour(first)) / (hour(last) - hour(first)), i % count));
  return worst;
}

/// A sky without ground or desaturation, which errorBetween leaves out.
model::Sky plainSky(std::size_t i) {
  model::Sky sky = someSkies()[i].sky;
  REQUIRE(!table::hasGround(sky));
  return sky;
}

}  // namespace

TEST_CASE("PlaceKeys, EveryInstantIsWithinTheErrorAndNoKeyReachesFurther") {
  const SampledDay day(plainSky(0), everyHours(0.25));
  const std::size_t count = day.fields.instant.size();
  const table::Representation r = table::coefficientsOf(day.values, 5, false);
  double at_keys = 0.0;
  for (std::size_t i = 0; i < count; ++i) at_keys = std::max(at_keys, errorBetween(day, r, i, i, 0.0, i));
  std::size_t before = count + 1;
  for (const double error : {1.1 * at_keys, 1.5 * at_keys, 3.0 * at_keys}) {
    const auto keys = table::placeKeys(day.values, r, error);
    CAPTURE(at_keys, error, keys);
    REQUIRE(keys.size() > 1);
    CHECK(keys.size() <= before);
    before = keys.size();
    CHECK(keys.front() == 0);
    for (std::size_t i = 0; i < keys.size(); ++i) {
      const std::size_t next = i + 1 < keys.size() ? keys[i + 1] : count;
      CHECK(errorOfStretch(day, r, keys[i], next) <= error * (1.0 + 1e-9));
      if (next < count) CHECK(errorOfStretch(day, r, keys[i], next + 1) > error);
    }
    CHECK(table::placeKeys(day.values, r, error, keys.size()) == keys);
    CHECK(table::placeKeys(day.values, r, error, keys.size() - 2).empty());
  }
  CHECK(table::placeKeys(day.values, r, 0.99 * at_keys).empty());
}

TEST_CASE("PlaceKeys, ThroughAFileAndByDirectIntegration") {
  // Every sampled instant, midnight included, at normals of its own. Two of the models have a cusp at the sun.
  for (const std::size_t which : {1U, 2U}) {
    const SampledDay day(plainSky(which), everyHours(0.5));
    const table::Representation r = table::coefficientsOf(day.values, 5, true);
    constexpr double kError = 0.1;
    const auto keys = table::placeKeys(day.values, r, kError);
    REQUIRE(keys.size() > 1);
    REQUIRE(keys.size() < 48);
    const OpenedTable opened(day.sky, table::tableAt(day.values, r, keys));
    const model::SkyProjector direct(day.sky.luminance, 1, 1e-5);
    double worst = 0.0;
    for (const table::DayInstant& at : day.fields.instant) {
      const model::SkyInstant instant(day.sky, at.time_h);
      const WelkinSkySample sample = opened.at(at.time_h);
      for (const double y : {-1.0, -0.55, 0.0, 0.04, 0.4, 0.75, 1.0})
        for (const double alpha : {0.0, -0.39, 1.96, M_PI}) {
          const Number3 normal = normalAt(instant, y, alpha);
          const Number3 off = opened.irradiance(sample, normal) -
                              det::desaturate(direct.irradiance(instant, normal) * at.intensity, at.saturation);
          for (int c = 0; c < 3; ++c) worst = std::max(worst, std::abs(off[c]) / at.divisor[c]);
        }
    }
    CAPTURE(which, worst, keys.size());
    CHECK(worst < kError * 1.02);  // Other normals than the planner used.
    CHECK(worst > kError / 1.4);
    const table::DayTable table = table::tableAt(day.values, r, keys);
    CHECK(table::errorOf(day.values, r, table, table::Encoding::float32).value <= kError + kFloats);
  }
}

TEST_CASE("PlaceKeys, AStillSkyHasOneKey") {
  const SampledDay day(stillSky(*model::findLuminance("cie-12"), 20.0), everyHours(1.0));
  const table::Representation r = table::coefficientsOf(day.values, 5, true);
  CHECK(table::placeKeys(day.values, r, 0.2).size() == 1);
}

TEST_CASE("PlaceKeys, SitWhereTheSkyChanges") {
  // The sun rises from 5 to 50 degrees between 6 and 8 h, stands, and sinks back between 23 and 1 h, over midnight.
  model::Sky sky = stillSky(*model::findLuminance("cie-12"), 5.0);
  sky.sun.path.key_time_h = {1.0, 6.0, 8.0, 23.0};
  sky.sun.path.key_azimuth_rad = {1.0, 1.0, 1.0, 1.0};
  sky.sun.path.key_elevation_rad = {0.09, 0.09, 0.87, 0.87};
  const SampledDay day(sky, everyHours(1.0 / 8.0));
  const table::Representation r = table::coefficientsOf(day.values, 3, true);
  double at_keys = 0.0;
  for (std::size_t i = 0; i < day.fields.instant.size(); ++i)
    at_keys = std::max(at_keys, errorBetween(day, r, i, i, 0.0, i));
  const auto keys = table::placeKeys(day.values, r, at_keys * 1.001 + 1e-4);
  std::size_t rising = 0;
  std::size_t sinking = 0;
  for (const std::size_t key : keys) {
    const double t = day.fields.instant[key].time_h;
    if (t >= 5.9 && t <= 8.1) ++rising;
    if (t >= 22.9 || t <= 1.1) ++sinking;
  }
  CAPTURE(keys.size(), rising, sinking, at_keys);
  CHECK(keys.size() >= 6);
  CHECK(rising + sinking + 1 >= keys.size());
  CHECK(rising >= 3);
  CHECK(sinking >= 3);
}

TEST_CASE("PartsOf, EachCauseByItsDefinition") {
  const SampledDay day(plainSky(0), everyHours(0.5));
  const std::size_t count = day.fields.instant.size();
  const table::Representation r = table::coefficientsOf(day.values, 3, false);
  std::vector<std::size_t> keys;
  for (std::size_t i = 0; i < count; i += 6) keys.push_back(i);
  const table::DayTable table = table::tableAt(day.values, r, keys);
  const table::ErrorParts parts = table::partsOf(day.values, r, table, table::Encoding::fixed8);
  const table::ErrorParts finer = table::partsOf(day.values, r, table, table::Encoding::fixed16);
  double truncation = 0.0;
  double time = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    truncation = std::max(truncation, errorBetween(day, r, i, i, 0.0, i));
    // The time error alone: an instant between two keys against its own rows.
    const table::DayInstant& at = day.fields.instant[i];
    const std::size_t first = i / 6 * 6;
    const double share = static_cast<double>(i - first) / 6.0;
    for (std::size_t p = 0; p < day.grid.count(); ++p)
      for (int c = 0; c < 3; ++c) {
        double off = 0.0;
        for (std::size_t k = 0; k < r.functions; ++k)
          off += r.values[p * r.functions + k] *
                 ((1.0 - share) * r.weight[first * r.rows + k][c] +
                  share * r.weight[(first + 6) % count * r.rows + k][c] - r.weight[i * r.rows + k][c]);
        time = std::max(time, std::abs(off) * at.intensity / at.divisor[c]);
      }
  }
  CHECK(parts.truncation == Approx(truncation).epsilon(1e-9));
  CHECK(parts.time == Approx(time).epsilon(1e-9));
  CHECK(finer.truncation == parts.truncation);
  CHECK(finer.time == parts.time);
  CHECK(finer.encoding < parts.encoding / 128.0);  // 1/65534 and 1/254, and rounding is a matter of luck
  CHECK(finer.encoding > parts.encoding / 512.0);
}

}  // namespace welkin::tests
