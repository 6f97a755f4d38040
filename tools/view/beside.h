// SPDX-License-Identifier: Apache-2.0
// Two pictures of one size in one.
#pragma once

#include "render/tone.h"

namespace welkin::view {

/// `a` left of a light line at a share of the width, `b` right of it.
render::Picture wiped(const render::Picture& a, const render::Picture& b, double at);

/// The middle half of each, with a line between them.
render::Picture sideBySide(const render::Picture& a, const render::Picture& b);

/// The column of the pictures that sideBySide() shows at column `x` of a picture of this width.
double sideColumn(double x, uint32_t width);

}  // namespace welkin::view
