// SPDX-License-Identifier: Apache-2.0
#include "sky/bake/certify_blends.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>

#include "sky/bake/measured_instant.h"
#include "sky/base/error.h"

namespace welkin::bake {
namespace {

constexpr std::array<double, 3> kWeights = {0.25, 0.5, 0.75};
constexpr double kQuarter_h = 0.25;

/// A sky at the hours that all of its family are measured at.
struct SampledSky {
  SampledSky(const FamilySky& sky, const std::vector<double>& time_h, const table::ErrorGrid& grid,
             const base::Progress& progress)
      : of(sky),
        fields(table::sampleDay(sky.sky, time_h, 0.0, progress)),
        values(fields, grid),
        quarters(table::sampleDay(sky.sky, table::hoursOfInterest(sky.sky, kQuarter_h), 0.0, {})) {}

  const FamilySky& of;
  table::DayFields fields;
  table::DayValues values;
  table::DayFields quarters;
};

/// table::brightestOf the blend of two skies.
double brightestOfBlend(const SampledSky& a, const SampledSky& b, double weight) {
  double brightest = 0.0;
  for (std::size_t i = 0; i < a.quarters.instant.size(); ++i) {
    const Number3 divisor = table::divisorOf(mix(a.quarters.instant[i].mean, b.quarters.instant[i].mean, weight), 0.0);
    brightest = std::max({brightest, divisor.x, divisor.y, divisor.z});
  }
  return brightest;
}

WelkinSkySample blendOf(const WelkinSkySample& a, const WelkinSkySample& b, double weight) {
  WelkinSkySample blended{};
  if (welkin_sample_blend(&a, &b, static_cast<float>(weight), &blended) != WELKIN_OK)
    throw base::Error(base::ExitStatus::internal,
                      fmt::format("the certificate of blends: {}", welkin_argument_error()));
  return blended;
}

/// Errors of one instant, by weight.
using BlendedErrors = std::array<InstantErrors, kWeights.size()>;

BlendedErrors errorsOf(const SampledSky& a, const SampledSky& b, std::size_t instant) {
  const table::DayInstant& at = a.fields.instant[instant];
  const ModelInstant model_a(a.of.sky, at), model_b(b.of.sky, b.fields.instant[instant]);
  const WelkinSkySample sample_a = sampleOf(a.of.opened, at.time_h), sample_b = sampleOf(b.of.opened, at.time_h);
  std::array<WelkinSkySample, kWeights.size()> blended;
  for (std::size_t w = 0; w < kWeights.size(); ++w) blended[w] = blendOf(sample_a, sample_b, kWeights[w]);
  BlendedErrors errors;
  const table::ErrorGrid& grid = *a.values.grid;
  for (std::size_t p = 0; p < grid.count(); ++p) {
    const Number3 n = model_a.inWorld(grid.normal(p).inSunFrame(), p % 2 == 0 ? 1.0 : -1.0);
    const Number3 one = model_a.irradiance(n, a.values.value[instant * grid.count() + p]);
    const Number3 other = model_b.irradiance(n, b.values.value[instant * grid.count() + p]);
    for (std::size_t w = 0; w < kWeights.size(); ++w)
      errors[w].at(n, irradianceOf(a.of.opened, blended[w], n), mix(one, other, kWeights[w]));
  }
  return errors;
}

BlendError measurePair(const SampledSky& a, const SampledSky& b, const base::Progress& progress) {
  const auto& instants = a.fields.instant;
  std::vector<BlendedErrors> errors(instants.size());
  tbb::parallel_for(std::size_t{0}, errors.size(), [&](std::size_t i) {
    errors[i] = errorsOf(a, b, i);
    progress.step();
  });
  std::array<double, kWeights.size()> brightest;
  for (std::size_t w = 0; w < kWeights.size(); ++w) brightest[w] = brightestOfBlend(a, b, kWeights[w]);
  BlendError worst;
  for (std::size_t i = 0; i < instants.size(); ++i) {
    worst.day.push_back({instants[i].time_h, 0.0});
    for (std::size_t w = 0; w < kWeights.size(); ++w) {
      const Number3 mean = mix(instants[i].mean, b.fields.instant[i].mean, kWeights[w]);
      const Number3 divisor = table::divisorOf(mean, brightest[w]);
      for (int c = 0; c < 3; ++c) {
        if (!(divisor[c] > 0.0)) continue;
        const double error = errors[i][w].error[c] / divisor[c];
        worst.day.back().error = std::max(worst.day.back().error, error);
        if (error <= worst.max_error) continue;
        worst.max_error = error;
        worst.weight = kWeights[w];
        worst.time_h = instants[i].time_h;
        worst.normal = errors[i][w].normal[c];
        worst.channel = c;
      }
    }
  }
  return worst;
}

}  // namespace

std::vector<BlendError> certifyBlends(std::span<const FamilySky> family, const base::Progress& progress,
                                      double step_h) {
  std::vector<double> hours;
  for (const FamilySky& sky : family) {
    const auto of_sky = instantsOf(sky.sky, sky.table, step_h);
    hours.insert(hours.end(), of_sky.begin(), of_sky.end());
  }
  std::sort(hours.begin(), hours.end());
  hours.erase(std::unique(hours.begin(), hours.end()), hours.end());
  const std::size_t pairs = family.size() * (family.size() - 1) / 2;
  const base::Progress stage = progress.stage("certificate of blends", hours.size() * (family.size() + pairs));
  const table::ErrorGrid grid;
  std::vector<SampledSky> skies;
  skies.reserve(family.size());
  for (const FamilySky& sky : family) skies.emplace_back(sky, hours, grid, stage);
  std::vector<BlendError> errors;
  for (std::size_t i = 0; i < skies.size(); ++i)
    for (std::size_t j = i + 1; j < skies.size(); ++j) {
      errors.push_back(measurePair(skies[i], skies[j], stage));
      errors.back().first = i;
      errors.back().second = j;
    }
  return errors;
}

}  // namespace welkin::bake
