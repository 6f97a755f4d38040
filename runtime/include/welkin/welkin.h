/* SPDX-License-Identifier: Apache-2.0
 *
 * Welkin runtime: opens a baked sky (.welkin) and blends it to any time of day. C ABI; welkin.hpp wraps it for C++.
 *
 * Use
 *   At load time    welkin_sky_open_file.
 *   Every frame     welkin_sky_sample. The sample holds sun, moon, ambient light, ground and the cubemaps to blend.
 *                   welkin_vulkan.h draws it and passes it to shaders; welkin_sky_irradiance gives light on the CPU.
 *   At the end      welkin_sky_close.
 *
 * Conventions
 *   Axes         right-handed, +x east, +y up, -z north. A direction points away from the observer.
 *   Time of day  hours; any finite value is wrapped into [0, 24).
 *   Colour       linear, Rec. 709 primaries, D65.
 *   Radiance     scene units: radiance 1 has a luminance of WelkinSkyInfo::luminance_unit cd/m2.
 *   SH           real, orthonormal, no Condon-Shortley phase, world axes, index l (l + 1) + m:
 *                c0 0.282095; c1..c3 0.488603 (y, z, x); c4..c8 1.092548 (xy, yz, (3 z2 - 1) / (2 sqrt 3), xz,
 *                (x2 - y2) / 2); ... up to 5 bands. Coefficients are of radiance.
 *   Irradiance   E, pi included: a surface under radiance 1 from everywhere has E = pi. The coefficients of band
 *                l = 0..4 give E when they are multiplied by pi, 2 pi/3, pi/4, 0, -pi/24.
 *
 * Threads
 *   There is no global state. Functions that take a const WelkinSky may be called from any number of threads at once.
 *   welkin_sky_close must not overlap any other call on the same sky. Only welkin_sky_open_* allocates. Nothing throws.
 *
 * Errors
 *   Every function that returns a WelkinResult returns WELKIN_ERROR_ARGUMENT for a null pointer, unless its comment
 *   allows null. On an error the output is left as it was, unless its comment says otherwise.
 */
#ifndef WELKIN_WELKIN_H
#define WELKIN_WELKIN_H

#include <stddef.h>
#include <stdint.h>

#if defined(WELKIN_SHARED_LIBRARY)
#define WELKIN_API __attribute__((visibility("default")))
#else
#define WELKIN_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* The most bands, coefficients and modes that a sky can have. */
#define WELKIN_MAX_BANDS 5
#define WELKIN_MAX_COEFFICIENTS 25
#define WELKIN_MAX_MODES 12

typedef enum WelkinResult {
  WELKIN_OK = 0,
  WELKIN_ERROR_ARGUMENT = 1,  /* a null pointer, a NaN, an index past the end, a misaligned buffer */
  WELKIN_ERROR_FILE = 2,      /* the file cannot be opened, read or mapped */
  WELKIN_ERROR_FOREIGN = 3,   /* not a .welkin file */
  WELKIN_ERROR_VERSION = 4,   /* written by another format version */
  WELKIN_ERROR_TRUNCATED = 5, /* shorter or longer than its header says */
  WELKIN_ERROR_CHECKSUM = 6,  /* the bytes are not those that were written */
  WELKIN_ERROR_CONTENT = 7,   /* intact, but a value is missing or out of its domain */
  WELKIN_ERROR_MEMORY = 8,    /* out of host or device memory */
  WELKIN_ERROR_DEVICE = 9     /* a Vulkan call failed, or the device lacks a feature */
} WelkinResult;

/* The reason for a failure, in English, terminated by a zero. A function that takes a pointer to one fills it only when
 * the function fails. The pointer may be null. */
typedef struct WelkinMessage {
  char text[256];
} WelkinMessage;

/* An opened sky. It holds the memory mapping of its file. */
typedef struct WelkinSky WelkinSky;

/* Format of a cubemap's texels, little-endian. */
typedef enum WelkinCubemapFormat {
  WELKIN_CUBEMAP_RGBA16F = 0,  /* IEEE half floats, alpha 1: VK_FORMAT_R16G16B16A16_SFLOAT, 8 bytes */
  WELKIN_CUBEMAP_RGB9E5 = 1,   /* shared exponent: VK_FORMAT_E5B9G9R9_UFLOAT_PACK32, 4 bytes */
  WELKIN_CUBEMAP_B10G11R11 = 2 /* small floats: VK_FORMAT_B10G11R11_UFLOAT_PACK32, 4 bytes */
} WelkinCubemapFormat;

/* Sizes and constants of a sky. */
typedef struct WelkinSkyInfo {
  uint32_t bands;                     /* bands of spherical harmonics, 2..5 */
  uint32_t coefficient_count;         /* bands^2 */
  uint32_t key_count;                 /* times of day that the file stores, >= 1; a sample interpolates between them */
  uint32_t mode_count;                /* modes of the irradiance, 0..12; 0: the coefficients give the irradiance */
  uint32_t cubemap_count;             /* 0 without cubemaps */
  uint32_t cubemap_size;              /* texels along a face's edge; 0 without cubemaps */
  WelkinCubemapFormat cubemap_format; /* one format for all cubemaps */
  uint32_t has_moon;                  /* 0 or 1 */
  float luminance_unit;               /* luminance of radiance 1, cd/m2, > 0 */
  float ground_albedo[3];             /* RGB, 0..1 */
} WelkinSkyInfo;

/* The sun or the moon at an instant. */
typedef struct WelkinLight {
  float direction[3];         /* unit vector towards the light; a light below the horizon lights nothing */
  float illuminance;          /* illuminance of a surface that faces the light, scene units, >= 0 */
  float colour[3];            /* the artist's colour; only its hue and saturation count */
  float normal_irradiance[3]; /* RGB irradiance of a surface that faces the light:
                                 illuminance * colour / luminance(colour) */
  float disc_radius_rad;      /* angular radius of the disc that the dome draws, radians, 0..pi/2; 0: no disc */
  float visible;              /* share of the disc above the horizon, 0..1. Multiply the irradiance by it: the light
                                 then rises and sets without a jump. A light without a disc has the share of a disc
                                 half a degree across */
} WelkinLight;

/* The sky at an instant: all that a frame needs. Zero-initialise it before its first use. */
typedef struct WelkinSkySample {
  double time_h; /* hours, in [0, 24) */
  WelkinLight sun;
  WelkinLight moon;           /* all zero without a moon */
  float intensity;            /* factor on the sky's radiance, >= 0; it is already in the coefficients */
  float ambient_saturation;   /* saturation of the ambient coefficients, 0..1 */
  float polarising_tint[3];   /* RGB factor on the dome above the horizon; the cubemaps already contain it */
  float ground_radiance[3];   /* RGB radiance below the horizon, scene units */
  float luminance_norm;       /* the dome divides its relative luminance by this, > 0 */
  uint32_t coefficient_count; /* number of coefficients below, bands^2; the rest are 0 */
  float radiance_sh[WELKIN_MAX_COEFFICIENTS][3]; /* RGB radiance of sky and ground, before desaturation, no tint */
  float ambient_sh[WELKIN_MAX_COEFFICIENTS][3];  /* the same after desaturation: it lights the scene */
  float ambient_ground[3];                       /* ground_radiance after desaturation */
  uint32_t mode_count;                           /* number of weights below; 0 without modes or after a blend */
  float mode_weight[WELKIN_MAX_MODES][3];        /* RGB weight of each mode, after desaturation. The weighted modes
                                                    sum to the sky's irradiance, pi included, without ground */
  float mode_azimuth[2]; /* x and z of the unit horizontal direction towards the sun's azimuth; within 1e-5 rad of
                            the zenith or the nadir it fades to 0 */
  uint32_t cubemap[2];   /* indices of the two cubemaps to blend; equal if there is one, 0 without */
  float cubemap_weight;  /* weight of the second cubemap, in [0, 1): sky = mix(first, second, weight) */
  uint32_t unchanged;    /* 1 if the sample already held this result, bit for bit; else 0 */
} WelkinSkySample;

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

/* Coefficients of the sky's relative luminance, in the form of the CIE standard general sky. The file
 * shaders/shared/luminance.glsl has the formula and its sources. b < 0, d < 0. */
typedef struct WelkinLuminance {
  float a, b, c, d, e, k;
  uint32_t normalise_to_sun; /* 1: luminance 1 is at the sun; 0: at the zenith */
} WelkinLuminance;

/* A gradient image: rows from the horizon to the zenith, columns over the day from 0 h. `rgb` is row-major, each number
 * at least 0. The numbers belong to the sky: they live until it is closed. */
typedef struct WelkinGradient {
  uint32_t width, height;
  const float* rgb;
} WelkinGradient;

/* Colours of the sky. The dome blends the two images over the azimuth between the sun's side and the opposite side. */
typedef struct WelkinGradients {
  WelkinGradient sun;  /* colours at the sun's azimuth */
  WelkinGradient anti; /* colours at the opposite azimuth */
  float delta;         /* luminance below which a gradient's colour fades to grey, > 0 */
} WelkinGradients;

/* A cubemap in Vulkan's orientation: faces +x, -x, +y, -y, +z, -z, each size x size texels, rows from the top. It shows
 * the tinted sky and the ground, without sun and moon. Every component is finite and at least 0. The texels belong to
 * the sky: they live until it is closed. */
typedef struct WelkinCubemap {
  double time_h; /* hours, in [0, 24) */
  uint32_t size; /* texels along an edge, 1..16384 */
  WelkinCubemapFormat format;
  const void* texels; /* aligned to 16 */
  size_t bytes;       /* size of all six faces */
} WelkinCubemap;

/* A star map: width x height texels, sRGB-encoded RGBA, rows from the celestial north pole. The file
 * shaders/shared/stars.glsl maps directions to texels. The texels belong to the sky: they live until it is closed. */
typedef struct WelkinStars {
  uint32_t width, height; /* 0 x 0: no stars */
  const uint8_t* rgba8;
  float intensity;        /* radiance of white, scene units, >= 0 */
  float latitude_rad;     /* latitude of the observer, radians, in [-pi/2, pi/2] */
  float north_offset_rad; /* azimuth of true north, radians clockwise from the world's -z */
  double midnight_h;      /* hour at which the middle column crosses the meridian, in [0, 24] */
} WelkinStars;

/* Modes of the sky's irradiance: a few fixed functions of the normal, whose weighted sum is the irradiance at any hour.
 * They are a map of IEEE half floats, row-major, `count` modes per texel. Read it bilinearly at modeColumn and modeRow
 * of an upper normal (shaders/shared/modes.glsl). Coordinates 0 and 1 are the centres of the outer texels. The texels
 * belong to the sky: they live until it is closed. */
typedef struct WelkinModes {
  uint32_t count;         /* 0..12; 0 without modes */
  uint32_t columns, rows; /* 2..256 */
  const uint16_t* texels;
} WelkinModes;

/* The reference for the certificate's errors. */
typedef enum WelkinCertificateMethod {
  WELKIN_CERTIFICATE_NONE = 0, /* not measured */
  WELKIN_CERTIFICATE_FAST = 1, /* the model's irradiance at 884 normals on both sides of the sun's vertical plane */
  WELKIN_CERTIFICATE_FULL = 2  /* as FAST, and also a direct integration at 642 evenly spread normals */
} WelkinCertificateMethod;

/* Error of a file's irradiance, measured through this runtime when it was baked. The error is |E - E_ref| of the worst
 * channel, divided by the mean of E_ref over all normals (docs/conventions.md). All errors are fractions: 0.01 is 1 %.
 */
typedef struct WelkinCertificate {
  WelkinCertificateMethod method; /* NONE: all other fields are 0 */
  double max_error;
  double time_h;    /* hour of max_error, in [0, 24) */
  double normal[3]; /* normal of max_error, unit */
  uint32_t channel; /* channel of max_error; 0, 1, 2: red, green, blue */
  double mean_error;
  double quadrature, truncation, time, encoding; /* parts of max_error: largest error from each cause alone */
  double cubemap_error; /* root mean square over the upper hemisphere, divided by the dome's mean; 0 without cubemaps */
  double cubemap_time_h;                                      /* hour of cubemap_error, in [0, 24) */
  double cubemap_resolution, cubemap_blend, cubemap_encoding; /* parts of cubemap_error */
  double dome_error; /* error of welkin_dome_radiance, measured as cubemap_error is */
} WelkinCertificate;

/* A short English description of a result. Never null; the text is static. */
WELKIN_API const char* welkin_result_string(WelkinResult result);

/* Opens the baked sky at `path` and checks its header, checksum, structure and every value. It reads the file once. On
 * an error *sky is null, and `message` gives the reason. Every error but WELKIN_ERROR_DEVICE is possible. */
WELKIN_API WelkinResult welkin_sky_open_file(const char* path, WelkinSky** sky, WelkinMessage* message);

/* Opens a baked sky of `size` bytes at `data`, as welkin_sky_open_file does. `data` must be aligned to 16, else
 * WELKIN_ERROR_ARGUMENT. The sky reads the bytes in place: keep them unchanged until it is closed. */
WELKIN_API WelkinResult welkin_sky_open_memory(const void* data, size_t size, WelkinSky** sky, WelkinMessage* message);

/* Closes a sky and frees its memory. Null is allowed. Pointers that the sky gave out become invalid. */
WELKIN_API void welkin_sky_close(WelkinSky* sky);

/* Sizes, luminance model and gradients of a sky. */
WELKIN_API WelkinResult welkin_sky_info(const WelkinSky* sky, WelkinSkyInfo* info);
WELKIN_API WelkinResult welkin_sky_luminance(const WelkinSky* sky, WelkinLuminance* luminance);
WELKIN_API WelkinResult welkin_sky_gradients(const WelkinSky* sky, WelkinGradients* gradients);
/* Cubemap `index`, in [0, cubemap_count); cubemaps are sorted by time. Another index is WELKIN_ERROR_ARGUMENT. */
WELKIN_API WelkinResult welkin_sky_cubemap(const WelkinSky* sky, uint32_t index, WelkinCubemap* cubemap);
/* The star map; all fields are 0 if the sky has none. */
WELKIN_API WelkinResult welkin_sky_stars(const WelkinSky* sky, WelkinStars* stars);
/* The modes of the irradiance; all fields are 0 if the sky has none. */
WELKIN_API WelkinResult welkin_sky_modes(const WelkinSky* sky, WelkinModes* modes);
/* The error that the bake measured; all fields are 0 if it measured none. */
WELKIN_API WelkinResult welkin_sky_certificate(const WelkinSky* sky, WelkinCertificate* certificate);
/* Hour of key `index`, in [0, key_count); hours ascend with the index. Another index is WELKIN_ERROR_ARGUMENT. */
WELKIN_API WelkinResult welkin_sky_key_time(const WelkinSky* sky, uint32_t index, double* time_h);
/* The settings of the bake as JSON, terminated by a zero. The text belongs to the sky: it lives until the sky is
 * closed. */
WELKIN_API WelkinResult welkin_sky_settings(const WelkinSky* sky, const char** json);

/* Writes the sky at `time_h` hours to `sample`. A NaN or an infinity is WELKIN_ERROR_ARGUMENT. If `sample` already
 * holds the result, bit for bit, `unchanged` becomes 1: no new upload is needed then. */
WELKIN_API WelkinResult welkin_sky_sample(const WelkinSky* sky, double time_h, WelkinSkySample* sample);

/* RGB irradiance of a surface from sky and ground: pi included, scene units, at least 0. `normal` is a unit vector. The
 * result comes from the modes if the sample has them, else from the ambient coefficients. The certificate measures this
 * function. `sample` comes from the same sky or from welkin_sample_blend; a sample with another number of modes is
 * WELKIN_ERROR_ARGUMENT. */
WELKIN_API WelkinResult welkin_sky_irradiance(const WelkinSky* sky, const WelkinSkySample* sample,
                                              const float normal[3], float irradiance[3]);

/* The same irradiance, from the sample's ambient coefficients alone. More than WELKIN_MAX_COEFFICIENTS of them are
 * WELKIN_ERROR_ARGUMENT. */
WELKIN_API WelkinResult welkin_sample_irradiance(const WelkinSkySample* sample, const float normal[3],
                                                 float irradiance[3]);

/* Blends two skies, for weather: lights, tint, ambient coefficients and ground. `weight`, in [0, 1], is the weight of
 * the second sky. Directions are blended and normalised. The blend has no modes: the coefficients give its irradiance.
 * Fields that belong to one file (luminance_norm, intensity, cubemaps) are copied from the first sample. So draw both
 * domes, the second with `weight` as its opacity. Different coefficient counts and other weights are
 * WELKIN_ERROR_ARGUMENT. */
WELKIN_API WelkinResult welkin_sample_blend(const WelkinSkySample* first, const WelkinSkySample* second, float weight,
                                            WelkinSkySample* blended);

/* The light for a renderer with one shadowed directional light: the sun or the moon, whichever lights a facing surface
 * more. Its irradiance and illuminance are reduced by the other light's. So they are 0 at the moment when the two
 * change places, and the change of direction does not show. They already contain `visible`, which is 1 in the result.
 */
WELKIN_API WelkinResult welkin_sample_key_light(const WelkinSkySample* sample, WelkinLight* light);

/* Packs bands l = 0..2 of the ambient light for the shaders of Filament and Unity. Higher bands are left out: band 3
 * has no irradiance, and band 4 at most a few percent. */
WELKIN_API WelkinResult welkin_pack_filament(const WelkinSkySample* sample, WelkinFilamentIrradianceOverPi* packed);
WELKIN_API WelkinResult welkin_pack_unity(const WelkinSkySample* sample, WelkinUnityIrradianceOverPi* packed);

/* RGB radiance of the dome in unit `direction`, scene units, from the formulas and gradients, not from the cubemaps. It
 * shows the tinted sky and the ground, without sun and moon. It is computed in double, as the reference for the dome on
 * the GPU. `sample` comes from the same sky. */
WELKIN_API WelkinResult welkin_dome_radiance(const WelkinSky* sky, const WelkinSkySample* sample,
                                             const float direction[3], float radiance[3]);

/* RGB radiance of the discs of sun and moon in unit `direction`; add it to the dome's radiance. 0 below the horizon.
 * The discs' edges are softened over `pixel_rad` >= 0 radians. The moon's phase follows from the sample's sun. */
WELKIN_API WelkinResult welkin_disc_radiance(const WelkinSkySample* sample, const float direction[3], float pixel_rad,
                                             float radiance[3]);

/* RGB radiance of the stars in unit `direction`; add it to the dome's radiance. Stars fade as the dome gets brighter.
 * The map is read bilinearly. 0 below the horizon and if the sky has no star map. */
WELKIN_API WelkinResult welkin_star_radiance(const WelkinSky* sky, const WelkinSkySample* sample,
                                             const float direction[3], float radiance[3]);

/* Axes of an engine's world. Each follows from this library's by naming and mirroring axes alone: metres stay metres,
 * and a unit vector stays one. In a left-handed world light is right only where every direction and every coefficient
 * is converted. */
typedef enum WelkinAxes {
  WELKIN_AXES_WELKIN = 0, /* +x east, +y up, +z south, right-handed: this library, glTF, Filament, three.js, Godot */
  WELKIN_AXES_UNITY = 1,  /* (x, y, -z): +x east, +y up, +z north, left-handed. Unity's compass */
  WELKIN_AXES_UNITY_IMPORT = 2, /* (-x, y, z): +x west, +y up, +z south, left-handed. Unity's importers of glTF
                                   (glTFast), FBX and OBJ mirror x: take this one when the level came through them */
  WELKIN_AXES_UNREAL = 3        /* (x, z, y): +x east, +y south, +z up, left-handed, as Unreal's importer of glTF */
} WelkinAxes;

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
