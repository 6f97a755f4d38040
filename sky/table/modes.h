// SPDX-License-Identifier: Apache-2.0
// The modes of a day's irradiance: the few functions whose combinations give every hour and channel of one sky, or of
// the skies of a family. They come from a singular value decomposition (Eckart and Young 1936) of the irradiance over
// time, with each instant divided by its mean. They are then refined for the worst instant instead of the mean square.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "sky/table/day_fields.h"

namespace welkin::table {

/// Modes, orthonormal in the inner product that defines the weights.
struct ModeSet {
  std::vector<FieldChannel> mode;
  std::vector<std::vector<double>> vector;  ///< one vector for each mode, as DayModes::vectorOf

  std::size_t count() const { return mode.size(); }
  /// Weights of the combination of the modes that is nearest to a field, given as DayModes::vectorOf.
  std::vector<double> weightsOf(std::span<const double> field) const;
};

/// Finds the modes of a day, or those that several days share.
class DayModes {
 public:
  static constexpr std::size_t kMost = 12;  ///< the most a file may hold

  DayModes(const DayFields& day, const ErrorGrid& grid);
  /// Of all days together. Every day counts alike, whatever its number of instants.
  DayModes(std::span<const DayFields* const> days, const ErrorGrid& grid);

  /// Returns the best `count` modes, 1 to kMost. Fewer when the day has no more.
  ModeSet best(std::size_t count) const;

  /// A field as a vector. Its length is the field's root mean square over the upper normals: series times the roots of
  /// the rows' solid angles, and the vector irradiance.
  static std::vector<double> vectorOf(const FieldChannel& channel);

 private:
  std::vector<FieldChannel> basis_;  ///< more modes than a file may hold; they span the days
  std::vector<std::vector<double>> vector_;
  std::vector<double> snapshot_;  ///< coefficients of the days' channels in that basis, divided by their divisors
  std::vector<double> values_;    ///< values of the basis, by normal and mode
};

/// Returns the map of modes for a file. Each texel is the value at its centre minus a sixteenth of the second
/// differences. That centres the error of bilinear interpolation instead of leaving it on one side.
ModeTable mapOf(const ModeSet& modes, int columns, int rows, int bands);

/// Values that a GPU reads from the map at the grid's normals, by normal and mode.
std::vector<double> mapValues(const ModeTable& map, const ErrorGrid& grid);

}  // namespace welkin::table
