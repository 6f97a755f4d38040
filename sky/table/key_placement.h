// SPDX-License-Identifier: Apache-2.0
// Where the keys of a day's table sit: as few as an error allows.
#pragma once

#include <vector>

#include "sky/table/certificate.h"
#include "sky/table/representation.h"

namespace welkin::table {

/// Indices of the day's instants that become keys: from the first one on, each reaches as far as linear interpolation
/// keeps every instant between within `error`; the last reaches the first again over midnight. Few, though not provably
/// the fewest. One when the whole day is within the error of one; none when some instant is not even at a key, or when
/// it takes more than `most`.
std::vector<std::size_t> placeKeys(const DayValues& day, const Representation& r, double error,
                                   std::size_t most = SIZE_MAX);

/// The table of the day's instants with those indices.
DayTable tableAt(const DayValues& day, const Representation& r, const std::vector<std::size_t>& keys);

/// What each cause makes of the irradiance: the rows that are left out, the time between keys, the stored numbers. Each
/// the largest over the day's instants; without quadrature.
ErrorParts partsOf(const DayValues& day, const Representation& r, const DayTable& table, Encoding encoding);

/// The largest error over the day's instants of a table as it is stored, and at which instant.
struct TableError {
  double value = 0.0;
  std::size_t instant = 0;
};
TableError errorOf(const DayValues& day, const Representation& r, const DayTable& table, Encoding encoding);

}  // namespace welkin::table
