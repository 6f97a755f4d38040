// SPDX-License-Identifier: Apache-2.0
// Whether the running process computes as sh/deterministic.h needs it: a library can change that for a whole program.
#pragma once

namespace welkin::sh {

/// Null when this thread, and so every thread that it starts, rounds to nearest and keeps denormal numbers; or what it
/// does instead. A library built with relaxed arithmetic changes this when it is loaded.
const char* whyArithmeticDiffers();

}  // namespace welkin::sh
