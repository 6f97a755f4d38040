// SPDX-License-Identifier: Apache-2.0
// The light of probes at a picture's surfaces by the runtime's look-ups on the CPU.
#pragma once

#include <welkin/level.h>

#include "render/camera.h"
#include "render/offscreen.h"
#include "shared.h"

namespace welkin::render {

/// Irradiance at every surface of LevelView::drawPlaces() from its camera, with the light that `level` was last relit
/// for; alpha 1, or all 0 where there is no surface or no probe serves it. Throws Error(internal).
FloatImage queryPlaces(const WelkinLevel& level, const FloatImage& places, const Camera& camera,
                       const f64::Number3& position);

}  // namespace welkin::render
