// SPDX-License-Identifier: Apache-2.0
// Inputs of the level picture's passes: the uniform block of a view and the bindings of its set. C++ and GLSL.
#ifndef WELKIN_LEVEL_CONSTANTS_H
#define WELKIN_LEVEL_CONSTANTS_H

#define WELKIN_WAVE_COUNT 24

#define WELKIN_PROBE_RADIUS 0.35  // radius of the spheres that show probes, metres

#define WELKIN_LEVEL_CONSTANTS 0    // uniform buffer, LevelConstants
#define WELKIN_LEVEL_INSTANCES 1    // storage buffer, an Instance each
#define WELKIN_LEVEL_SHADOW 2       // sampler2DShadow, D32, less or equal, white border
#define WELKIN_LEVEL_ALBEDO 3       // sampler2D, RGBA16F, fetched: linear albedo; alpha: metallic
#define WELKIN_LEVEL_NORMAL 4       // sampler2D, RGBA16F, fetched: unit normal; alpha: gloss
#define WELKIN_LEVEL_DEPTH 5        // sampler2D, D32, fetched: near / distance along the view axis; 0: nothing there
#define WELKIN_LEVEL_SCENE 6        // sampler2D, RGBA32F, fetched: the picture without the water
#define WELKIN_LEVEL_REFLECTION 7   // sampler2D, RGBA32F: the level in the water as a mirror; alpha 1 where it is
#define WELKIN_LEVEL_LAMPS 8        // storage buffer, a LevelLamp each
#define WELKIN_LEVEL_BOXES 9        // storage buffer, a LevelBox each: a tree in depth-first order
#define WELKIN_LEVEL_TRIANGLES 10   // storage buffer, a LevelTriangle each
#define WELKIN_LEVEL_EMISSION 11    // sampler2D, RGBA32F, fetched: emitted radiance
#define WELKIN_LEVEL_NOISY 12       // sampler2D, R8, fetched: visibility of the hemisphere before its denoising
#define WELKIN_LEVEL_VISIBILITY 13  // sampler2D, R8, fetched: visibility of the hemisphere, of ambient light
#define WELKIN_LEVEL_TRACED 14      // sampler2D, RGBA32F, fetched: irradiance from elsewhere; alpha 0: none
#define WELKIN_LEVEL_CONTACT 15     // storage buffer: contact factors, 4 bytes a word, in steps of 1 / 170
#define WELKIN_LEVEL_BINDINGS 16

#ifdef __cplusplus
#include <cstddef>
namespace welkin::render::shaders {
using LevelMatrix = float[16];
using LevelVector = float[4];
#define WELKIN_MATRIX LevelMatrix
#define WELKIN_VECTOR LevelVector
#else
#define WELKIN_MATRIX mat4
#define WELKIN_VECTOR vec4
#endif

// World axes, metres, scene units. Column-major matrices.
struct LevelConstants {
  WELKIN_MATRIX view_projection;   // reversed depth, near / distance, no far plane
  WELKIN_MATRIX rays;              // device coordinates to directions, unnormalised: 1 along the view axis
  WELKIN_MATRIX shadow;            // world to the shadow map: xy in [0, 1], depth in [0, 1]
  WELKIN_VECTOR camera;            // xyz: position; w: distance of the near plane
  WELKIN_VECTOR light;             // xyz: unit, towards the sun or the moon; w: edge of a shadow texel, metres
  WELKIN_VECTOR light_irradiance;  // rgb: normal irradiance; w: 1 / edge of the shadow map in texels
  WELKIN_VECTOR options;     // x: mist, extinction per metre; y: 1 flat ambient light, else 0, and with probes the
                             // factor on the open sky's light; z: lowest height drawn; w: angle of a pixel, radians
  WELKIN_VECTOR water;       // x: height; y: variance of the slopes of waves too small to be seen one by one;
                             // z: 1 mirrors the baked cubemaps, else 0; w: number of lamps
  WELKIN_VECTOR floor_edge;  // west, north, east, south end of the ground, metres
  WELKIN_VECTOR picture;     // x: 1 draws the irradiance of surfaces alone, else 0; y: 1 takes contact factors, else 0;
                             // z: factor on the sky that materials reflect
  WELKIN_VECTOR waves[WELKIN_WAVE_COUNT];  // x, y: wave vector east and south, 1/m; z: slope; w: phase, radians
};

#ifdef __cplusplus
#undef WELKIN_MATRIX
#undef WELKIN_VECTOR
static_assert(sizeof(LevelConstants) == (3 * 4 + 7 + WELKIN_WAVE_COUNT) * 16);
static_assert(offsetof(LevelConstants, camera) == 12 * 16);
static_assert(offsetof(LevelConstants, waves) == 19 * 16);
}  // namespace welkin::render::shaders
#endif

#endif
