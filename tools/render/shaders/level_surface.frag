// SPDX-License-Identifier: Apache-2.0
// Albedo, normal, emission, metal and gloss of the visible surface, and the contact factor of its front. The back of a surface has the
// opposite normal.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "level.glsl"

layout(location = 0) in vec3 placed_normal;
layout(location = 1) in vec4 albedo;  // alpha: metallic
layout(location = 2) in float height;
layout(location = 3) flat in vec3 emission;
layout(location = 4) in vec2 contact;  // contact factor, gloss
layout(location = 0) out vec4 out_albedo;
layout(location = 1) out vec4 out_normal;
layout(location = 2) out vec4 out_emission;

void main() {
  if (height < level.options.z) discard;
  vec3 n = normalize(placed_normal);
  out_albedo = albedo;
  out_emission = vec4(emission, gl_FrontFacing ? contact.x : 1.0);
  out_normal = vec4(gl_FrontFacing ? n : -n, contact.y);
}
