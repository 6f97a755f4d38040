// SPDX-License-Identifier: Apache-2.0
// Ways to hold a day's irradiance: functions of the normal, and the weights that a table would hold at every hour.
#pragma once

#include <string>
#include <vector>

#include "sky/table/day_encoding.h"
#include "sky/table/modes.h"

namespace welkin::table {

using det::Number3;

/// The day's irradiance at a grid of normals, computed once for all ways to hold it.
struct DayValues {
  DayValues(const DayFields& day, const ErrorGrid& grid);

  const DayFields* day;
  const ErrorGrid* grid;
  std::vector<Number3> value;               ///< by instant and normal
  std::vector<std::vector<double>> vector;  ///< DayModes::vectorOf, by instant and channel
};

/// One way to hold the irradiance: the functions that a table's rows weigh.
struct Representation {
  Reconstruction reconstruction = Reconstruction::projected;
  int bands = 2;  ///< bands of the coefficients in a sample
  std::optional<ModeTable> modes;
  std::size_t functions = 0;  ///< number of rows without the horizontal irradiance
  std::size_t rows = 0;
  std::vector<double> values;      ///< values of the functions, by normal and function
  std::vector<double> horizontal;  ///< horizontal irradiance of the functions; empty when it is a row of its own
  std::vector<Number3> weight;     ///< by instant and row
  ModeSet set;                     ///< the modes before they became a map
  bool fitted = false;             ///< whether the weights minimise the largest error

  std::string name() const;
  /// Bytes that do not depend on the number of keys.
  std::size_t fixedBytes() const;
};

/// Coefficients of 2 to 5 bands. They are those of the radiance, or are fitted for the least largest error of the
/// irradiance (sh/minimax.h). A fit only changes bands that irradiance has.
Representation coefficientsOf(const DayValues& day, int bands, bool fitted);

/// Replaces the weights by those of the least largest error at every instant and channel (sh/minimax.h).
void fitWeights(const DayValues& day, Representation& r);

/// Weights of the nearest combination of modes at every instant, by instant and mode.
std::vector<Number3> weightsOf(const DayValues& day, const ModeSet& modes);

/// Those weights, for modes that are read from a map of columns x rows texels.
Representation modesOf(const DayValues& day, const ModeSet& modes, std::vector<Number3> weights, int columns, int rows,
                       int bands);

/// The same representation at the hours of another day's sampling.
Representation atHoursOf(const DayValues& day, const Representation& r);

/// The error of an instant when its rows are `weight`.
DayFields::Error errorOf(const DayValues& day, const Representation& r, std::size_t instant,
                         std::span<const Number3> weight);

/// The error of an instant whose rows should be `want` and are `weight`.
double differenceOf(const DayValues& day, const Representation& r, std::size_t instant, std::span<const Number3> weight,
                    std::span<const Number3> want);

}  // namespace welkin::table
