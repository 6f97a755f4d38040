// SPDX-License-Identifier: Apache-2.0
// What every other shader here has besides what it measures.
#version 460
layout(location = 0) in vec3 given;
layout(location = 0) out vec4 result;

void main() { result = vec4(given, 1.0); }
