// SPDX-License-Identifier: Apache-2.0
// Widgets of the day: a scrubber with the table's keys, sunrise and sunset, and a curve.
#pragma once

#include <optional>

#include "view/day.h"

namespace welkin::view {

/// The hour that was dragged to, if any.
std::optional<double> timeLine(const Day& day, double time_h);

/// A curve over 24 hours, with a line at the hour.
void dayCurve(const std::array<float, kDaySamples>& curve, double time_h);

}  // namespace welkin::view
