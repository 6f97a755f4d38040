// SPDX-License-Identifier: Apache-2.0
#include "sky/table/representation.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include "format/day_numbers.h"
#include "sh/minimax.h"
#include "sh/multiple_cosines.h"

namespace welkin::table {
namespace {

/// Irradiance of the coefficients (l, m >= 0) of `bands` bands at the grid's normals, by normal and coefficient.
std::vector<double> coefficientValues(const ErrorGrid& grid, int bands) {
  const sh::LatitudeRecurrence recurrence(bands);
  std::vector<double> factor(static_cast<std::size_t>(sh::coefficientCount(bands)));
  std::vector<double> values;
  for (std::size_t p = 0; p < grid.count(); ++p) {
    const auto normal = grid.normal(p);
    recurrence.evaluate(normal.y, det::sineFromCosine(normal.y), factor);
    for (int l = 0; l < bands; ++l) {
      sh::MultipleCosines cosine(normal.cos_alpha);
      for (int m = 0; m <= l; ++m, cosine.advance())
        values.push_back(det::cosineLobe(l) * factor[static_cast<std::size_t>(sh::indexOf(l, m))] * cosine.value());
    }
  }
  return values;
}

/// Irradiance at the grid's normals.
std::vector<Number3> irradianceOf(const Representation& r, std::span<const Number3> weight, std::size_t points) {
  std::vector<Number3> irradiance(points);
  for (std::size_t p = 0; p < points; ++p) {
    const double* value = r.values.data() + p * r.functions;
    Number3 sum(0.0);
    for (std::size_t k = 0; k < r.functions; ++k) sum += weight[k] * value[k];
    irradiance[p] = sum;
  }
  return irradiance;
}

/// Horizontal irradiance. 0 if the table holds none.
Number3 horizontalOf(const Representation& r, std::span<const Number3> weight) {
  Number3 sum(0.0);
  for (std::size_t k = 0; k < r.horizontal.size(); ++k) sum += weight[k] * r.horizontal[k];
  return r.rows > r.functions ? weight[r.functions] : sum;
}

}  // namespace

DayValues::DayValues(const DayFields& day_, const ErrorGrid& grid_)
    : day(&day_), grid(&grid_), value(day_.instant.size() * grid_.count()) {
  vector.resize(3 * day->instant.size());
  tbb::parallel_for(std::size_t{0}, day->instant.size(), [&](std::size_t i) {
    for (int c = 0; c < 3; ++c) {
      const FieldChannel channel(day->instant[i].field, c);
      vector[3 * i + static_cast<std::size_t>(c)] = DayModes::vectorOf(channel);
      const auto of_channel = grid->valuesOf(channel);
      for (std::size_t p = 0; p < of_channel.size(); ++p) value[i * of_channel.size() + p][c] = of_channel[p];
    }
  });
}

std::string Representation::name() const {
  if (!modes) return fmt::format("{} bands{}", bands, reconstruction == Reconstruction::fitted ? ", fitted" : "");
  return fmt::format("{} modes, map {} x {}", modes->count, modes->columns, modes->rows);
}

std::size_t Representation::fixedBytes() const {
  return modes ? 2 * modes->texels.size() + 4 * modes->polar_sh.size() : 0;
}

void fitWeights(const DayValues& day, Representation& r) {
  std::vector<std::size_t> columns;  // irradiance has no band 3
  for (std::size_t k = 0; k < r.functions; ++k)
    if (r.modes || k < model::polarIndex(3, 0) || k >= model::polarIndex(4, 0)) columns.push_back(k);
  const std::size_t points = day.grid->count();
  std::vector<double> basis;
  for (std::size_t p = 0; p < points; ++p)
    for (const std::size_t column : columns) basis.push_back(r.values[p * r.functions + column]);
  const sh::Minimax minimax(basis, columns.size());
  const int channels = isGrey(*day.day->sky) ? 1 : 3;
  tbb::parallel_for(std::size_t{0}, day.day->instant.size(), [&](std::size_t i) {
    std::vector<double> target(points);
    for (int c = 0; c < 3; ++c) {
      for (std::size_t p = 0; p < points; ++p) target[p] = day.value[i * points + p][std::min(c, channels - 1)];
      const sh::MinimaxFit fitted = minimax.fit(target);
      for (std::size_t k = 0; k < columns.size(); ++k) r.weight[i * r.rows + columns[k]][c] = fitted.coefficient[k];
    }
  });
  r.fitted = true;
  if (!r.modes) r.reconstruction = Reconstruction::fitted;
}

Representation coefficientsOf(const DayValues& day, int bands, bool fitted) {
  Representation r;
  r.bands = bands;
  r.functions = model::polarIndex(bands, 0);
  r.rows = r.functions + (hasGround(*day.day->sky) ? 1 : 0);
  r.values = coefficientValues(*day.grid, bands);
  for (const DayInstant& at : day.day->instant) {
    const model::PolarMoments& moments = at.field.moments;
    r.weight.insert(r.weight.end(), moments.radiance_sh.begin(),
                    moments.radiance_sh.begin() + static_cast<std::ptrdiff_t>(r.functions));
    if (r.rows > r.functions) r.weight.push_back(moments.horizontal_irradiance);
  }
  if (fitted) fitWeights(day, r);
  return r;
}

std::vector<Number3> weightsOf(const DayValues& day, const ModeSet& modes) {
  std::vector<Number3> weights(day.day->instant.size() * modes.count());
  const int channels = isGrey(*day.day->sky) ? 1 : 3;
  tbb::parallel_for(std::size_t{0}, day.day->instant.size(), [&](std::size_t i) {
    for (int c = 0; c < channels; ++c) {
      const auto of_channel = modes.weightsOf(day.vector[3 * i + static_cast<std::size_t>(c)]);
      for (std::size_t k = 0; k < of_channel.size(); ++k) {
        Number3& weight = weights[i * modes.count() + k];
        if (channels == 1) weight = Number3(of_channel[k]);
        weight[c] = of_channel[k];
      }
    }
  });
  return weights;
}

Representation modesOf(const DayValues& day, const ModeSet& modes, std::vector<Number3> weights, int columns, int rows,
                       int bands) {
  Representation r;
  r.reconstruction = Reconstruction::modes;
  r.bands = bands;
  r.functions = r.rows = modes.count();
  r.modes = mapOf(modes, columns, rows, bands);
  r.set = modes;
  r.values = mapValues(*r.modes, *day.grid);
  std::size_t zenith = 0;
  while (day.grid->y(zenith) < 1.0) ++zenith;
  r.horizontal.assign(r.values.begin() + static_cast<std::ptrdiff_t>(zenith * r.functions),
                      r.values.begin() + static_cast<std::ptrdiff_t>((zenith + 1) * r.functions));
  r.weight = std::move(weights);
  return r;
}

Representation atHoursOf(const DayValues& day, const Representation& r) {
  if (!r.modes) return coefficientsOf(day, r.bands, r.fitted);
  Representation other = r;
  other.weight = weightsOf(day, r.set);
  if (r.fitted) fitWeights(day, other);
  return other;
}

DayFields::Error errorOf(const DayValues& day, const Representation& r, std::size_t instant,
                         std::span<const Number3> weight) {
  const std::size_t points = day.grid->count();
  std::vector<Number3> off = irradianceOf(r, weight, points);
  const Number3* want = day.value.data() + instant * points;
  for (std::size_t p = 0; p < points; ++p) off[p] = off[p] - want[p];
  const DayInstant& at = day.day->instant[instant];
  const bool has_horizontal = !r.horizontal.empty() || r.rows > r.functions;
  const Number3 horizontal =
      has_horizontal ? horizontalOf(r, weight) - at.field.moments.horizontal_irradiance : Number3(0.0);
  return day.day->errorOf(at, *day.grid, off, horizontal);
}

double differenceOf(const DayValues& day, const Representation& r, std::size_t instant, std::span<const Number3> weight,
                    std::span<const Number3> want) {
  std::vector<Number3> difference(r.rows);
  for (std::size_t k = 0; k < r.rows; ++k) difference[k] = weight[k] - want[k];
  const auto off = irradianceOf(r, difference, day.grid->count());
  return day.day->errorOf(day.day->instant[instant], *day.grid, off, horizontalOf(r, difference)).value;
}

}  // namespace welkin::table
