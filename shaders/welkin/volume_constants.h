// SPDX-License-Identifier: Apache-2.0
// Constants of the volume of probes as a uniform block: one struct, compiled as C, C++ and GLSL. It has four-component
// vectors only, so that std140, std430 and C give it the same layout. welkin_volume_constants fills it.
#ifndef WELKIN_VOLUME_CONSTANTS_H
#define WELKIN_VOLUME_CONSTANTS_H

#if defined(__cplusplus) || defined(__STDC__)
#include "sky_constants.h"
#define WELKIN_VOLUME_FLOAT4 WelkinFloat4
#else
#define WELKIN_VOLUME_FLOAT4 vec4
#endif

struct WelkinVolumeConstants {
  WELKIN_VOLUME_FLOAT4 low;     // xyz: low corner of the covered box, metres; w: irradiance of a texel's value 1
  WELKIN_VOLUME_FLOAT4 camera;  // xyz: the last update's, metres; w: push off a surface along its normal, metres
  WELKIN_VOLUME_FLOAT4 size;    // xyz: edges of the box, after which coordinates repeat, metres; w: slices along z
  WELKIN_VOLUME_FLOAT4 texel;   // xyz: edges of a texel, metres; w: 1 / width of the border that fades, 1 / metres
  WELKIN_VOLUME_FLOAT4 cuts;  // xy: sectors of the table along x and z, less 1; z: a surface counts as this far off it,
                              // metres; w: 1 / slices of the texture with its bricks
  WELKIN_VOLUME_FLOAT4 far_map;    // xy: low corner of the far map along x and z, metres; z: its edge, after which
                                   // coordinates repeat, metres; w: height difference at which its effect ends, metres
  WELKIN_VOLUME_FLOAT4 far_share;  // x: distance from the camera along x and z at which the map's share is 0, metres;
                                   // y: 1 / width of the border that fades, 1 / metres; zw: 0
};

#if defined(__cplusplus) || defined(__STDC__)
typedef struct WelkinVolumeConstants WelkinVolumeConstants;
#endif
#ifdef __cplusplus
static_assert(sizeof(WelkinVolumeConstants) == 7 * 16, "");
#endif

#undef WELKIN_VOLUME_FLOAT4
#endif
