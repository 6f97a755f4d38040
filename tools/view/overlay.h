// SPDX-License-Identifier: Apache-2.0
// Lines over the picture: the picked point, the cells about it, the sectors' bounds.
#pragma once

#include "view/session.h"

namespace welkin::view {

/// Draws behind all panels of the current ImGui frame.
void drawOverlay(Session& session);

}  // namespace welkin::view
