/* SPDX-License-Identifier: Apache-2.0
 *
 * Welkin runtime: the ambient light of a sample in the forms and axes of Filament, three.js, Unity, Unreal and Godot.
 * docs/engines.md has code for each. Every struct here has the form that its engine takes, and never changes. All
 * functions are pure. Bands l = 0..2 are packed, and higher ones left out: band 3 has no irradiance, and band 4 at most
 * a few percent.
 */
#ifndef WELKIN_ENGINES_H
#define WELKIN_ENGINES_H

#include <welkin/welkin.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Axes of an engine's world. Each follows from this library's by naming and mirroring axes alone: metres stay metres,
 * and a unit vector stays one. In a left-handed world light is right only where every direction and every coefficient
 * is converted. */
typedef enum WelkinAxes {
  WELKIN_AXES_WELKIN = 0, /* +x east, +y up, +z south, right-handed: this library, glTF, Filament, three.js, Godot */
  WELKIN_AXES_UNITY = 1,  /* (x, y, -z): +x east, +y up, +z north, left-handed. Unity's compass */
  WELKIN_AXES_UNITY_IMPORT = 2,     /* (-x, y, z): +x west, +y up, +z south, left-handed. Unity's importers of glTF
                                       (glTFast), FBX and OBJ mirror x: take this one when the level came through them */
  WELKIN_AXES_UNREAL = 3,           /* (x, z, y): +x east, +y south, +z up, left-handed, as Unreal's importer of glTF */
  WELKIN_AXES_MAX_ENUM = 0x7fffffff /* no axes: it makes every int a value of the type, which is then refused */
} WelkinAxes;

/* RGB irradiance divided by pi, world axes: times an albedo it is a radiance. The coefficients are scaled as Filament's
 * IndirectLight::Builder::irradiance takes them:
 * sh0 + sh1 y + sh2 z + sh3 x + sh4 yx + sh5 yz + sh6 (3 z2 - 1) + sh7 zx + sh8 (x2 - y2). */
typedef struct WelkinFilamentIrradianceOverPi {
  float sh[9][3];
} WelkinFilamentIrradianceOverPi;

/* Irradiance divided by pi, in Unity's seven constants. For each channel it is
 * dot(SHA, (n, 1)) + dot(SHB, n.xyzz * n.yzzx) + SHC (x2 - y2).
 * welkin_pack_unity takes n in the axes of this library, welkin_pack_unity_axes in Unity's own. */
typedef struct WelkinUnityIrradianceOverPi {
  float shar[4], shag[4], shab[4]; /* x, y, z, constant */
  float shbr[4], shbg[4], shbb[4]; /* xy, yz, zz, zx */
  float shc[4];                    /* x2 - y2: red, green, blue, and 1 */
} WelkinUnityIrradianceOverPi;

/* Radiance as spherical harmonics in an engine's axes: order, basis and signs of this library's ambient_sh, bands
 * l = 0..2. three.js' LightProbe takes these numbers as they are. */
typedef struct WelkinRadianceSh {
  float sh[9][3];
} WelkinRadianceSh;

/* Radiance as Filament's IndirectLight::Builder::radiance takes it: its basis negates odd m, so coefficients 1, 3, 5
 * and 7 have the opposite sign. */
typedef struct WelkinFilamentRadiance {
  float sh[9][3];
} WelkinFilamentRadiance;

/* Irradiance divided by pi as Unity's SphericalHarmonicsL2 holds it: sh[channel][coefficient], for
 * RenderSettings.ambientProbe and LightProbes. */
typedef struct WelkinUnityProbe {
  float sh[3][9];
} WelkinUnityProbe;

/* Irradiance divided by pi in the seven vectors of Unreal's SkyIrradianceEnvironmentMap, in WELKIN_AXES_UNREAL. Vectors
 * 0..2 are the channels' x, y, z and constant, 3..5 their xy, yz, zz and zx. Vector 6 holds x2 - y2 of red, green and
 * blue, and 1. */
typedef struct WelkinUnrealIrradianceOverPi {
  float vectors[7][4];
} WelkinUnrealIrradianceOverPi;

/* Light for Godot 4, whose axes are this library's. */
typedef struct WelkinGodotIrradianceOverPi {
  float vectors[7][4]; /* irradiance divided by pi, in the order of WelkinUnrealIrradianceOverPi: for the shader lines
                          of docs/engines.md */
  float probe[9][4]; /* the colours of one point of RenderingServer.lightmap_set_probe_capture_data: radiance divided by
                        pi, alpha 1 */
} WelkinGodotIrradianceOverPi;

/* Writes `vector` in an engine's axes to `converted`; both may be one array. Convert directions of lights and normals
 * so. Other axes are WELKIN_ERROR_ARGUMENT. */
WELKIN_API WelkinResult welkin_axes_vector(WelkinAxes axes, const float vector[3], float converted[3]);

/* The ambient light of a sample for engines, bands l = 0..2. The packings with `axes` are for a world with those axes:
 * the engine's own normals go into them. Other axes are WELKIN_ERROR_ARGUMENT. welkin_pack_unity is
 * welkin_pack_unity_axes with WELKIN_AXES_WELKIN. Unity's built-in shaders want one of its own two axes. */
WELKIN_API WelkinResult welkin_pack_filament(const WelkinSkySample* sample, WelkinFilamentIrradianceOverPi* packed);
WELKIN_API WelkinResult welkin_pack_unity(const WelkinSkySample* sample, WelkinUnityIrradianceOverPi* packed);
WELKIN_API WelkinResult welkin_pack_radiance(const WelkinSkySample* sample, WelkinAxes axes, WelkinRadianceSh* packed);
WELKIN_API WelkinResult welkin_pack_filament_radiance(const WelkinSkySample* sample, WelkinFilamentRadiance* packed);
WELKIN_API WelkinResult welkin_pack_unity_axes(const WelkinSkySample* sample, WelkinAxes axes,
                                               WelkinUnityIrradianceOverPi* packed);
WELKIN_API WelkinResult welkin_pack_unity_probe(const WelkinSkySample* sample, WelkinAxes axes,
                                                WelkinUnityProbe* packed);
WELKIN_API WelkinResult welkin_pack_unreal(const WelkinSkySample* sample, WelkinUnrealIrradianceOverPi* packed);
WELKIN_API WelkinResult welkin_pack_godot(const WelkinSkySample* sample, WelkinGodotIrradianceOverPi* packed);

#ifdef __cplusplus
}
#endif

#endif
