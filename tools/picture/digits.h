// SPDX-License-Identifier: Apache-2.0
// Numbers as lines, so that a picture's bytes do not depend on the fonts of a machine.
#pragma once

#include <string_view>
#include <vector>

#include "picture/pen.h"

namespace welkin::picture {

/// Seven-segment digits, to be drawn as lines: `text` of 0 to 9 and '.', its upper left corner and height in pixels.
/// Other characters are gaps.
std::vector<std::vector<Corner>> linesOf(std::string_view text, const Corner& at, double height);

/// Of linesOf(), in pixels.
double widthOf(std::string_view text, double height);

}  // namespace welkin::picture
