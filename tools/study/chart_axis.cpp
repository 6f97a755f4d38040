// SPDX-License-Identifier: Apache-2.0
#include "study/chart_axis.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "sky/base/error.h"

namespace welkin::study {
namespace {

constexpr double kZeroBand = 0.06;        // share of an axis of decades that is set apart for zeros
constexpr double kMargin_decades = 0.06;  // between the outermost values and the frame
constexpr double kMargin = 0.03;          // the same of a linear axis, as a share of it
constexpr double kRounding = 1e-9;        // of a decade
constexpr int kTickDigits = 6;

}  // namespace

AxisScale::AxisScale(const Axis& axis, const std::vector<double>& values) : decades_(axis.scale == Scale::log) {
  if (values.empty())
    throw base::Error(base::ExitStatus::internal, fmt::format("chart: nothing to show along '{}'", axis.title));
  std::vector<double> shown = values;
  if (axis.range) shown.insert(shown.end(), {axis.range->low, axis.range->high});
  for (const double value : shown)
    if (!std::isfinite(value) || (decades_ && value < 0.0))
      throw base::Error(base::ExitStatus::internal, fmt::format("chart: {} along '{}'; allowed are finite numbers{}",
                                                                value, axis.title, decades_ ? " from 0" : ""));
  const bool zero = decades_ && std::ranges::find(shown, 0.0) != shown.end();
  if (decades_) std::erase(shown, 0.0);
  if (shown.empty()) shown = {1.0};
  low_ = std::ranges::min(shown);
  high_ = std::ranges::max(shown);
  if (!decades_) {
    const double margin = high_ > low_ ? kMargin * (high_ - low_) : low_ == 0.0 ? 1.0 : std::abs(low_) / 2.0;
    if (low_ != 0.0) low_ -= margin;  // points stay off the frame, unless it is at 0
    high_ += margin;
    return;
  }
  const double few = std::max(0.0, 1.0 - 2.0 * kMargin_decades - std::log10(high_ / low_)) / 2.0;  // at least a decade
  low_ *= std::pow(10.0, -kMargin_decades - few);
  high_ *= std::pow(10.0, kMargin_decades + few);
  addDecades(axis);
  if (!zero) return;
  const double decades = std::log10(high_ / low_);
  zero_ = low_ * std::pow(10.0, -decades * kZeroBand / 2.0);
  low_ *= std::pow(10.0, -decades * kZeroBand);
  addTick(zero_, inWords(0.0, axis.quantity, kTickDigits));
}

double AxisScale::position(double value) const {
  if (!decades_) return (value - low_) / (high_ - low_);
  return std::log10(coordinate(value) / low_) / std::log10(high_ / low_);
}

void AxisScale::addTick(double value, const std::string& label) {
  std::string format;  // gnuplot takes labels of ticks for formats of their numbers
  for (const char c : label) format.append(c == '%' ? 2 : 1, c);
  ticks_ += fmt::format("{}{} {:.17g} {}", ticks_.empty() ? "" : ", ", quoted(format), value, label.empty() ? 1 : 0);
  label_length_ = std::max(label_length_, label.size());
}

void AxisScale::addDecades(const Axis& axis) {
  const double low = std::log10(low_) - kRounding;
  const double high = std::log10(high_) + kRounding;
  const double decades = high - low;
  const double every = std::ceil(decades / 10.0);  // labelled decades
  for (double power = std::floor(low); power <= std::ceil(high); power += 1.0)
    for (int factor = 1; factor < 10; ++factor) {
      const double exponent = power + std::log10(static_cast<double>(factor));
      if (exponent < low || exponent > high || (factor > 1 && decades > 6.0)) continue;
      const bool labelled = factor == 1
                                ? std::fmod(power, every) == 0.0
                                : (decades <= 3.0 && (factor == 2 || factor == 5)) || (decades <= 1.2 && factor == 3);
      const double value = factor * std::pow(10.0, power);
      addTick(value, labelled ? inWords(value, axis.quantity, kTickDigits) : std::string());
    }
}

std::string AxisScale::commands(const std::string& name) const {
  std::string text = fmt::format("set {}range [{:.17g}:{:.17g}]\n", name, low_, high_);
  if (decades_) text += fmt::format("set logscale {0}\nset {0}tics ({1})\n", name, ticks_);
  return text;
}

std::string quoted(const std::string& words) {
  std::string text = "'";
  for (const char c : words) {
    if (c == '\'') text += c;
    text += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
  }
  return text + "'";
}

}  // namespace welkin::study
