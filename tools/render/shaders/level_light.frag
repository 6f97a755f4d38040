// SPDX-License-Identifier: Apache-2.0
// Radiance of diffuse surfaces under the sky and the sun or the moon; alpha 1.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "level_view.glsl"

layout(set = WELKIN_LEVEL_SET, binding = WELKIN_LEVEL_ALBEDO) uniform sampler2D levelAlbedo;
layout(set = WELKIN_LEVEL_SET, binding = WELKIN_LEVEL_NORMAL) uniform sampler2D levelNormal;

layout(location = 0) in vec2 ndc;
layout(location = 0) out vec4 radiance;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec3 ray = rayThrough(ndc) * (level.camera.w / texelFetch(levelDepth, pixel, 0).r);
  vec3 albedo = texelFetch(levelAlbedo, pixel, 0).rgb;
  vec3 irradiance = surfaceIrradiance(level.camera.xyz + ray, texelFetch(levelNormal, pixel, 0).xyz);
  float distance_m = length(ray);
  radiance = vec4(throughMist(albedo / kPi * irradiance, ray / distance_m, distance_m), 1.0);
}
