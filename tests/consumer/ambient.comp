// SPDX-License-Identifier: Apache-2.0
// The ambient pass over the game's G-buffer: the volume of probes, and beyond it the sky where it is free.
#version 460
#extension GL_GOOGLE_include_directive : require
#define WELKIN_VOLUME_SET 0
#define WELKIN_SET 1
#include "gbuffer.glsl"
#include "welkin/sky_bindings.h"
#include "welkin/ambient.glsl"
#include "welkin/far.glsl"

void main() {
  Pixel at = pixel[pixelIndex()];
  if (at.position.w == 0.0) return;
  vec3 beyond = 3.14159265 * welkinIrradianceOverPi(at.normal.xyz);
  beyond *= welkinFarVisibility(at.position.xyz, at.normal.xyz);
  vec3 inside = welkinVolumeIrradiance(at.position.xyz, at.normal.xyz);
  pixel[pixelIndex()].irradiance.rgb = mix(beyond, inside, welkinVolumeWeight(at.position.xyz));
}
