// SPDX-License-Identifier: Apache-2.0
// Must not compile, because WELKIN_SET is missing. The message has to say so.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "welkin/sky_bindings.h"
#include "welkin/ambient.glsl"

void main() {}
