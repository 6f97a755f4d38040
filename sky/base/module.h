// SPDX-License-Identifier: Apache-2.0
// Libraries that are loaded only when something needs them.
#pragma once

namespace welkin::base {

/// Loads a module from the program's run path and returns the address of its function `entry`. The module is never
/// closed, and the rounding and traps of floating-point arithmetic stay as they were. `what` names the module for the
/// message. Throws Error(file).
void* loadModule(const char* file, const char* entry, const char* what);

}  // namespace welkin::base
