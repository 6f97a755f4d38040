// SPDX-License-Identifier: Apache-2.0
// Light of the open sky at pixels beyond the volume of probes: a map from above, of all resident sectors about the
// camera, says how much of the sky a place sees (shared/far.glsl). In the ambient pass:
//   mix(sky * welkinFarVisibility(position, normal), welkinVolumeIrradiance(position, normal), welkinVolumeWeight(position))
// with `sky` the open sky's irradiance for the normal, as of ambient.glsl or modes.glsl. Multiply no other light by it.
// Needs what volume.glsl needs, which it includes, and in the volume's set WELKIN_VOLUME_BINDING_FAR.
#ifndef WELKIN_FAR_GLSL
#define WELKIN_FAR_GLSL

#include "volume.glsl"
#include "../shared/far.glsl"

#ifndef WELKIN_VOLUME_BINDING_FAR
#define WELKIN_VOLUME_BINDING_FAR 3  // sampler2D: linear, repeating
#endif

layout(set = WELKIN_VOLUME_SET, binding = WELKIN_VOLUME_BINDING_FAR) uniform sampler2D welkinFarMap;

// Share of the map at a position, in [0, 1]: 1 near the camera, falling to 0 before the map ends. It moves with the camera,
// without steps.
float welkinFarShare(vec3 position) {
  vec2 inside = welkinVolume.far_share.x - abs(position.xz - welkinVolume.camera.xz);
  return clamp(min(inside.x, inside.y) * welkinVolume.far_share.y, 0.0, 1.0);
}

// Share of the open sky's irradiance that a surface gets, in [0, 1]; 1 where no sector is resident, and beyond the map.
// `position` and unit `normal` are in world axes; a normal of 0 is that of a place in the air.
float welkinFarVisibility(vec3 position, vec3 normal) {
  vec2 low = welkinVolume.far_map.xy + 0.5 * welkinVolume.texel.xz;
  vec2 high = welkinVolume.far_map.xy + welkinVolume.far_map.z - 0.5 * welkinVolume.texel.xz;
  vec2 place = clamp(position.xz + normal.xz * welkinVolume.camera.w, low, high);
  vec2 texel = textureLod(welkinFarMap, place / welkinVolume.far_map.z, 0.0).xy;
  return farVisibility(texel.x, texel.y, position.y, welkinVolume.far_map.w, welkinFarShare(position));
}

#endif
