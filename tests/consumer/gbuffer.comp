// SPDX-License-Identifier: Apache-2.0
// The game's G-buffer of street/street.obj: position and normal of the nearest surface along the pixel's ray, east.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "gbuffer.glsl"

const vec3 kLow[4] = vec3[](vec3(0, -1, 0), vec3(40, 0, 12), vec3(90, 0, 38), vec3(140, 0, 10));
const vec3 kHigh[4] = vec3[](vec3(192, 0, 64), vec3(52, 6, 24), vec3(98, 10, 52), vec3(160, 5, 26));

void main() {
  vec2 point = (vec2(gl_GlobalInvocationID.xy) + 0.5) / 16.0 - vec2(2.0, 1.0);
  vec3 ray = normalize(vec3(1.0, -point.y - 0.3, point.x));
  Pixel found = Pixel(vec4(0.0), vec4(0.0), vec4(0.0));
  float nearest = 1e9;
  for (int i = 0; i < 4; ++i) {
    bvec3 rises = greaterThan(ray, vec3(0.0));
    vec3 first = (mix(kHigh[i], kLow[i], rises) - camera.xyz) / ray, last = (mix(kLow[i], kHigh[i], rises) - camera.xyz) / ray;
    float enters = max(max(first.x, first.y), first.z);
    if (enters <= 0.0 || enters >= nearest || enters > min(min(last.x, last.y), last.z)) continue;
    nearest = enters;
    found.position = vec4(camera.xyz + ray * enters, 1.0);
    found.normal = vec4(-sign(ray) * vec3(equal(first, vec3(enters))), 0.0);
  }
  pixel[pixelIndex()] = found;
}
