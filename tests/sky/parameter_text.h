// SPDX-License-Identifier: Apache-2.0
// Sky files that hold one parameter of the domain beside what a sky must have.
#pragma once

#include <string>

#include "sky/base/domain.h"

namespace welkin::tests {

/// A number as TOML reads it back to the last bit; whole numbers without a point.
std::string numberText(double value);

/// A value of the parameter's kind in which its number is `number`: alone, in a colour, or in a row of a path.
std::string valueText(const base::Parameter& parameter, const std::string& number);

/// A sky file with the parameter, or the key that it is a part of, at `value`: everything else is a default or stands
/// still. A star map is the file stars.ppm beside it.
std::string fileText(const base::Parameter& parameter, const std::string& value);

}  // namespace welkin::tests
