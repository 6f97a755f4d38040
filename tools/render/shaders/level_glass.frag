// SPDX-License-Identifier: Apache-2.0
// A surface that is glass or blended, over the scene drawn so far: the share that passes times what is behind, and the
// light that the surface reflects and emits.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "level_view.glsl"
#include "level_glass_push.h"

layout(location = 0) in vec3 placed_normal;
layout(location = 1) in vec4 albedo;  // alpha: metallic
layout(location = 2) in float height;
layout(location = 3) flat in vec3 emission;
layout(location = 4) in vec2 contact;  // contact factor, gloss
layout(location = 0, index = 0) out vec4 radiance;
layout(location = 0, index = 1) out vec4 passing;

void main() {
  if (height < level.options.z) discard;
  vec3 ray = rayThrough(gl_FragCoord.xy / vec2(textureSize(levelDepth, 0)) * 2.0 - 1.0) * (level.camera.w / gl_FragCoord.z);
  vec3 n = normalize(placed_normal);
  bool back = dot(n, ray) > 0.0;
  if (back) n = -n;  // it is lit on the side that is seen
  vec3 share = albedo.rgb * (push.alpha * push.transmission) + (1.0 - push.alpha);
  vec3 reflected = albedo.rgb * (push.alpha * (1.0 - push.transmission));
  float distance_m = length(ray);
  vec3 direction = ray / distance_m;
  // The scene behind has its own mist. That before the surface counts for what the surface adds.
  vec3 mist = throughMist(vec3(0.0), direction, distance_m);
  vec3 irradiance = surfaceIrradiance(level.camera.xyz + ray, n, back ? 1.0 : contact.x);
  vec3 own = throughMist(reflected / kPi * irradiance + emission, direction, distance_m);
  float mean = (share.r + share.g + share.b) / 3.0;
  radiance = vec4(own - mist * share, 1.0 - mean);
  passing = vec4(share, mean);
}
