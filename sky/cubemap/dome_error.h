// SPDX-License-Identifier: Apache-2.0
// The difference of a file's analytic dome from the sky that was baked: docs/conventions.md, "Error of the dome". All
// of it comes from the gradients' encoding; the rest of the file is exact up to float.
#pragma once

#include "sky/cubemap/cubemap_error.h"

namespace welkin::cubemap {

/// The error of the dome from gradients rounded to `format`, in the measure of CubemapError: the largest over the day,
/// directions down to the horizon; parts.encoding is the whole. 0 for rgb32f. Parallel; the same numbers for any number
/// of threads.
CubemapError measureGradients(const model::Sky& sky, model::GradientFormat format, Effort effort);

}  // namespace welkin::cubemap
