// SPDX-License-Identifier: Apache-2.0
// Must not compile, because the modes' binding is missing. The message has to say so.
#version 460
#extension GL_GOOGLE_include_directive : require
#define WELKIN_SET 0
#define WELKIN_BINDING_CONSTANTS 0
#include "welkin/modes.glsl"

void main() {}
