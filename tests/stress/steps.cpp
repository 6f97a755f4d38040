// SPDX-License-Identifier: Apache-2.0
#include "steps.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/polar_frame.h"
#include "sensitivity.h"

namespace welkin::stress {
namespace {

using det::Number3;
using model::SkyInstant;
using tests::Shown;
using tests::Step;

constexpr double kSlack = 1e-5;  // rounding of float results
/// The ground's radiance starts from 0 when the lights rise. Its scale is at least this share of their normal
/// irradiance times the albedo.
constexpr double kShare = 0.01;

double largestOf(const Number3& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

Shown groundOf(const model::Sky& model, const WelkinSkySample& sample) {
  double lights = largestOf(model.sun.normalIrradianceAt(sample.time_h));
  if (model.moon) lights += largestOf(model.moon->normalIrradianceAt(sample.time_h));
  const float* g = sample.ground_radiance;
  return {{double{g[0]}, double{g[1]}, double{g[2]}}, kShare * largestOf(model.ground_albedo) * lights};
}

/// The model's dome, the runtime's dome and its irradiance. A tint of 0 may hide the channel that gives the runtime's
/// dome its rounding. The model has the same channel and gives its brightness.
std::vector<Shown> shownTowards(const SkyInstant& instant, const welkin::Sky& baked, const WelkinSkySample& sample,
                                const Number3& direction) {
  const Shown dome = tests::domeOf(instant, direction);
  std::vector<Shown> values = tests::seen(baked, sample, direction);
  values[0].size = std::max(values[0].size, dome.size);
  values.push_back(dome);
  return values;
}

double moveOf(const model::LightPath& path, const Step& step) {
  return det::angleBetween(path.directionAt(step.low), path.directionAt(step.high));
}

/// Relative change of the artist's curves over a step. A sky may change as much.
double changeOfCurves(const model::Sky& s, const Step& step) {
  const auto change = [](const Number3& a, const Number3& b) {
    return largestOf(a - b) / std::max({largestOf(a), largestOf(b), 1e-300});
  };
  // An albedo may leave only the channel of a light that changes most.
  double lights = change(s.sun.normalIrradianceAt(step.low), s.sun.normalIrradianceAt(step.high));
  if (s.moon) lights += change(s.moon->normalIrradianceAt(step.low), s.moon->normalIrradianceAt(step.high));
  const double sum = lights / kShare + change(Number3(s.intensity.at(step.low)), Number3(s.intensity.at(step.high))) +
                     change(s.polarising_tint.colourAt(step.low), s.polarising_tint.colourAt(step.high)) +
                     20.0 * std::abs(s.ambient_saturation.at(step.low) - s.ambient_saturation.at(step.high));
  return sum + 4.0 * 3600.0 * (step.high - step.low);  // keys of the table may be a second apart, too
}

/// Keys are at least a second apart, so in a second a curve changes by no more than its largest key, or by one
/// denormal.
tests::Fault steepCurve(const model::Sky& s, const Step& step) {
  for (const base::Curve* curve : {&s.intensity, &s.ambient_saturation, &s.sun.illuminance}) {
    const double largest = *std::max_element(curve->value.begin(), curve->value.end());
    const double change = std::abs(curve->at(step.high) - curve->at(step.low));
    constexpr double kSmallest = std::numeric_limits<double>::denorm_min();
    if (change > largest * (3600.01 * (step.high - step.low) + 1e-9) + kSmallest)
      return fmt::format("a curve up to {} changes by {} between {} and {} h", largest, change, step.low, step.high);
  }
  return {};
}

Searched judge(const Step& step, double allowed, const std::string& unit) {
  constexpr double kTooSteep = 0.1;
  if (allowed > kTooSteep) return {};
  if (step.height <= allowed) return {{}, true};
  return {fmt::format("a step of {} where {} is allowed, between {} and {} {}", step.height, allowed, step.low,
                      step.high, unit),
          true};
}

}  // namespace

Searched searchTime(const model::Sky& model, const welkin::Sky& baked, double from_h, double to_h,
                    const Number3& direction) {
  constexpr double kResolution_h = 1e-9;
  constexpr double kColumns = 8.0 / 24.0 * 14.0 * 15.0 / model::kGradientDelta;  // change of chromaticities an hour
  const Number3 directions[] = {{0, 1, 0}, {0.6, 0.0, -0.8}, direction};
  const auto shown = [&](double time_h) {
    const SkyInstant instant(model, time_h);
    WelkinSkySample sample{};
    baked.sample(time_h, sample);
    const Shown ground = groundOf(model, sample);
    std::vector<Shown> values = {ground};
    for (const Number3& d : directions) {
      auto towards = shownTowards(instant, baked, sample, d);
      towards[1].size += det::kPi * ground.size;
      values.insert(values.end(), towards.begin(), towards.end());
    }
    return values;
  };
  const Step step = tests::largestStep(shown, from_h, to_h, kResolution_h);
  if (const tests::Fault fault = steepCurve(model, step); !fault.empty()) return {fault, true};
  const SkyInstant before(model, step.low);
  const SkyInstant after(model, step.high);
  double slope = 0.0;
  for (const Number3& d : directions) slope = std::max({slope, sensitivityAt(before, d), sensitivityAt(after, d)});
  const double sun = moveOf(model.sun.path, step);
  // A table is in the frame of the sun's azimuth. Its error between keys turns with the azimuth, by the sun's move over
  // the sun's distance from the pole, and fades within kPoleFade of the pole.
  const double from_pole =
      std::min(det::horizontalLength(before.sunDirection()), det::horizontalLength(after.sunDirection()));
  const double turn = 2.0 * sun / std::max(from_pole, core::kPoleFade);
  const double moon = model.moon ? moveOf(model.moon->path, step) : 0.0;
  return judge(step,
               kSlack + (step.high - step.low) * kColumns + changeOfCurves(model, step) +
                   (sun + kFloatDirection) * slope + (sun + moon) / kShare + turn,
               "h");
}

Searched searchArc(const model::Sky& model, const welkin::Sky& baked, double time_h, double azimuth_rad,
                   double from_rad) {
  constexpr double kResolution_rad = 1e-6;
  const SkyInstant instant(model, time_h);
  WelkinSkySample sample{};
  baked.sample(time_h, sample);
  const auto towards = [&](double e) { return det::directionOf(azimuth_rad, e); };
  const Step step = tests::largestStep([&](double e) { return shownTowards(instant, baked, sample, towards(e)); },
                                       from_rad, det::kPi - 1e-6, kResolution_rad);
  const double slope = std::max(sensitivityAt(instant, towards(step.low)), sensitivityAt(instant, towards(step.high)));
  return judge(step, kSlack + (step.high - step.low + kFloatDirection) * slope, fmt::format("rad at {} h", time_h));
}

}  // namespace welkin::stress
