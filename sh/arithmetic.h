// SPDX-License-Identifier: Apache-2.0
// Check that the running process computes as sh/deterministic.h needs. A library can change this for a whole program.
#pragma once

namespace welkin::sh {

/// Null when this thread, and so every thread that it starts, rounds to nearest and keeps denormal numbers. Otherwise a
/// description of the difference. A library built with relaxed arithmetic causes one when it is loaded.
const char* whyArithmeticDiffers();

}  // namespace welkin::sh
