// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sh/deterministic.h"

namespace welkin::tests {

inline constexpr double kDegree = det::kPi / 180.0;  ///< radians

}  // namespace welkin::tests
