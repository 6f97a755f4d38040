// SPDX-License-Identifier: Apache-2.0
// Sky files that hold one parameter of the domain and the minimum that a sky needs.
#pragma once

#include <string>

#include "sky/base/domain.h"

namespace welkin::tests {

/// Text of a number that TOML reads back to the last bit. Whole numbers have no point.
std::string numberText(double value);

/// A value of the parameter's kind that contains `number`: alone, in a colour, or in a row of a path.
std::string valueText(const base::Parameter& parameter, const std::string& number);

/// A sky file with the parameter, or the key that it is a part of, at `value`. All else is a default or stands still. A
/// star map is the file stars.ppm beside it.
std::string fileText(const base::Parameter& parameter, const std::string& value);

}  // namespace welkin::tests
