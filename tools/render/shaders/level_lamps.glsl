// SPDX-License-Identifier: Apache-2.0
// The level's own point, spot and directional lights.
#ifndef WELKIN_LEVEL_LAMPS_GLSL
#define WELKIN_LEVEL_LAMPS_GLSL

#include "level.glsl"
#include "shared/punctual_light.glsl"

struct LevelLamp {
  vec4 position;   // xyz: metres; w: 1 / range^4, or 0
  vec4 axis;       // xyz: unit, in which it shines; w: 1 for a directional lamp, else 0
  vec4 intensity;  // rgb: radiant intensity, or the directional lamp's normal irradiance; w: 0
  vec4 cone;       // x: scale; y: offset
};

layout(set = WELKIN_LEVEL_SET, binding = WELKIN_LEVEL_LAMPS, std430) readonly buffer LevelLamps { LevelLamp lamps[]; };

// Irradiance of a surface by one lamp, as if nothing were between.
vec3 lampIrradiance(LevelLamp lamp, vec3 p, vec3 normal) {
  bool directional = lamp.axis.w > 0.0;
  vec3 away = directional ? -lamp.axis.xyz : lamp.position.xyz - p;
  float squared = max(dot(away, away), 1e-12);
  vec3 direction = away * inversesqrt(squared);
  float share = directional ? 1.0
                            : rangeShare(squared, lamp.position.w) *
                                  coneShare(-dot(lamp.axis.xyz, direction), lamp.cone.x, lamp.cone.y) / squared;
  return lamp.intensity.rgb * (share * max(dot(normal, direction), 0.0));
}

vec3 lampsIrradiance(vec3 p, vec3 normal) {
  vec3 sum = vec3(0.0);
  for (int i = 0; i < int(level.water.w); ++i) sum += lampIrradiance(lamps[i], p, normal);
  return sum;
}

#endif
