// SPDX-License-Identifier: Apache-2.0
// The hours of a day at which its sky bends: a linear blend is worst between them and exact at them.
#pragma once

#include <vector>

#include "sky/model/sky.h"

namespace welkin::cubemap {

/// Keys of intensity and tint, and of a path by hand; columns of the gradients; around sunrise and sunset. Ascending,
/// in [0, 24).
std::vector<double> bendsOf(const model::Sky& sky);

/// Wraps hours into the day, sorts them and drops equal ones.
void tidyHours(std::vector<double>& time_h);

}  // namespace welkin::cubemap
