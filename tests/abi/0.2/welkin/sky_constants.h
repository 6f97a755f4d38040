// SPDX-License-Identifier: Apache-2.0
// The sky at an instant as a uniform block: one struct, compiled as C, C++ and GLSL. It has four-component vectors
// only, so that std140, std430 and C give it the same layout. welkin_sky_constants fills it.
#ifndef WELKIN_SKY_CONSTANTS_H
#define WELKIN_SKY_CONSTANTS_H

#if defined(__cplusplus) || defined(__STDC__)
#include <stddef.h>
typedef struct WelkinFloat4 {
  float x, y, z, w;
} WelkinFloat4;
#define WELKIN_FLOAT4 WelkinFloat4
#else
#define WELKIN_FLOAT4 vec4
#endif

// Radiances and irradiances are in scene units, linear Rec. 709. Directions are unit vectors towards the light, in
// world axes.
struct WelkinSkyConstants {
  WELKIN_FLOAT4 sun;              // xyz: direction of the sun; w: hour of the day, in [0, 24)
  WELKIN_FLOAT4 luminance_abcd;   // coefficients of the relative luminance, shared/luminance.glsl
  WELKIN_FLOAT4 luminance_ek;     // x: e; y: k; z: luminance of the normalising direction; w: intensity
  WELKIN_FLOAT4 tint;             // rgb: polarising tint; w: luminance under which a gradient fades to neutral, > 0
  WELKIN_FLOAT4 ground;           // rgb: radiance below the horizon; w: weight of the second cubemap, in [0, 1)
  WELKIN_FLOAT4 gradient_size;    // columns and rows of the sun's gradient, columns and rows of the opposite one
  WELKIN_FLOAT4 gradient_column;  // column left of the hour, weight of the next column: the sun's, the opposite's
  WELKIN_FLOAT4 sun_disc;         // rgb: radiance of the disc; w: its angular radius, radians; 0: no disc
  WELKIN_FLOAT4 moon;             // xyz: direction of the moon; w: number of ambient coefficients, 4..25
  WELKIN_FLOAT4 moon_disc;        // as sun_disc
  WELKIN_FLOAT4 stars;            // latitude, north offset, turn since midnight, radians; radiance of the map's white
  WELKIN_FLOAT4 key_direction;    // xyz: towards the one light that casts shadows, the sun or the moon; w: 0
  WELKIN_FLOAT4 key_irradiance;   // rgb: irradiance of a surface that faces it, pi included; 0 below the horizon; w: 0
  WELKIN_FLOAT4 ambient_sh[25];   // rgb: radiance coefficients of the ambient light; w: 0
  WELKIN_FLOAT4 mode_weight[9];   // weights of modes 1..4 for red, for green, for blue; then of 5..8; then of 9..12
  WELKIN_FLOAT4 mode_rest[3];     // irradiance beside the modes, for red, green, blue: welkin/modes.glsl
  WELKIN_FLOAT4 mode_frame;       // xy: x and z of the unit horizontal direction to the sun's azimuth; z: factor of
                                  // mode_rest's xyz for upper normals; w: factor of |y| in mode_rest's w
  WELKIN_FLOAT4 mode_texels;      // from column and row in [0, 1] to the modes' map: xy scale, zw offset
};

#if defined(__cplusplus) || defined(__STDC__)
typedef struct WelkinSkyConstants WelkinSkyConstants;
#endif
#ifdef __cplusplus
static_assert(sizeof(WelkinSkyConstants) == 52 * 16, "");
static_assert(offsetof(WelkinSkyConstants, luminance_ek) == 2 * 16, "");
static_assert(offsetof(WelkinSkyConstants, gradient_column) == 6 * 16, "");
static_assert(offsetof(WelkinSkyConstants, moon_disc) == 9 * 16, "");
static_assert(offsetof(WelkinSkyConstants, ambient_sh) == 13 * 16, "");
static_assert(offsetof(WelkinSkyConstants, mode_weight) == 38 * 16, "");
static_assert(offsetof(WelkinSkyConstants, mode_texels) == 51 * 16, "");
#endif

#undef WELKIN_FLOAT4
#endif
