// SPDX-License-Identifier: Apache-2.0
#include "sky/model/indicatrix_table.h"

#include <algorithm>
#include <cmath>

namespace welkin::model {
namespace {

const double kEnd = std::sqrt(0.5);

}  // namespace

IndicatrixTable::IndicatrixTable(double d) {
  // Hermite's cubics leave h^4 / 384 of the fourth derivative. That is (2 d)^4 at the sun and less than 1.4 times as
  // much elsewhere once -d is past 1. Below that the arc sine's own curvature counts: 24 at the right angle.
  const double bend = std::max(2.0 * -d, 4.0);
  const double h = std::sqrt(std::sqrt(384.0 * kError / 1.4)) / bend;
  const int intervals = static_cast<int>(std::ceil(kEnd / h));
  intervals_per_unit_ = intervals / kEnd;
  from_sun_ = tabulate(d, 1.0, intervals);
  from_antipode_ = tabulate(-d, det::exp(d * det::kPi), intervals);
}

std::vector<IndicatrixTable::Cubic> IndicatrixTable::tabulate(double d, double scale, int intervals) {
  const double h = kEnd / intervals;
  double value[2];
  double slope[2];  // Slopes times h.
  const auto evaluate = [&](int i, int to) {
    const double x = h * i;
    const double cosine = std::sqrt(1.0 - x * x);
    value[to] = scale * det::exp(2.0 * d * det::atan(x, cosine));
    slope[to] = h * 2.0 * d * value[to] / cosine;
  };
  std::vector<Cubic> cubics;
  evaluate(0, 1);
  for (int i = 0; i < intervals; ++i) {
    value[0] = value[1];
    slope[0] = slope[1];
    evaluate(i + 1, 1);
    const double rise = value[1] - value[0];
    cubics.push_back({value[0], slope[0], 3.0 * rise - 2.0 * slope[0] - slope[1], slope[0] + slope[1] - 2.0 * rise});
  }
  return cubics;
}

}  // namespace welkin::model
