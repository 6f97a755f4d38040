// SPDX-License-Identifier: Apache-2.0
#include "sky/model/irradiance.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "sh/basis.h"

namespace welkin::model {
namespace {

constexpr double kFieldTolerance = 1e-4;  // of the quadrature; with the extra panels its error is far below it

}  // namespace

Number3 IrradianceField::excess(double y, double cos_alpha) const {
  const double across = det::sineFromCosine(y);
  return (moments.radiance_sh[polarIndex(1, 0)] * y + moments.radiance_sh[polarIndex(1, 1)] * (across * cos_alpha)) /
         det::kShLinear;
}

const IrradianceRule& irradianceRuleFor(double error) {
  const auto* last = std::end(kIrradianceRules);
  while (last - 1 != std::begin(kIrradianceRules) && !((last - 1)->error <= error)) --last;
  return *(last - 1);
}

IrradianceProjector::IrradianceProjector(const LuminanceModel& model, const IrradianceRule& rule)
    : quadrature_(kFieldTolerance, kOrders, model.d), recurrence_(kBands) {
  for (int r = 0; r < kRows; ++r) {
    const double y = det::yOfModeRow(r / (kRows - 1.0));
    row_.push_back({y, det::sineFromCosine(y)});
  }
  for (int i = 1; i < rule.panels; ++i) extra_.push_back(det::kHalfPi * i / rule.panels);
  if (model.d >= -IndicatrixTable::kSteepest) table_.emplace(model.d);
}

void IrradianceProjector::addCircle(const Latitude& at, const std::vector<Number3>& order,
                                    IrradianceField& field) const {
  const double weight = 2.0 * at.weight / det::kPi;
  std::size_t waiting = kRows;  // a row that the surface's plane cuts, and that waits for a second one
  for (std::size_t r = 0; r < row_.size(); ++r) {
    const double a = at.sine * row_[r].y;
    const double b = at.cosine * row_[r].across;
    if (a <= -b) continue;  // all of the circle is behind the surface
    if (a >= b) {           // all of it is before
      Number3* sum = field.series.data() + r * kOrders;
      sum[0] += order[0] * (weight * det::kPi * a);
      sum[1] += order[1] * (weight * det::kPi * b);
    } else if (waiting == kRows) {
      waiting = r;
    } else {
      addClipped(at, weight, {waiting, r}, order, field);
      waiting = kRows;
    }
  }
  if (waiting != kRows) addClipped(at, weight, {waiting, waiting}, order, field);
}

/// Rows whose surface's plane cuts the circle: two side by side, or one twice, which is then added once.
void IrradianceProjector::addClipped(const Latitude& at, double weight, std::array<std::size_t, 2> row,
                                     const std::vector<Number3>& order, IrradianceField& field) const {
  using det::Number2;
  const Number2 a = at.sine * Number2{row_[row[0]].y, row_[row[1]].y};
  const Number2 b = at.cosine * Number2{row_[row[0]].across, row_[row[1]].across};
  const Number2 cosine = -a / b;  // of the azimuth at which the surface's plane cuts the circle
  const Number2 sine = det::sqrt((1.0 - cosine) * (1.0 + cosine));
  const Number2 clip = det::atan(sine, cosine);
  Number2 factor[kOrders];
  Number2 current = 2.0 * cosine * sine;  // sin(m clip)
  Number2 before = sine;                  // sin((m - 1) clip) / (m - 1)
  Number2 last = sine;                    // sin((m - 1) clip)
  factor[0] = weight * (a * clip + b * sine);
  factor[1] = weight * (2.0 * a * sine + b * (clip + 0.5 * current));
  Number2 here = current / 2.0;  // sin(m clip) / m
  for (int m = 2; m < kOrders; ++m) {
    const Number2 next = 2.0 * cosine * current - last;
    const Number2 after = next / (m + 1.0);
    factor[m] = weight * (2.0 * a * current / static_cast<double>(m) + b * (before + after));
    before = here;
    here = after;
    last = current;
    current = next;
  }
  for (std::size_t k = 0; k < (row[0] == row[1] ? 1 : 2); ++k) {
    Number3* sum = field.series.data() + row[k] * kOrders;
    for (std::size_t m = 0; m < kOrders; ++m) sum[m] += order[m] * factor[m][k];
  }
}

IrradianceField IrradianceProjector::fieldOf(const SkyInstant& instant) const {
  IrradianceField field;
  field.series.assign(row_.size() * kOrders, Number3(0.0));
  field.moments.radiance_sh.assign(polarIndex(kBands, 0), Number3(0.0));
  std::vector<double> factor(static_cast<std::size_t>(sh::coefficientCount(kBands)));
  std::vector<Number3> order(kOrders);

  const SunFrame sun(instant, table_ ? &*table_ : nullptr);
  quadrature_.forEachLatitude(sun, extra_, [&](const Latitude& at) {
    std::fill(order.begin(), order.end(), Number3(0.0));
    field.moments.evaluations += quadrature_.addOrders(sun, at, order);
    addCircle(at, order, field);
    recurrence_.evaluate(at.sine, at.cosine, factor);
    addMoments(at, order, factor, kBands, field.moments);
  });
  field.mean = field.moments.radiance_sh[0] * (det::kPi * det::kShConstant);
  return field;
}

double IrradianceProjector::truncationOf(const IrradianceField& field, int channel) const {
  double most = 0.0;
  for (std::size_t r = 0; r < row_.size(); ++r) {
    const Number3* series = field.series.data() + r * kOrders;
    const auto around = [&](int m) { return 0.5 * (std::abs(series[m][channel]) + std::abs(series[m - 1][channel])); };
    const double last = around(kOrders - 1);
    const double middle = around(kOrders / 2);
    // What m^-p leaves is m / (p - 1) times its last one; half the orders before, it was 2^p times as large.
    const double share = middle > 0.0 ? std::clamp(4.0 * last / middle, 1.0 / 3.0, 1.0) : 1.0;
    most = std::max(most, share * last * kOrders);
  }
  return field.mean[channel] > 0.0 ? most / field.mean[channel] : 0.0;
}

std::vector<double> azimuthCosines(int columns, int orders) {
  std::vector<double> cosine;
  for (int i = 0; i < columns; ++i)
    for (int m = 0; m < orders; ++m)
      cosine.push_back(det::cos(det::kPi * static_cast<double>(i * m % (2 * (columns - 1))) / (columns - 1)));
  return cosine;
}

}  // namespace welkin::model
