// SPDX-License-Identifier: Apache-2.0
#include "sky/table/day_fields.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "sky/base/error.h"

namespace welkin::table {
namespace {

constexpr auto kFieldOrders = static_cast<std::size_t>(model::IrradianceProjector::kOrders);

/// Instants darker than this share of the brightest are divided by that share.
constexpr double kDarkest = 1e-4;

/// Mean ambient irradiance over all normals, ground included, after desaturation.
Number3 meanAmbient(const model::SkyInstant& instant, const model::IrradianceField& field, double saturation) {
  const Number3 ground = instant.groundRadiance(field.moments.horizontal_irradiance);
  return det::desaturate(field.mean * instant.intensity() + ground * det::kHalfPi, saturation);
}

}  // namespace

FieldChannel::FieldChannel(const model::IrradianceField& field, int channel) : FieldChannel() {
  for (std::size_t i = 0; i < series.size(); ++i) series[i] = field.series[i][channel];
  for (std::size_t i = 0; i < moment.size(); ++i) moment[i] = field.moments.radiance_sh[i][channel];
}

FieldChannel& FieldChannel::add(const FieldChannel& other, double factor) {
  for (std::size_t i = 0; i < series.size(); ++i) series[i] += factor * other.series[i];
  for (std::size_t i = 0; i < moment.size(); ++i) moment[i] += factor * other.moment[i];
  return *this;
}

ErrorGrid::ErrorGrid() : cosine_(model::azimuthCosines(kColumns, model::IrradianceProjector::kOrders)) {
  for (int r = 0; r < model::IrradianceProjector::kRows; ++r)
    if (r == 0 || r % 2 == 1 || r + 1 == model::IrradianceProjector::kRows) {
      rows_.push_back(r);
      row_y_.push_back(det::yOfModeRow(r / (model::IrradianceProjector::kRows - 1.0)));
    }
}

Number3 ErrorGrid::Normal::inSunFrame() const {
  const double across = det::sineFromCosine(y);
  return {across * det::sineFromCosine(cos_alpha), y, across * cos_alpha};
}

double ErrorGrid::y(std::size_t point) const {
  const std::size_t upper = rows_.size() * kColumns;
  return point < upper ? row_y_[point / kColumns] : -row_y_[(point - upper) / kColumns];
}

ErrorGrid::Normal ErrorGrid::normal(std::size_t point) const {
  const std::size_t upper = rows_.size() * kColumns;
  const std::size_t i = point % upper;
  const double sign = point < upper ? 1.0 : -1.0;
  return {sign * row_y_[i / kColumns], sign * cosine_[i % kColumns * kFieldOrders + 1]};
}

std::vector<double> ErrorGrid::valuesOf(const FieldChannel& channel) const {
  std::vector<double> value;
  value.reserve(count());
  for (const int row : rows_)
    for (std::size_t column = 0; column < kColumns; ++column) {
      const double* series = channel.series.data() + static_cast<std::size_t>(row) * kFieldOrders;
      const double* cosine = cosine_.data() + column * kFieldOrders;
      double sum = 0.0;
      for (std::size_t m = 0; m < kFieldOrders; ++m) sum += series[m] * cosine[m];
      value.push_back(sum);
    }
  addLower(value, channel.moment[model::polarIndex(1, 0)] / det::kShLinear,
           channel.moment[model::polarIndex(1, 1)] / det::kShLinear);
  return value;
}

void ErrorGrid::addLower(std::vector<double>& upper, double vector_up, double vector_along) const {
  const std::size_t points = upper.size();
  for (std::size_t i = 0; i < points; ++i) {
    const Number3 n = normal(i).inSunFrame();
    upper.push_back(upper[i] - (n.y * vector_up + n.z * vector_along));
  }
}

DayFields::Error DayFields::errorOf(const DayInstant& at, const ErrorGrid& grid, std::span<const Number3> shape,
                                    const Number3& horizontal) const {
  const Number3 ground = sky->ground_albedo * horizontal;  // E / pi on a unit albedo, times pi (1 - y) / 2
  Number3 largest(0.0);
  for (std::size_t i = 0; i < shape.size(); ++i) {
    const double seen = 0.5 * (1.0 - grid.y(i));
    const Number3 off = det::desaturate((shape[i] + ground * seen) * at.intensity, at.saturation);
    for (int c = 0; c < 3; ++c) largest[c] = std::max(largest[c], std::abs(off[c]));
  }
  Error worst;
  for (int c = 0; c < 3; ++c)
    if (at.divisor[c] > 0.0) worst.value = std::max(worst.value, largest[c] / at.divisor[c]);
  return worst;
}

Number3 divisorOf(const Number3& mean, double brightest) {
  const double luminance = det::luminanceOf(mean);
  Number3 divisor(std::max(mean.x, luminance), std::max(mean.y, luminance), std::max(mean.z, luminance));
  for (int c = 0; c < 3; ++c) divisor[c] = std::max(divisor[c], kDarkest * brightest);
  return divisor;
}

double brightestOf(const model::Sky& sky) {
  constexpr double kQuarter_h = 0.25;
  double brightest = 0.0;
  for (const DayInstant& at : sampleDay(sky, hoursOfInterest(sky, kQuarter_h), 0.0, {}).instant)
    brightest = std::max({brightest, at.divisor.x, at.divisor.y, at.divisor.z});
  return brightest;
}

DayFields sampleDay(const model::Sky& sky, const std::vector<double>& time_h, double brightest,
                    const base::Progress& progress, const model::IrradianceRule& rule) {
  DayFields day{&sky, std::vector<DayInstant>(time_h.size())};
  const model::IrradianceProjector projector(sky.luminance, rule);
  tbb::parallel_for(std::size_t{0}, time_h.size(), [&](std::size_t i) {
    DayInstant& at = day.instant[i];
    const model::SkyInstant instant(sky, time_h[i]);
    at.time_h = time_h[i];
    at.field = projector.fieldOf(instant);
    at.intensity = instant.intensity();
    at.saturation = sky.ambient_saturation.at(time_h[i]);
    at.mean = meanAmbient(instant, at.field, at.saturation);
    at.divisor = divisorOf(at.mean, brightest);
    progress.step();
  });
  return day;
}

std::vector<double> hoursOfInterest(const model::Sky& sky, double step_h) {
  std::vector<double> hours = sky.sun.path.key_time_h;
  const int steps = static_cast<int>(std::ceil(format::kDay_h / step_h));
  for (int i = 0; i < steps; ++i) hours.push_back(i * step_h);
  const auto elevation = [&](double t) { return sky.sun.path.directionAt(t).y; };
  constexpr double kMinute = 1.0 / 60.0;
  constexpr double kSecond = 1.0 / 3600.0;
  for (int minute = 0; minute < 1440; ++minute) {
    const double t = minute * kMinute;
    const double here = elevation(t);
    if ((here < 0.0) != (elevation(t + kMinute) < 0.0)) {
      double low = t;
      double high = t + kMinute;
      while (high - low > kSecond) {
        const double middle = 0.5 * (low + high);
        ((elevation(middle) < 0.0) == (here < 0.0) ? low : high) = middle;
      }
      hours.push_back(0.5 * (low + high));
    }
    const double before = elevation(t - kMinute);
    const double after = elevation(t + kMinute);
    const double bend = before - 2.0 * here + after;
    if ((here - before) * (after - here) < 0.0 && bend != 0.0)  // Vertex of a parabola through three minutes.
      hours.push_back(t - 0.5 * kMinute * (after - before) / bend);
  }
  for (double& t : hours) t = format::wrapTime(t);
  std::sort(hours.begin(), hours.end());
  hours.erase(std::unique(hours.begin(), hours.end(), [&](double a, double b) { return b - a < kSecond; }),
              hours.end());
  return hours;
}

}  // namespace welkin::table
