// SPDX-License-Identifier: Apache-2.0
// The viewer in a window.
#pragma once

#include "view/run.h"

namespace welkin::view {

/// Opens a window, performs the script, and ends when a person closes it. Throws Error; Error(file), one sentence,
/// where there is no display.
void runWindow(const ViewOptions& options);

}  // namespace welkin::view
