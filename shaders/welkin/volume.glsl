// SPDX-License-Identifier: Apache-2.0
// Light of a level's probes at a pixel, from the volume around the camera. `position` and unit `normal` are in world axes.
// Stefanov, "Deferred Radiance Transfer Volumes" (GDC 2012): the position is pushed off the surface, three fetches give
// the irradiance in four directions, and the normal weighs them. A cell along a wall has a brick of texels for each of its
// sides, beyond the volume's own; the three fetches are of the brick of the surface's side (shared/cuts.glsl).
// Needs: #extension GL_GOOGLE_include_directive : require; WELKIN_VOLUME_SET, and in that set
// WELKIN_VOLUME_BINDING_CONSTANTS, WELKIN_VOLUME_BINDING_TEXELS, an array of three textures, and
// WELKIN_VOLUME_BINDING_CUTS. #define WELKIN_VOLUME_WITHOUT_CUTS before it: no walls, and no such binding. #define
// WELKIN_VOLUME_DOORS before it for levels with doors: else the light steps at their faces.
#ifndef WELKIN_VOLUME_GLSL
#define WELKIN_VOLUME_GLSL

#include "formulas.glsl"
#include "volume_constants.h"

#ifndef WELKIN_VOLUME_SET
#error "define WELKIN_VOLUME_SET, the descriptor set of the volume, before volume.glsl"
#endif
#ifndef WELKIN_VOLUME_BINDING_CONSTANTS
#define WELKIN_VOLUME_BINDING_CONSTANTS 0  // uniform buffer, WelkinVolumeConstants
#endif
#ifndef WELKIN_VOLUME_BINDING_TEXELS
#define WELKIN_VOLUME_BINDING_TEXELS 1  // sampler3D[3]: red, green, blue; linear, repeating
#endif
#ifndef WELKIN_VOLUME_BINDING_CUTS
#define WELKIN_VOLUME_BINDING_CUTS 2  // storage buffer, the words of welkin_volume_cuts
#endif

layout(set = WELKIN_VOLUME_SET, binding = WELKIN_VOLUME_BINDING_CONSTANTS, std140) uniform WelkinVolumeBlock {
  WelkinVolumeConstants welkinVolume;
};
layout(set = WELKIN_VOLUME_SET, binding = WELKIN_VOLUME_BINDING_TEXELS) uniform sampler3D welkinVolumeTexels[3];

#ifndef WELKIN_VOLUME_WITHOUT_CUTS
layout(set = WELKIN_VOLUME_SET, binding = WELKIN_VOLUME_BINDING_CUTS, std430) readonly buffer WelkinVolumeCuts {
  uvec2 welkinVolumeCuts[];
};
#define CutWords uvec2
#define CUT_BLOCK_NODES (4096 + 1024)  // cells, and the trees below them
CutWords cutWords(int i) { return welkinVolumeCuts[i]; }
uint cutWord(int i) { return welkinVolumeCuts[i >> 1][i & 1]; }
float cutFloat(uint word) { return uintBitsToFloat(word); }
int cutMask(int axis) { return int(welkinVolume.cuts[axis]); }
#include "../shared/doors.glsl"
#include "../shared/cuts.glsl"
#endif

// Share of the volume at a position, in [0, 1]: 1 near the camera, falling to 0 where texels end for a pushed position,
// wherever the camera is in its cell. The share moves with the camera, without steps.
float welkinVolumeWeight(vec3 position) {
  vec3 reach = 0.5 * welkinVolume.size.xyz - 1.5 * welkinVolume.texel.xyz - welkinVolume.camera.w;
  vec3 inside = reach - abs(position - welkinVolume.camera.xyz);
  return clamp(min(min(inside.x, inside.y), inside.z) * welkinVolume.texel.w, 0.0, 1.0);
}

// Texture coordinates of a place. They repeat along x and y. Along z, the slice after the last one is a copy of the first.
vec3 welkinVolumeCoordinates(vec3 place) {
  vec3 half_texel = 0.5 * welkinVolume.texel.xyz;
  vec3 at = clamp(place, welkinVolume.low.xyz + half_texel, welkinVolume.low.xyz + welkinVolume.size.xyz - half_texel);
  vec3 uvw = at / welkinVolume.size.xyz;
  float slice = fract(uvw.z) * welkinVolume.size.w;
  uvw.z = (slice < 0.5 ? slice + welkinVolume.size.w : slice) * welkinVolume.cuts.w;
  return uvw;
}

// Light of the texels at texture coordinates, weighed for a normal.
vec3 welkinVolumeTexelsAt(vec3 uvw, vec4 weight) {
  return vec3(dot(textureLod(welkinVolumeTexels[0], uvw, 0.0), weight),
              dot(textureLod(welkinVolumeTexels[1], uvw, 0.0), weight),
              dot(textureLod(welkinVolumeTexels[2], uvw, 0.0), weight));
}

// Irradiance, pi included, at least 0, of a small surface that faces `direction` at the place of a surface of that
// normal: with the mirrored view it says how dark a reflection is. Outside of the volume it is that of the nearest place
// inside: mix it with the sky's own by welkinVolumeWeight.
vec3 welkinVolumeIrradianceTowards(vec3 position, vec3 normal, vec3 direction) {
  TransferWeights w = transferWeights(direction);
  vec4 weight = vec4(w.v[0], w.v[1], w.v[2], w.v[3]);
  vec3 place = position + normal * welkinVolume.camera.w;
#ifdef WELKIN_VOLUME_WITHOUT_CUTS
  vec3 light = welkinVolumeTexelsAt(welkinVolumeCoordinates(place), weight);
#else
  vec3 outside = abs(position - welkinVolume.low.xyz - 0.5 * welkinVolume.size.xyz) - 0.5 * welkinVolume.size.xyz;
  bool is_inside = max(max(outside.x, outside.y), outside.z) < 0.0;
  vec3 p = position + normal * welkinVolume.cuts.z;
  vec3 light = vec3(0.0);
  float share = 1.0;
  bool is_first = true;
  do {  // once, and in a door once more, for the light from beyond its face
    CutBrick found = cutBrickAt(p, place);
    vec3 uvw = welkinVolumeCoordinates(place);
    if (found.brick != 0u && is_inside) {
      vec3 corner = 3.0 * cutBrickCorner(found.brick);
      corner.z += welkinVolume.size.w + 1.0;
      uvw =
          (corner + clamp(found.at, 0.5, 2.5)) * vec3(welkinVolume.texel.xy / welkinVolume.size.xy, welkinVolume.cuts.w);
    }
    light = mix(light, welkinVolumeTexelsAt(uvw, weight), share);
    share = 0.0;
#ifdef WELKIN_VOLUME_DOORS
    if (is_first && is_inside && found.doors > 0) {
      CutDoor beyond = cutDoorOf(found, p, place);
      p = beyond.p;
      place = beyond.place;
      share = beyond.share;
    }
#endif
    is_first = false;
  } while (share > 0.0);
#endif
  return max(light * welkinVolume.low.w, vec3(0.0));
}

// Irradiance of a surface.
vec3 welkinVolumeIrradiance(vec3 position, vec3 normal) { return welkinVolumeIrradianceTowards(position, normal, normal); }

#endif
