// SPDX-License-Identifier: Apache-2.0
// Radiance of diffuse surfaces under the sky, the sun or the moon and lamps, and of what they emit; or their irradiance
// alone. Alpha is 1. Where there is an irradiance from elsewhere, it replaces that of the picture's own lights. With
// WELKIN_LIGHT_GLOSSY materials reflect the sky and the sun or the moon as well.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "level_view.glsl"
#ifdef WELKIN_LIGHT_GLOSSY
#include "level_glossy.glsl"
#endif

layout(set = WELKIN_LEVEL_SET, binding = WELKIN_LEVEL_ALBEDO) uniform sampler2D levelAlbedo;
layout(set = WELKIN_LEVEL_SET, binding = WELKIN_LEVEL_EMISSION) uniform sampler2D levelEmission;
layout(set = WELKIN_LEVEL_SET, binding = WELKIN_LEVEL_NORMAL) uniform sampler2D levelNormal;
layout(set = WELKIN_LEVEL_SET, binding = WELKIN_LEVEL_VISIBILITY) uniform sampler2D levelVisibility;
layout(set = WELKIN_LEVEL_SET, binding = WELKIN_LEVEL_TRACED) uniform sampler2D levelTraced;

layout(location = 0) in vec2 ndc;
layout(location = 0) out vec4 radiance;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec3 ray = rayThrough(ndc) * (level.camera.w / texelFetch(levelDepth, pixel, 0).r);
  vec4 albedo = texelFetch(levelAlbedo, pixel, 0);
  vec4 normal = texelFetch(levelNormal, pixel, 0);
  vec4 traced = texelFetch(levelTraced, min(pixel, textureSize(levelTraced, 0) - 1), 0);
  vec4 emission = texelFetch(levelEmission, pixel, 0);  // alpha: the contact factor
  float share = texelFetch(levelVisibility, pixel, 0).r * emission.a;
  vec3 irradiance = mix(surfaceIrradiance(level.camera.xyz + ray, normal.xyz, share), traced.rgb, traced.a);
#ifdef WELKIN_LIGHT_GLOSSY
  vec3 leaving = glossyRadiance(level.camera.xyz + ray, normalize(normal.xyz), albedo, normal.w, irradiance, share) + emission.rgb;
#else
  vec3 leaving = albedo.rgb / kPi * irradiance + emission.rgb;
#endif
  float distance_m = length(ray);
  radiance = vec4(mix(throughMist(leaving, ray / distance_m, distance_m), irradiance, level.picture.x), 1.0);
}
