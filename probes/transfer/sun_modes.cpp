// SPDX-License-Identifier: Apache-2.0
#include "probes/transfer/sun_modes.h"

#include <algorithm>
#include <cmath>

#include "sh/modes.h"

namespace welkin::probes {
namespace {

/// A row for every probe, direction and channel, in this order; a column for every knot.
std::vector<double> rowsOf(std::span<const ProbeTransfer* const> probes, std::size_t knots) {
  std::vector<double> rows;
  rows.reserve(probes.size() * kDirections * 3 * knots);
  for (const ProbeTransfer* probe : probes)
    for (const auto& sun : probe->sun)
      for (int c = 0; c < 3; ++c)
        for (std::size_t i = 0; i < knots; ++i) rows.push_back(sun[i][c]);
  return rows;
}

SunModesError errorOf(const std::vector<double>& rows, const sh::Modes& modes, std::size_t count,
                      const std::vector<double>& coefficient) {
  SunModesError error;
  const std::size_t knots = modes.dimension;
  double sum = 0.0;
  for (std::size_t row = 0; row * knots < rows.size(); ++row) {
    double square = 0.0;
    for (std::size_t i = 0; i < knots; ++i) {
      double rebuilt = 0.0;
      for (std::size_t m = 0; m < count; ++m) rebuilt += coefficient[row * modes.count() + m] * modes.row(m)[i];
      const double difference = std::max(rebuilt, 0.0) - rows[row * knots + i];
      square += difference * difference;
      error.worst = std::max(error.worst, std::abs(difference));
    }
    sum += square;
    error.worst_row = std::max(error.worst_row, std::sqrt(square / static_cast<double>(knots)));
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
  const std::size_t knots = fit.modes.knots();
  const std::vector<double> rows = rowsOf(probes, knots);
  const sh::Modes modes = sh::leadingModes({rows, knots}, {}, count);
  fit.modes.value = modes.vector;

  std::vector<double> coefficient(rows.size() / std::max<std::size_t>(knots, 1) * modes.count());
  std::vector<double> residual(knots);
  std::size_t row = 0;
  for (std::size_t p = 0; p < probes.size(); ++p)
    for (auto& direction : fit.coefficient[p]) {
      direction.resize(modes.count());
      for (int c = 0; c < 3 && knots > 0; ++c, ++row) {
        const auto of_row = std::span(coefficient).subspan(row * modes.count(), modes.count());
        sh::projectOntoModes(modes, std::span(rows).subspan(row * knots, knots), of_row, residual);
        for (std::size_t m = 0; m < modes.count(); ++m) direction[m][c] = of_row[m];
      }
    }
  for (std::size_t m = 0; m <= modes.count(); ++m) fit.error.push_back(errorOf(rows, modes, m, coefficient));
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
  for (auto& probe : fit.coefficient)
    for (auto& direction : probe) direction.resize(count);
  fit.error.resize(count + 1);
  return fit;
}

std::vector<double> modesAt(const SunModes& modes, LightOf light, double time_h) {
  std::vector<double> result(modes.count(), 0.0);
  const auto& times = light == LightOf::sun ? modes.sun_time_h : modes.moon_time_h;
  if (times.empty()) return result;
  const TrackPlace place = placeOnTrack(times, time_h);
  const std::size_t first = light == LightOf::sun ? 0 : modes.sun_time_h.size();
  for (std::size_t m = 0; m < result.size(); ++m) {
    const double* row = modes.value.data() + m * modes.knots() + first;
    result[m] = row[place.before] * (1.0 - place.share) + row[place.after] * place.share;
  }
  return result;
}

Number3 sunTransfer(std::span<const Number3> coefficient, std::span<const double> mode) {
  Number3 sum(0.0);
  for (std::size_t m = 0; m < mode.size(); ++m) sum += coefficient[m] * mode[m];
  return {std::max(sum.x, 0.0), std::max(sum.y, 0.0), std::max(sum.z, 0.0)};
}

}  // namespace welkin::probes
