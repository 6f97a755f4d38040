// SPDX-License-Identifier: Apache-2.0
// Cubic interpolation between the keys of a day, to be compared with the linear one that files have. Offline only: no
// file and no runtime interpolates so.
#pragma once

#include <vector>

#include "sky/table/representation.h"

namespace welkin::study {

/// The largest error over the day of periodic cubics through the instants `keys` (ascending), exact numbers. Slopes at
/// a key are the parabola's through it and its two neighbours: Catmull and Rom, "A Class of Local Interpolating
/// Splines" (1974), for uneven keys. Fewer than three keys: linear.
double catmullRomError(const table::DayValues& day, const table::Representation& r,
                       const std::vector<std::size_t>& keys);

/// The same with linear interpolation.
double linearError(const table::DayValues& day, const table::Representation& r, const std::vector<std::size_t>& keys);

/// Keys that the most favourable cubic takes for an error: Hermite, with slopes of its own on both sides of every key,
/// so that it may bend there; three numbers where linear interpolation has one. Placed as table::placeKeys does; none
/// when some instant is not within the error even at a key.
std::vector<std::size_t> placeHermiteKeys(const table::DayValues& day, const table::Representation& r, double error);

}  // namespace welkin::study
