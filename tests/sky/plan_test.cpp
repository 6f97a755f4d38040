// SPDX-License-Identifier: Apache-2.0
// Plans of the day's table meet budgets, take fewer bytes for looser ones, and keep the choices that the file fixes.
#include "sky/table/plan.h"

#include <tbb/global_control.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "sampled_day.h"
#include "some_skies.h"

namespace welkin::tests {

using det::Number3;
namespace {

table::PlanRequest within(double max_error) {
  table::PlanRequest request;
  request.max_error = max_error;
  return request;
}

/// The largest error of a plan's table. The runtime reads it from a file, and it is compared with direct integration at
/// every `stride`-th planned instant.
double measured(const SampledDay& day, const table::DayPlan& plan, std::size_t stride) {
  const OpenedTable opened(day.sky, plan.table, plan.encoding);
  const model::SkyProjector direct(day.sky.luminance, 1, 1e-5);
  double worst = 0.0;
  for (std::size_t i = 0; i < day.fields.instant.size(); i += stride) {
    const table::DayInstant& at = day.fields.instant[i];
    const model::SkyInstant instant(day.sky, at.time_h);
    const WelkinSkySample sample = opened.at(at.time_h);
    for (const double y : {-1.0, -0.3, 0.0, 0.1, 0.5, 0.8, 1.0})
      for (const double alpha : {0.1, -1.5, 2.8}) {
        const Number3 normal = normalAt(instant, y, alpha);
        const Number3 want = det::desaturate(direct.irradiance(instant, normal) * at.intensity, at.saturation);
        const Number3 off = opened.irradiance(sample, normal) - want;
        for (int c = 0; c < 3; ++c) worst = std::max(worst, std::abs(off[c]) / at.divisor[c]);
      }
  }
  return worst;
}

/// Counted bytes of a plan's table as it is stored.
std::size_t storedBytes(const table::DayPlan& plan) {
  std::size_t bytes = table::encodeNumbers(plan.table, plan.encoding).bytes() + 8 * plan.table.key_time_h.size();
  if (plan.table.modes) bytes += 2 * plan.table.modes->texels.size() + 4 * plan.table.modes->polar_sh.size();
  return bytes;
}

bool same(const table::DayPlan& a, const table::DayPlan& b) {
  if (a.table.modes.has_value() != b.table.modes.has_value()) return false;
  if (a.table.modes &&
      (a.table.modes->texels != b.table.modes->texels || a.table.modes->polar_sh != b.table.modes->polar_sh))
    return false;
  return a.met == b.met && a.encoding == b.encoding && a.predicted_error == b.predicted_error && a.bytes == b.bytes &&
         a.table.key_time_h == b.table.key_time_h && a.table.number == b.table.number;
}

}  // namespace

TEST_CASE("PlanDay, BudgetsAreMetAndLooserOnesCostLess") {
  for (const std::size_t which : {0U, 2U, 3U}) {
    const SampledDay day(someSkies()[which].sky, everyHours(0.5));
    std::size_t before = SIZE_MAX;
    for (const double budget : {0.01, 0.03, 0.1}) {
      const table::DayPlan plan = table::planDay(day.values, within(budget));
      CAPTURE(someSkies()[which].name, budget, plan.representation.name(), plan.bytes, plan.predicted_error);
      CHECK(plan.met);
      CHECK(plan.predicted_error <= budget);
      CHECK(measured(day, plan, 5) < budget * 1.05);  // Other normals than the planner used.
      CHECK(plan.bytes == storedBytes(plan));
      CHECK(plan.bytes <= before);
      before = plan.bytes;
      const auto best = std::find_if(plan.considered.begin(), plan.considered.end(),
                                     [&](const table::PlanChoice& c) { return c.bytes == plan.bytes; });
      REQUIRE(best != plan.considered.end());
      CHECK(best->name == plan.representation.name());
    }
  }
}

TEST_CASE("PlanDay, SameForAnyNumberOfThreads") {
  const auto planned = [](std::size_t threads) {
    const tbb::global_control most(tbb::global_control::max_allowed_parallelism, threads);
    const SampledDay day(someSkies()[1].sky, everyHours(1.0));
    return table::planDay(day.values, within(0.03));
  };
  CHECK(same(planned(1), planned(2)));
}

TEST_CASE("PlanDay, KeepsWhatIsFixed") {
  const SampledDay day(someSkies()[0].sky, everyHours(0.5));
  table::PlanRequest request = within(0.2);
  request.bands = 4;
  request.reconstruction = table::Reconstruction::fitted;
  request.encoding = table::Encoding::float16;
  request.key_time_h = {0.0,  4.5,  5.0,  5.5,  6.0,  6.5,  7.0,  8.0,  10.0,
                        12.0, 14.0, 16.0, 17.0, 17.5, 18.0, 18.5, 19.0, 21.0};
  const table::DayPlan plan = table::planDay(day.values, request);
  CHECK(plan.table.bands == 4);
  CHECK(!plan.table.modes);
  CHECK(plan.representation.reconstruction == table::Reconstruction::fitted);
  CHECK(plan.encoding == table::Encoding::float16);
  CHECK(plan.table.key_time_h == request.key_time_h);

  table::PlanRequest modes = within(0.05);
  modes.reconstruction = table::Reconstruction::modes;
  modes.bands = 2;
  const table::DayPlan of_modes = table::planDay(day.values, modes);
  CHECK(of_modes.met);
  CHECK(of_modes.table.modes);
  CHECK(of_modes.table.bands == 2);
}

TEST_CASE("PlanDay, AnImpossibleBudgetGetsTheLeastError") {
  const SampledDay day(someSkies()[0].sky, everyHours(1.0));
  table::PlanRequest request = within(1e-5);
  request.bands = 2;
  request.reconstruction = table::Reconstruction::fitted;
  const table::DayPlan plan = table::planDay(day.values, request);
  CHECK(!plan.met);
  const table::Representation fitted = table::coefficientsOf(day.values, 2, true);
  double least = 0.0;
  for (std::size_t i = 0; i < day.fields.instant.size(); ++i)
    least = std::max(
        least, table::errorOf(day.values, fitted, i, {fitted.weight.data() + i * fitted.rows, fitted.rows}).value);
  CHECK(plan.predicted_error == Approx(least).epsilon(1e-4));
  CHECK(plan.predicted_error > 0.02);
}

TEST_CASE("PlanDay, OnePercentInEightNumbersForEveryModel") {
  // The sun from 18 degrees below the horizon to the zenith; colours that change all over the day.
  for (const model::NamedLuminance& named : model::namedLuminances()) {
    model::Sky sky = someSkies()[0].sky;
    sky.luminance = named.model;
    sky.sun.path.key_time_h = {0.0, 5.0, 12.0, 19.0};
    sky.sun.path.key_azimuth_rad = {0.3, 1.2, 3.0, 4.9};
    sky.sun.path.key_elevation_rad = {-18.0 / 180.0 * M_PI, -0.1, M_PI / 2.0, -0.1};
    const SampledDay day(sky, everyHours(1.5));
    table::PlanRequest request = within(0.01);
    request.reconstruction = table::Reconstruction::modes;
    const table::DayPlan plan = table::planDay(day.values, request);
    CAPTURE(named.name, plan.representation.name(), plan.predicted_error);
    CHECK(plan.met);
    CHECK(plan.predicted_error < 0.01);
    CHECK(plan.table.rows <= 8);
    CHECK(measured(day, plan, 7) < 0.0105);
  }
}

}  // namespace welkin::tests
