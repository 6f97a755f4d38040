// SPDX-License-Identifier: Apache-2.0
// Positions, shadow and mist for the pixels of the level picture.
#ifndef WELKIN_LEVEL_VIEW_GLSL
#define WELKIN_LEVEL_VIEW_GLSL

#include "level.glsl"
#include "level_lamps.glsl"
#include "sky_light.glsl"
#include "welkin/dome.glsl"

layout(set = WELKIN_LEVEL_SET, binding = WELKIN_LEVEL_SHADOW) uniform sampler2DShadow levelShadow;
layout(set = WELKIN_LEVEL_SET, binding = WELKIN_LEVEL_DEPTH) uniform sampler2D levelDepth;

// Direction through a point of the picture, of length 1 along the view axis.
vec3 rayThrough(vec2 ndc) { return (level.rays * vec4(ndc, 0.5, 1.0)).xyz; }

// Share of the sun's or moon's light that reaches a point: 3 x 3 bilinear comparisons, a texel apart (Reeves, Salesin
// and Cook, "Rendering Antialiased Shadows with Depth Maps", SIGGRAPH 1987). The point is moved off its surface by a
// texel and a half times the sine of the angle of incidence, the distance that a texel reaches under a sloping surface.
float lightReaching(vec3 p, vec3 normal) {
  float cosine = clamp(dot(normal, level.light.xyz), 0.0, 1.0);
  vec3 from = p + normal * (level.light.w * (0.3 + 1.7 * sqrt(1.0 - cosine * cosine)));
  vec3 at = (level.shadow * vec4(from, 1.0)).xyz;
  at.z = min(at.z, 1.0);
  float sum = 0.0;
  for (int y = -1; y <= 1; ++y)
    for (int x = -1; x <= 1; ++x)
      sum += textureLod(levelShadow, vec3(at.xy + vec2(x, y) * level.light_irradiance.w, at.z), 0.0);
  return sum / 9.0;
}

// Ambient light of a surface: that of the probes, and beyond their volume the open sky's where the sky is free; or without probes the open
// sky's, or one colour.
#ifdef WELKIN_LIGHT_OF_PROBES
#define WELKIN_VOLUME_SET 2
#define WELKIN_VOLUME_DOORS
#include "welkin/far.glsl"
vec3 ambientIrradiance(vec3 p, vec3 normal) {
  vec3 beyond = skyIrradiance(normal) * (level.options.y * welkinFarVisibility(p, normal));
  return mix(beyond, welkinVolumeIrradiance(p, normal), welkinVolumeWeight(p));
}
#else
vec3 ambientIrradiance(vec3 p, vec3 normal) {
  return level.options.y > 0.0 ? welkinFlatIrradiance() : skyIrradiance(normal);
}
#endif

// Irradiance of a surface from the sky, the light and the level's own lamps. `visibility` is a factor
// on ambient light alone.
vec3 surfaceIrradiance(vec3 p, vec3 normal, float visibility) {
  float cosine = dot(normal, level.light.xyz);
  vec3 direct = vec3(0.0);
  if (cosine > 0.0) direct = level.light_irradiance.rgb * (cosine * lightReaching(p, normal));
  return ambientIrradiance(p, normal) * visibility + direct + lampsIrradiance(p, normal);
}

// Radiance seen through `distance_m` of air. The air replaces the light it absorbs by the sky's radiance at the horizon
// in that azimuth, so that the far sea meets the sky. Its density is constant with height, since a level is small
// beside the atmosphere.
vec3 throughMist(vec3 radiance, vec3 direction, float distance_m) {
  if (level.options.x <= 0.0) return radiance;
  vec3 horizon = welkinDomeRadiance(normalize(vec3(direction.x, 0.0, direction.z) + vec3(0.0, 1e-3, 0.0)));
  return mix(horizon, radiance, transmittance(level.options.x, distance_m));
}

#endif
