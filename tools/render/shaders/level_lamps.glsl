// SPDX-License-Identifier: Apache-2.0
// The level's own point, spot and directional lights.
#ifndef WELKIN_LEVEL_LAMPS_GLSL
#define WELKIN_LEVEL_LAMPS_GLSL

#include "level_blockers.glsl"
#include "shared/punctual_light.glsl"

struct LevelLamp {
  vec4 position;   // xyz: metres; w: 1 / range^4, or 0
  vec4 axis;       // xyz: unit, in which it shines; w: 1 for a directional lamp, else 0
  vec4 intensity;  // rgb: radiant intensity, or the directional lamp's normal irradiance; w: 0
  vec4 cone;       // x: scale; y: offset
};

layout(set = WELKIN_LEVEL_SET, binding = WELKIN_LEVEL_LAMPS, std430) readonly buffer LevelLamps { LevelLamp lamps[]; };

// Irradiance of a surface by one lamp. Opaque surfaces stop its light, from either side. The point is moved off its
// surface by `off_m`, the rounding of its place.
vec3 lampIrradiance(LevelLamp lamp, vec3 p, vec3 normal, float off_m) {
  bool directional = lamp.axis.w > 0.0;
  vec3 away = directional ? -lamp.axis.xyz : lamp.position.xyz - p;
  float squared = max(dot(away, away), 1e-12);
  vec3 direction = away * inversesqrt(squared);
  float share = directional ? 1.0
                            : rangeShare(squared, lamp.position.w) *
                                  coneShare(-dot(lamp.axis.xyz, direction), lamp.cone.x, lamp.cone.y) / squared;
  vec3 irradiance = lamp.intensity.rgb * (share * max(dot(normal, direction), 0.0));
  if (irradiance == vec3(0.0)) return irradiance;
  vec3 from = p + normal * off_m;
  bool blocked = directional ? isBlocked(from, direction, 3e38) : isBlocked(from, lamp.position.xyz - from, 0.99999);
  return blocked ? vec3(0.0) : irradiance;
}

vec3 lampsIrradiance(vec3 p, vec3 normal) {
  vec3 sum = vec3(0.0);
  float off_m = 1e-4 + 1e-5 * (length(p - level.camera.xyz) + length(p));
  for (int i = 0; i < int(level.water.w); ++i) sum += lampIrradiance(lamps[i], p, normal, off_m);
  return sum;
}

#endif
