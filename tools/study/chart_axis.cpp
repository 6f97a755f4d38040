// SPDX-License-Identifier: Apache-2.0
#include "study/chart_axis.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "sky/base/error.h"

namespace welkin::study {
namespace {

constexpr double kZeroBand = 0.06;        // share of an axis of decades that is set apart for zeros
constexpr double kMargin_decades = 0.06;  // between the outermost values and the frame
constexpr double kMostSteps = 8.0;
constexpr double kClearance_steps = 0.15;
constexpr double kRounding = 1e-9;  // of a step
constexpr int kTickDigits = 6;

// The least of 1, 2, 2.5, 5 times a power of ten that is not below `least`; a whole number for `whole`.
double niceStep(double least, bool whole) {
  if (whole && least <= 1.0) return 1.0;
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 2.5, 5.0}) {
    const double step = factor * power;
    if (step >= least * (1.0 - kRounding) && !(whole && step != std::floor(step))) return step;
  }
  return 10.0 * power;
}

}  // namespace

AxisScale::AxisScale(const Axis& axis, const std::vector<double>& values) : scale_(axis.scale) {
  std::vector<double> shown = values;
  if (axis.range) shown.insert(shown.end(), {axis.range->low, axis.range->high});
  if (values.empty())
    throw base::Error(base::ExitStatus::internal, fmt::format("chart: nothing to show along '{}'", axis.title));
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  bool zero = false;
  for (const double value : shown) {
    if (!std::isfinite(value) || (scale_ == Scale::log && value < 0.0)) {
      throw base::Error(base::ExitStatus::internal,
                        fmt::format("chart: {} along '{}'; allowed are finite numbers{}", value, axis.title,
                                    scale_ == Scale::log ? " from 0" : ""));
    }
    if (scale_ == Scale::log && value == 0.0) {
      zero = true;
      continue;
    }
    low = std::min(low, value);
    high = std::max(high, value);
  }
  if (low > high) low = high = 1.0;  // nothing but zeros
  if (scale_ == Scale::linear) {
    const bool whole =
        high - low > 2.0 && std::ranges::all_of(shown, [](double value) { return value == std::floor(value); });
    markLinear(axis, low, high, whole);
  } else {
    markDecades(axis, low, high, zero);
  }
}

double AxisScale::position(double value) const {
  if (scale_ == Scale::linear) return (value - low_) / (high_ - low_);
  if (value == 0.0) return start_ / 2.0;
  return start_ + (1.0 - start_) * (std::log10(value) - low_) / (high_ - low_);
}

void AxisScale::markLinear(const Axis& axis, double low, double high, bool whole) {
  if (low == high) {
    const double around = low == 0.0 ? 1.0 : std::abs(low) / 2.0;
    low -= around;
    high += around;
  }
  const double step = niceStep((high - low) / kMostSteps, whole);
  const double first = std::floor(low / step + kRounding);
  const double last = std::ceil(high / step - kRounding);
  // Points stay off the frame, unless it is at 0.
  low_ = (low / step - first < kClearance_steps && first != 0.0 ? first - 0.5 : first) * step;
  high_ = (last - high / step < kClearance_steps && last != 0.0 ? last + 0.5 : last) * step;
  for (double i = first; i <= last; i += 1.0) {
    ticks_.push_back({position(i * step), inWords(i * step, axis.quantity, kTickDigits)});
  }
}

void AxisScale::markDecades(const Axis& axis, double low, double high, bool zero) {
  low_ = std::log10(low) - kMargin_decades;
  high_ = std::log10(high) + kMargin_decades;
  if (high_ - low_ < 1.0) {  // at least a decade, so that a tick is seen
    const double middle = (low_ + high_) / 2.0;
    low_ = middle - 0.5;
    high_ = middle + 0.5;
  }
  if (zero) {
    start_ = kZeroBand;
    ticks_.push_back({kZeroBand / 2.0, inWords(0.0, axis.quantity, kTickDigits)});
  }
  const double decades = high_ - low_;
  const double every = std::ceil(decades / 10.0);  // labelled decades
  for (double power = std::floor(low_); power <= std::ceil(high_); power += 1.0) {
    for (int factor = 1; factor < 10; ++factor) {
      const double exponent = power + std::log10(static_cast<double>(factor));
      if (exponent < low_ - kRounding || exponent > high_ + kRounding) continue;
      const bool labelled = factor == 1
                                ? std::fmod(power, every) == 0.0
                                : (decades <= 3.0 && (factor == 2 || factor == 5)) || (decades <= 1.2 && factor == 3);
      if (factor > 1 && decades > 6.0) continue;
      const double value = factor * std::pow(10.0, power);
      ticks_.push_back({start_ + (1.0 - start_) * (exponent - low_) / decades,
                        labelled ? inWords(value, axis.quantity, kTickDigits) : std::string(), factor > 1});
    }
  }
}

}  // namespace welkin::study
