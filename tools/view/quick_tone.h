// SPDX-License-Identifier: Apache-2.0
// The tone curve of render::tonemap by a table, for pictures that are drawn many times a second.
#pragma once

#include "render/tone.h"

namespace welkin::view {

/// As render::tonemap with one sample a pixel. A channel differs by at most one code, and only where the curve passes
/// within a thousandth of the border of two. Rows are computed in parallel (oneTBB's current arena).
render::Picture quickTone(const render::FloatImage& image, double exposure);

}  // namespace welkin::view
