// SPDX-License-Identifier: Apache-2.0
// Declares the uniform block `welkinSky` (WelkinSkyConstants).
// Needs: #extension GL_GOOGLE_include_directive : require, WELKIN_SET, WELKIN_BINDING_CONSTANTS.
#ifndef WELKIN_CONSTANTS_GLSL
#define WELKIN_CONSTANTS_GLSL

#ifndef WELKIN_SET
#error WELKIN_SET is not defined: the number of the descriptor set that holds the sky
#endif
#ifndef WELKIN_BINDING_CONSTANTS
#error WELKIN_BINDING_CONSTANTS is not defined: include welkin/sky_bindings.h, or give the binding of the uniform block
#endif

#include "sky_constants.h"

layout(set = WELKIN_SET, binding = WELKIN_BINDING_CONSTANTS, std140) uniform WelkinSkyBlock {
  WelkinSkyConstants welkinSky;
};

#endif
