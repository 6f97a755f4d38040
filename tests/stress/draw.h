// SPDX-License-Identifier: Apache-2.0
// Random sky files, drawn from the table of the domain.
#pragma once

#include <string>

#include "random.h"
#include "sky/base/domain.h"
#include "sky/model/gradient.h"

namespace welkin::stress {

/// A number of a range. One in four is an end or the next number inside it. The others are uniform, or uniform in the
/// logarithm where the range spans orders of magnitude.
double drawNumber(Random& random, const base::Range& range);

/// A direction, uniform in height and azimuth. One in four is on or beside the horizon or a pole.
det::Number3 drawDirection(Random& random);

/// The text of a sky file. It may have every section, and every key of the table that may stand beside the others. Key
/// times are whole seconds, so that slopes have a bound. The star map is the file stars.ppm.
std::string drawSkyFile(Random& random);

/// An image of up to 4 x 4 texels. They range over 60 orders of magnitude, and some are black.
model::Gradient drawGradient(Random& random);

}  // namespace welkin::stress
