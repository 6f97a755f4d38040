// SPDX-License-Identifier: Apache-2.0
// Places the keys of a day's table: as few as an error allows.
#pragma once

#include <vector>

#include "sky/table/certificate.h"
#include "sky/table/representation.h"

namespace welkin::table {

/// Indices of the day's instants that become keys. Starting at the first instant, each key reaches as far as linear
/// interpolation keeps every instant between within `error`. The last key reaches the first again over midnight. The
/// keys are few, though not provably the fewest. The result is one key when one instant serves the whole day. It is
/// empty when some instant fails even at a key, or when more than `most` keys are needed.
std::vector<std::size_t> placeKeys(const DayValues& day, const Representation& r, double error,
                                   std::size_t most = SIZE_MAX);

/// Returns the table with keys at the instants of those indices.
DayTable tableAt(const DayValues& day, const Representation& r, const std::vector<std::size_t>& keys);

/// Irradiance error by cause: rows left out, time between keys, stored numbers. Each is the largest over the day's
/// instants. Quadrature is not included.
ErrorParts partsOf(const DayValues& day, const Representation& r, const DayTable& table, Encoding encoding);

/// The largest error over the day's instants of a table as it is stored, with its instant.
struct TableError {
  double value = 0.0;
  std::size_t instant = 0;
};
TableError errorOf(const DayValues& day, const Representation& r, const DayTable& table, Encoding encoding);

}  // namespace welkin::table
