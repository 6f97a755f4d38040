// SPDX-License-Identifier: Apache-2.0
// Ways to hold a day's irradiance: functions of the normal, and at every hour the weights that a table would hold.
#pragma once

#include <string>
#include <vector>

#include "sky/table/day_encoding.h"
#include "sky/table/modes.h"

namespace welkin::table {

using det::Number3;

/// The day's irradiance as read at a grid of normals, once for all ways to hold it.
struct DayValues {
  DayValues(const DayFields& day, const ErrorGrid& grid);

  const DayFields* day;
  const ErrorGrid* grid;
  std::vector<Number3> value;  ///< instant, normal
};

/// What a table's rows weigh.
struct Representation {
  Reconstruction reconstruction = Reconstruction::projected;
  int bands = 2;  ///< of the coefficients that a sample holds
  std::optional<ModeTable> modes;
  std::size_t functions = 0;  ///< rows but the horizontal irradiance
  std::size_t rows = 0;
  std::vector<double> values;      ///< of the functions: normal, function
  std::vector<double> horizontal;  ///< of the functions; none when it is a row of its own
  std::vector<Number3> weight;     ///< instant, row
  ModeSet set;                     ///< the modes before they became a map
  bool fitted = false;             ///< weights are of the least largest error

  std::string name() const;
  /// Bytes that do not depend on the keys.
  std::size_t fixedBytes() const;
};

/// Coefficients of 2 to 5 bands: of the radiance, or fitted for the least largest error of the irradiance
/// (sh/minimax.h), which only touches bands that irradiance has.
Representation coefficientsOf(const DayValues& day, int bands, bool fitted);

/// Replaces the weights by those of the least largest error at every instant and channel (sh/minimax.h).
void fitWeights(const DayValues& day, Representation& r);

/// Weights of the nearest combination of modes at every instant: instant, mode.
std::vector<Number3> weightsOf(const DayValues& day, const ModeSet& modes);

/// Those weights, of modes that are read from a map of columns x rows texels.
Representation modesOf(const DayValues& day, const ModeSet& modes, std::vector<Number3> weights, int columns, int rows,
                       int bands);

/// The same way to hold it at the hours of another day's sampling.
Representation atHoursOf(const DayValues& day, const Representation& r);

/// The error of an instant when its rows are `weight`.
DayFields::Error errorOf(const DayValues& day, const Representation& r, std::size_t instant,
                         std::span<const Number3> weight);

/// The error of an instant when its rows should be `want` and are `weight`.
double differenceOf(const DayValues& day, const Representation& r, std::size_t instant, std::span<const Number3> weight,
                    std::span<const Number3> want);

}  // namespace welkin::table
