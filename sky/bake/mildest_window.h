// SPDX-License-Identifier: Apache-2.0
// The window of a table of coefficients (sh/window.h).
#pragma once

#include "sky/table/day_table.h"

namespace welkin::bake {

/// Lessens the bands of a table of coefficients by the mildest window that keeps irradiance from being negative.
/// Returns its strength.
double applyMildestWindow(table::DayTable& table);

}  // namespace welkin::bake
