// SPDX-License-Identifier: Apache-2.0
// Skies of a family hold their irradiance by the same modes. The runtime's blend of two is the mean of their models'
// own irradiance, by direct integration in double.
#include "sky/table/family_plan.h"

#include <tbb/global_control.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <memory>

#include "sampled_day.h"
#include "some_skies.h"

namespace welkin::tests {

using det::Number3;
namespace {

/// The skies of some_skies.h that share the sun's path: clear, a layer at the horizon, overcast; and a narrow lobe.
model::Sky familySky(const std::string& name) {
  if (name == "clear") return someSkies()[0].sky;
  if (name == "layer") return someSkies()[2].sky;
  if (name == "overcast") return someSkies()[3].sky;
  model::Sky lobe = someSkies()[0].sky;  // half of its light within 8 degrees of the sun
  lobe.luminance = {-1.0, -0.3, 300.0, -12.0, 0.2, 0.0};
  return lobe;
}

struct Family {
  explicit Family(const std::vector<std::string>& names, double max_error, double step_h = 0.5) {
    for (const std::string& name : names)
      day.push_back(std::make_unique<SampledDay>(familySky(name), everyHours(step_h)));
    for (const auto& d : day) {
      member.push_back({&d->values, {}});
      member.back().request.max_error = max_error;
    }
    plan = table::planFamily(member);
  }
  std::vector<std::unique_ptr<SampledDay>> day;
  std::vector<table::FamilyMember> member;
  std::vector<table::DayPlan> plan;
};

/// Largest errors of the blends of two opened tables: from welkin_sky_irradiance, and from their coefficients alone.
struct BlendErrors {
  double stated = 0.0, of_coefficients = 0.0;
  std::uint32_t modes = WELKIN_MAX_MODES;
};
BlendErrors blendErrors(const SampledDay& a, const table::DayPlan& plan_a, const SampledDay& b,
                        const table::DayPlan& plan_b, std::size_t stride) {
  const OpenedTable first(a.sky, plan_a.table, plan_a.encoding), second(b.sky, plan_b.table, plan_b.encoding);
  const model::SkyProjector direct_a(a.sky.luminance, 1, 1e-5), direct_b(b.sky.luminance, 1, 1e-5);
  BlendErrors worst;
  for (std::size_t i = 0; i < a.fields.instant.size(); i += stride) {
    const table::DayInstant& at = a.fields.instant[i];
    const table::DayInstant& bt = b.fields.instant[i];
    const model::SkyInstant instant_a(a.sky, at.time_h), instant_b(b.sky, bt.time_h);
    const WelkinSkySample sample_a = first.at(at.time_h), sample_b = second.at(at.time_h);
    for (const double weight : {0.25, 0.5, 0.75}) {
      WelkinSkySample blended{};
      if (welkin_sample_blend(&sample_a, &sample_b, static_cast<float>(weight), &blended) != WELKIN_OK)
        throw std::runtime_error(welkin_argument_error());
      worst.modes = std::min(worst.modes, blended.mode_count);
      const Number3 divisor = table::divisorOf(mix(at.mean, bt.mean, weight), table::brightestOf(a.sky));
      for (const double y : {-1.0, -0.3, 0.0, 0.1, 0.5, 0.8, 1.0})
        for (const double alpha : {0.1, -1.5, 2.8}) {
          const Number3 n = normalAt(instant_a, y, alpha);
          const Number3 want =
              mix(det::desaturate(direct_a.irradiance(instant_a, n) * at.intensity, at.saturation),
                  det::desaturate(direct_b.irradiance(instant_b, n) * bt.intensity, bt.saturation), weight);
          const Number3 got = first.irradiance(blended, n);
          const float normal[3] = {static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z)};
          float sh[3];
          if (welkin_sample_irradiance(&blended, normal, sh) != WELKIN_OK) throw std::runtime_error("no SH");
          for (int c = 0; c < 3; ++c) {
            worst.stated = std::max(worst.stated, std::abs(got[c] - want[c]) / divisor[c]);
            worst.of_coefficients = std::max(worst.of_coefficients, std::abs(double{sh[c]} - want[c]) / divisor[c]);
          }
        }
    }
  }
  return worst;
}

bool shareBytes(const table::DayPlan& a, const table::DayPlan& b) {
  return a.table.modes && b.table.modes && a.table.modes->columns == b.table.modes->columns &&
         a.table.modes->texels == b.table.modes->texels && a.table.modes->polar_sh == b.table.modes->polar_sh;
}

}  // namespace

TEST_CASE("PlanFamily, BlendsAreAsExactAsTheSkies") {
  constexpr double kBudget = 0.03;
  // Errors are divided by the blend's mean, which in a channel may be less than the blend of both divisors; and the
  // normals are others than the planner's.
  constexpr double kBlend = 1.2;
  for (const auto& names :
       {std::vector<std::string>{"clear", "overcast"}, {"clear", "lobe"}, {"layer", "overcast", "lobe"}}) {
    const Family family(names, kBudget);
    for (std::size_t i = 0; i < names.size(); ++i) {
      CAPTURE(names[i], family.plan[i].predicted_error, family.plan[i].representation.name());
      CHECK(family.plan[i].met);
      CHECK(family.plan[i].predicted_error <= kBudget);
      CHECK(shareBytes(family.plan[0], family.plan[i]));
    }
    const BlendErrors errors = blendErrors(*family.day[0], family.plan[0], *family.day[1], family.plan[1], 3);
    CAPTURE(names[0], names[1], errors.stated, errors.of_coefficients);
    CHECK(errors.modes == static_cast<std::uint32_t>(family.plan[0].table.modes->count));
    CHECK(errors.stated < kBudget * kBlend);
    CHECK(errors.of_coefficients > errors.stated);  // what a blend without shared modes shows
    if (names[1] == "lobe") CHECK(errors.of_coefficients > 2.0 * kBudget);
  }
}

TEST_CASE("PlanFamily, SkiesThatWerePlannedAloneBlendByCoefficients") {
  table::PlanRequest request;
  request.max_error = 0.03;
  request.reconstruction = table::Reconstruction::modes;
  const SampledDay a(familySky("clear"), everyHours(0.5)), b(familySky("lobe"), everyHours(0.5));
  const table::DayPlan plan_a = table::planDay(a.values, request), plan_b = table::planDay(b.values, request);
  const BlendErrors errors = blendErrors(a, plan_a, b, plan_b, 5);
  CHECK(errors.modes == 0);
  CHECK(errors.stated > 0.06);
}

TEST_CASE("PlanFamily, OfOneSkyIsItsPlan") {
  for (const char* name : {"clear", "overcast"}) {
    const Family family({name}, 0.03, 1.0);
    table::PlanRequest request;
    request.max_error = 0.03;
    const table::DayPlan alone = table::planDay(family.day[0]->values, request);
    REQUIRE(family.plan.size() == 1);
    CAPTURE(name, alone.representation.name(), family.plan[0].representation.name());
    CHECK(family.plan[0].bytes == alone.bytes);
    CHECK(family.plan[0].table.number == alone.table.number);
  }
}

TEST_CASE("PlanFamily, SameForAnyNumberOfThreads") {
  const auto planned = [](std::size_t threads) {
    const tbb::global_control most(tbb::global_control::max_allowed_parallelism, threads);
    return Family({"clear", "layer"}, 0.05, 1.0).plan;
  };
  const auto one = planned(1), two = planned(2);
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(one[i].table.modes->texels == two[i].table.modes->texels);
    CHECK(one[i].table.number == two[i].table.number);
    CHECK(one[i].encoding == two[i].encoding);
  }
}

TEST_CASE("PlanFamily, CoefficientsForReadersOfThemHaveTheSameBands") {
  const SampledDay a(familySky("clear"), everyHours(1.0)), b(familySky("overcast"), everyHours(1.0));
  std::vector<table::FamilyMember> member = {{&a.values, {}}, {&b.values, {}}};
  member[0].request.max_error = 0.2;  // needs three bands
  member[1].request.max_error = 0.5;
  member[0].request.sh_bands = member[1].request.sh_bands = 3;
  const auto plan = table::planFamily(member);
  CHECK(plan[0].met);
  CHECK(plan[1].met);
  CHECK(!plan[0].table.modes);
  CHECK(plan[0].table.bands == plan[1].table.bands);
  member[0].request.max_error = 1e-3;  // cannot be kept: the least error is stated
  const auto least = table::planFamily(member);
  CHECK(!least[0].met);
  CHECK(least[0].predicted_error > 1e-3);
}

}  // namespace welkin::tests
