// SPDX-License-Identifier: Apache-2.0
// Random sky files, drawn from the table of the domain.
#pragma once

#include <string>

#include "random.h"
#include "sky/base/domain.h"
#include "sky/model/gradient.h"

namespace welkin::stress {

/// A number of a range: one in four an end, or the next number inside of it; the others uniform, or uniform in the
/// logarithm where the range spans orders.
double drawNumber(Random& random, const base::Range& range);

/// A direction of the sphere, uniform; one in four on or beside the horizon or a pole.
det::Number3 drawDirection(Random& random);

/// The text of a sky file: every section may be there, and every key of the table that may stand beside the others. Key
/// times are whole seconds, so that slopes have a bound. A star map is the file stars.ppm.
std::string drawSkyFile(Random& random);

/// An image of up to 4 x 4 texels over 60 orders, black ones among them.
model::Gradient drawGradient(Random& random);

}  // namespace welkin::stress
