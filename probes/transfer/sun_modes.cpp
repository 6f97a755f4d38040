// SPDX-License-Identifier: Apache-2.0
#include "probes/transfer/sun_modes.h"

#include <algorithm>
#include <cmath>

#include "sh/matrix.h"
#include "sh/modes.h"

namespace welkin::transfer {
namespace {

/// A matrix with a row for every probe and direction, and a column for every knot and channel.
std::vector<double> rowsOf(std::span<const ProbeTransfer* const> probes, std::size_t knots) {
  std::vector<double> rows;
  rows.reserve(probes.size() * kDirections * knots * 3);
  for (const ProbeTransfer* probe : probes)
    for (const auto& sun : probe->sun)
      for (std::size_t i = 0; i < knots; ++i) rows.insert(rows.end(), {sun[i].x, sun[i].y, sun[i].z});
  return rows;
}

/// The error of the rebuilt rows, clamped at 0.
SunModesError errorOf(std::span<const double> rows, std::size_t columns, std::span<const double> rebuilt) {
  SunModesError error;
  double sum = 0.0;
  for (std::size_t row = 0; row < rows.size(); row += columns) {
    double square = 0.0;
    for (std::size_t i = row; i < row + columns; ++i) {
      const double difference = std::max(rebuilt[i], 0.0) - rows[i];
      square += difference * difference;
      error.worst = std::max(error.worst, std::abs(difference));
    }
    sum += square;
    error.worst_row = std::max(error.worst_row, std::sqrt(square / static_cast<double>(columns)));
  }
  if (!rows.empty()) error.rms = std::sqrt(sum / static_cast<double>(rows.size()));
  return error;
}

}  // namespace

SunModesFit fitSunModes(std::span<const ProbeTransfer* const> probes, const LightTrack& sun, const LightTrack& moon,
                        std::size_t count) {
  SunModesFit fit;
  fit.modes.sun_time_h = sun.time_h;
  fit.modes.moon_time_h = moon.time_h;
  fit.coefficient.resize(probes.size());
  const std::size_t columns = 3 * fit.modes.knots();
  const std::vector<double> rows = rowsOf(probes, fit.modes.knots());
  const sh::Modes modes = sh::leadingModes({rows, columns}, {}, count);
  for (std::size_t i = 0; i < modes.vector.size(); i += 3)
    fit.modes.value.emplace_back(modes.vector[i], modes.vector[i + 1], modes.vector[i + 2]);

  if (modes.count() == 0) {
    fit.error.push_back(errorOf(rows, columns, std::vector<double>(rows.size(), 0.0)));
    return fit;
  }
  const auto directions = sh::asRows(modes.vector, columns);
  const sh::RowMatrix along = sh::asRows(rows, columns) * directions.transpose();  // row, mode
  for (std::size_t p = 0; p < probes.size(); ++p)
    for (std::size_t b = 0; b < kDirections; ++b) {
      const auto coefficient = along.row(static_cast<Eigen::Index>(p * kDirections + b));
      fit.coefficient[p][b].assign(coefficient.begin(), coefficient.end());
    }
  std::vector<double> rebuilt(rows.size(), 0.0);
  fit.error.push_back(errorOf(rows, columns, rebuilt));
  for (Eigen::Index m = 0; m < directions.rows(); ++m) {
    sh::asRows(rebuilt, columns).noalias() += along.col(m) * directions.row(m);
    fit.error.push_back(errorOf(rows, columns, rebuilt));
  }
  return fit;
}

std::size_t modesFor(const SunModesFit& fit, double max_error) {
  for (std::size_t m = 0; m < fit.error.size(); ++m)
    if (fit.error[m].worst_row <= max_error) return m;
  return fit.modes.count();
}

SunModesFit firstModes(SunModesFit fit, std::size_t count) {
  count = std::min(count, fit.modes.count());
  fit.modes.value.resize(count * fit.modes.knots());
  for (SunCoefficients& probe : fit.coefficient)
    for (auto& direction : probe) direction.resize(count);
  fit.error.resize(count + 1);
  return fit;
}

std::vector<Number3> modesAt(const SunModes& modes, LightOf light, double time_h) {
  std::vector<Number3> result(modes.count(), Number3(0.0));
  const auto& times = light == LightOf::sun ? modes.sun_time_h : modes.moon_time_h;
  if (times.empty()) return result;
  const TrackPlace place = placeOnTrack(times, time_h);
  const std::size_t first = light == LightOf::sun ? 0 : modes.sun_time_h.size();
  for (std::size_t m = 0; m < result.size(); ++m) {
    const Number3* row = modes.value.data() + m * modes.knots() + first;
    result[m] = row[place.before] * (1.0 - place.share) + row[place.after] * place.share;
  }
  return result;
}

Number3 sunTransfer(std::span<const double> coefficient, std::span<const Number3> mode) {
  Number3 sum(0.0);
  for (std::size_t m = 0; m < mode.size(); ++m) sum += mode[m] * coefficient[m];
  return {std::max(sum.x, 0.0), std::max(sum.y, 0.0), std::max(sum.z, 0.0)};
}

}  // namespace welkin::transfer
