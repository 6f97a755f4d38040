// SPDX-License-Identifier: Apache-2.0
// The image of the irradiance's modes: RGBA half floats, modes 1 to 4 in the first layer, 5 to 8 in the second, 9 to 12
// in the third. With layers, clamping keeps a filter inside its four modes; rows below each other would mix them.
#pragma once

#include <welkin/welkin.h>

#include "vulkan/memory.h"

namespace welkin::vulkan {

/// The image that holds the modes; one black texel when there are no modes.
Image modesImage(const WelkinModes& modes);

/// Writes all texels of that image to `to`, which has room for them and is only written to. Missing modes are 0.
void copyModes(const WelkinModes& modes, unsigned char* to);

}  // namespace welkin::vulkan
