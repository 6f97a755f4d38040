/* SPDX-License-Identifier: Apache-2.0
 *
 * Welkin runtime: opens a baked sky (.welkin) and blends it to any time of day. C ABI; welkin.hpp wraps it for C++.
 *
 * Conventions
 *   Axes         right-handed, +x east, +y up, -z north. A direction points away from the observer.
 *   Time of day  hours; any finite value is wrapped into [0, 24).
 *   Colour       linear, Rec. 709 primaries, D65.
 *   Radiance     scene units: 1 is luminance_unit cd/m2 of the sky file (WelkinSkyInfo).
 *   SH           real, orthonormal, no Condon-Shortley phase, world axes, index l (l + 1) + m:
 *                c0 0.282095; c1..c3 0.488603 (y, z, x); c4..c8 1.092548 (xy, yz, (3 z2 - 1) / (2 sqrt 3), xz,
 *                (x2 - y2) / 2); ... up to 5 bands. Radiance coefficients: pi is not in them. Irradiance is E, pi is
 *                in it: it multiplies band l by pi, 2 pi/3, pi/4, 0, -pi/24.
 *
 * Threads
 *   There is no global state. Functions that take a const WelkinSky may be called from any number of threads at once.
 *   welkin_sky_close must not overlap any other call on the same sky. Nothing but welkin_sky_open_* allocates, and
 *   nothing throws.
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
  WELKIN_ERROR_DEVICE = 9     /* Vulkan refused, or lacks what is needed */
} WelkinResult;

/* Filled by the functions that take one when they fail; always terminated. May be null. */
typedef struct WelkinMessage {
  char text[256];
} WelkinMessage;

/* An opened sky; holds the mapping of its file. */
typedef struct WelkinSky WelkinSky;

/* What a texel of the cubemaps is; little-endian. */
typedef enum WelkinCubemapFormat {
  WELKIN_CUBEMAP_RGBA16F = 0,  /* IEEE half floats, alpha 1: VK_FORMAT_R16G16B16A16_SFLOAT, 8 bytes */
  WELKIN_CUBEMAP_RGB9E5 = 1,   /* shared exponent: VK_FORMAT_E5B9G9R9_UFLOAT_PACK32, 4 bytes */
  WELKIN_CUBEMAP_B10G11R11 = 2 /* small floats: VK_FORMAT_B10G11R11_UFLOAT_PACK32, 4 bytes */
} WelkinCubemapFormat;

typedef struct WelkinSkyInfo {
  uint32_t bands;                     /* 2..5 */
  uint32_t coefficient_count;         /* bands^2 */
  uint32_t key_count;                 /* instants of the day's table, >= 1 */
  uint32_t mode_count;                /* modes of the irradiance, 0..12; 0: irradiance comes from the coefficients */
  uint32_t cubemap_count;             /* 0: no cubemaps */
  uint32_t cubemap_size;              /* texels along a face's edge; 0 without cubemaps */
  WelkinCubemapFormat cubemap_format; /* of all cubemaps */
  uint32_t has_moon;                  /* 0 or 1 */
  float luminance_unit;               /* cd/m2 of radiance 1 */
  float ground_albedo[3];             /* 0..1 */
} WelkinSkyInfo;

/* The sun or the moon at an instant. */
typedef struct WelkinLight {
  float direction[3];         /* unit, towards the light; below the horizon it lights nothing */
  float illuminance;          /* scene units, of a surface that faces the light; >= 0 */
  float colour[3];            /* as the artist gave it: only hue and saturation count */
  float normal_irradiance[3]; /* illuminance colour / luminance(colour): RGB irradiance of a surface facing the light */
  float disc_radius_rad;      /* what the dome draws; 0: no disc */
  float visible;              /* 0..1: share of the disc above the horizon, or of half a degree without a disc; factor
                                 on the light's irradiance that lets it rise and set without a jump */
} WelkinLight;

/* The sky at an instant: what a frame needs. Zero-initialise it before its first use. */
typedef struct WelkinSkySample {
  double time_h; /* wrapped into [0, 24) */
  WelkinLight sun;
  WelkinLight moon;                              /* all zero without a moon */
  float intensity;                               /* factor on the sky's radiance */
  float ambient_saturation;                      /* 0..1, of the ambient coefficients */
  float polarising_tint[3];                      /* factor on the dome and the cubemaps above the horizon */
  float ground_radiance[3];                      /* radiance below the horizon */
  float luminance_norm;                          /* luminance of the normalising direction; the dome divides by it */
  uint32_t coefficient_count;                    /* how many of the coefficients below are set; the rest are 0 */
  float radiance_sh[WELKIN_MAX_COEFFICIENTS][3]; /* of sky and ground, RGB, before desaturation, without tint */
  float ambient_sh[WELKIN_MAX_COEFFICIENTS][3];  /* the same after desaturation: what lights the scene */
  float ambient_ground[3];                       /* ground_radiance after desaturation */
  uint32_t mode_count;                           /* the file's modes; 0: none, or a blend of two skies */
  float mode_weight[WELKIN_MAX_MODES][3]; /* of each mode: irradiance of the sky (pi included) without ground, after
                                             desaturation, RGB */
  float mode_azimuth[2]; /* x and z of the horizontal direction towards the sun's azimuth; unit, but within
                          1e-5 rad of the zenith, where it fades to 0 */
  uint32_t cubemap[2];   /* the two cubemaps to blend; equal when there is one, 0 when none */
  float cubemap_weight;  /* of the second: sky = mix(first, second, weight), in [0, 1) */
  uint32_t unchanged;    /* 1: the call found here, bit for bit, what it was about to write */
} WelkinSkySample;

/* Irradiance over pi (what an albedo multiplies) as Filament's IndirectLight::Builder::irradiance takes it, pre-scaled:
 * sh0 + sh1 y + sh2 z + sh3 x + sh4 yx + sh5 yz + sh6 (3 z2 - 1) + sh7 zx + sh8 (x2 - y2), RGB, world axes. */
typedef struct WelkinFilamentIrradianceOverPi {
  float sh[9][3];
} WelkinFilamentIrradianceOverPi;

/* Irradiance over pi in Unity's seven constants, in the world axes of this library (negate z of normals that come from
 * a left-handed world): for a channel, dot(SHA, (n, 1)) + dot(SHB, n.xyzz * n.yzzx) + SHC (x2 - y2). */
typedef struct WelkinUnityIrradianceOverPi {
  float shar[4], shag[4], shab[4]; /* x, y, z, constant */
  float shbr[4], shbg[4], shbb[4]; /* xy, yz, zz, zx */
  float shc[4];                    /* x2 - y2: red, green, blue, and 1 */
} WelkinUnityIrradianceOverPi;

/* Coefficients of the relative luminance; see shaders/shared/luminance.glsl. */
typedef struct WelkinLuminance {
  float a, b, c, d, e, k;
  uint32_t normalise_to_sun; /* 0: to the zenith */
} WelkinLuminance;

/* A gradient image: rows from the horizon to the zenith, columns over the day, row-major RGB. Borrowed from the sky. */
typedef struct WelkinGradient {
  uint32_t width, height;
  const float* rgb;
} WelkinGradient;

typedef struct WelkinGradients {
  WelkinGradient sun;  /* the sun's azimuth */
  WelkinGradient anti; /* the opposite azimuth */
  float delta;         /* luminance under which a gradient fades to neutral, > 0 */
} WelkinGradients;

/* A cubemap in Vulkan's orientation: faces +x, -x, +y, -y, +z, -z, each size x size texels, rows from the top. Tint and
 * ground are in it, the sun and moon are not; no component is negative or not finite. Borrowed from the sky. */
typedef struct WelkinCubemap {
  double time_h;
  uint32_t size;
  WelkinCubemapFormat format;
  const void* texels; /* aligned to 16 */
  size_t bytes;
} WelkinCubemap;

/* A star map: width x height texels, sRGB-encoded RGBA, rows from the celestial north pole; how it lies in the sky:
 * shaders/shared/stars.glsl. Borrowed from the sky. */
typedef struct WelkinStars {
  uint32_t width, height; /* 0 x 0: no stars */
  const uint8_t* rgba8;
  float intensity; /* radiance of white, scene units */
  float latitude_rad;
  float north_offset_rad;
  double midnight_h; /* clock time at which the middle column crosses the meridian */
} WelkinStars;

/* Modes of the sky's irradiance over the day, as a map of half floats by row, column and mode, to be read bilinearly at
 * modeColumn and modeRow of an upper normal (shaders/shared/modes.glsl); coordinates 0 and 1 are the centres of the
 * outer texels. Borrowed from the sky. */
typedef struct WelkinModes {
  uint32_t count; /* 0: none */
  uint32_t columns, rows;
  const uint16_t* texels;
} WelkinModes;

typedef enum WelkinCertificateMethod {
  WELKIN_CERTIFICATE_NONE = 0,
  WELKIN_CERTIFICATE_FAST = 1, /* against irradiance from many SH bands */
  WELKIN_CERTIFICATE_FULL = 2  /* against direct integration */
} WelkinCertificateMethod;

/* The error of the irradiance that a file makes, measured through this runtime when it was baked: |E - E_ref| of the
 * worst channel over the mean of E_ref over all normals (docs/conventions.md). Fractions. */
typedef struct WelkinCertificate {
  WelkinCertificateMethod method; /* NONE: not measured, and all else is 0 */
  double max_error;
  double time_h; /* where max_error is */
  double normal[3];
  uint32_t channel; /* 0, 1, 2: red, green, blue */
  double mean_error;
  double quadrature, truncation, time, encoding; /* largest part of each cause */
  double cubemap_error; /* of the cubemaps: root mean square over the upper hemisphere, over the dome's mean; 0: none */
  double cubemap_time_h;
  double cubemap_resolution, cubemap_blend, cubemap_encoding; /* its parts */
  double dome_error;                                          /* of welkin_dome_radiance, in the same measure */
} WelkinCertificate;

/* What a result means, in a few words. Never null. */
WELKIN_API const char* welkin_result_string(WelkinResult result);

/* Opens and checks a baked sky: its header, checksum, structure and every value. O(size), once. On failure *sky is null
 * and `message` says what is wrong. */
WELKIN_API WelkinResult welkin_sky_open_file(const char* path, WelkinSky** sky, WelkinMessage* message);

/* The same from `size` bytes at `data`, aligned to 16, which must stay unchanged until the sky is closed. */
WELKIN_API WelkinResult welkin_sky_open_memory(const void* data, size_t size, WelkinSky** sky, WelkinMessage* message);

/* Closes the sky; null is allowed. */
WELKIN_API void welkin_sky_close(WelkinSky* sky);

WELKIN_API WelkinResult welkin_sky_info(const WelkinSky* sky, WelkinSkyInfo* info);
WELKIN_API WelkinResult welkin_sky_luminance(const WelkinSky* sky, WelkinLuminance* luminance);
WELKIN_API WelkinResult welkin_sky_gradients(const WelkinSky* sky, WelkinGradients* gradients);
/* index < cubemap_count; cubemaps are in the order of their times. */
WELKIN_API WelkinResult welkin_sky_cubemap(const WelkinSky* sky, uint32_t index, WelkinCubemap* cubemap);
/* The star map; all zero when there is none. */
WELKIN_API WelkinResult welkin_sky_stars(const WelkinSky* sky, WelkinStars* stars);
/* The modes of the irradiance; count 0 when the file has none. */
WELKIN_API WelkinResult welkin_sky_modes(const WelkinSky* sky, WelkinModes* modes);
WELKIN_API WelkinResult welkin_sky_certificate(const WelkinSky* sky, WelkinCertificate* certificate);
/* The hour of key `index` < key_count, ascending. */
WELKIN_API WelkinResult welkin_sky_key_time(const WelkinSky* sky, uint32_t index, double* time_h);
/* The settings that the file was baked with, as JSON; terminated, borrowed from the sky. */
WELKIN_API WelkinResult welkin_sky_settings(const WelkinSky* sky, const char** json);

/* The sky at `time_h`. A NaN or an infinity is WELKIN_ERROR_ARGUMENT. When `sample` holds the result already, bit for
 * bit, it stays as it is with `unchanged` 1, and an upload that followed the last call need not be repeated. */
WELKIN_API WelkinResult welkin_sky_sample(const WelkinSky* sky, double time_h, WelkinSkySample* sample);

/* Irradiance E (pi included) of a surface with unit `normal` from sky and ground, RGB, clamped at 0: the best that the
 * file holds, from its modes when it has them, else from the coefficients. The file's certificate speaks of this one.
 * `sample` has come from the same sky, or from welkin_sample_blend. */
WELKIN_API WelkinResult welkin_sky_irradiance(const WelkinSky* sky, const WelkinSkySample* sample,
                                              const float normal[3], float irradiance[3]);

/* The same from the sample's ambient coefficients alone. */
WELKIN_API WelkinResult welkin_sample_irradiance(const WelkinSkySample* sample, const float normal[3],
                                                 float irradiance[3]);

/* Cross-blend of two skies (weather): lights, tint, ambient coefficients and ground, `weight` in [0, 1] of the second.
 * Directions are blended and normalised; modes are left out, and irradiance comes from the coefficients. What only
 * makes sense with one sky's file (luminance_norm, intensity, cubemaps) stays the first's: draw both domes, the second
 * with the weight as opacity. Both must have the same coefficient count. */
WELKIN_API WelkinResult welkin_sample_blend(const WelkinSkySample* first, const WelkinSkySample* second, float weight,
                                            WelkinSkySample* blended);

/* The one directional light of a renderer that shadows one: the sun or the moon, whichever lights a facing surface more
 * (`visible` counts). Its irradiance is lessened by the other's, so that it is 0 where they change places and nothing
 * jumps when its direction does. `visible` is in it and then 1. */
WELKIN_API WelkinResult welkin_sample_key_light(const WelkinSkySample* sample, WelkinLight* light);

/* The first three bands of the ambient light, ready for Filament's and Unity's shaders. Bands beyond are left out:
 * their irradiance is at most a few percent (band 3 has none). */
WELKIN_API WelkinResult welkin_pack_filament(const WelkinSkySample* sample, WelkinFilamentIrradianceOverPi* packed);
WELKIN_API WelkinResult welkin_pack_unity(const WelkinSkySample* sample, WelkinUnityIrradianceOverPi* packed);

/* Radiance of the sky dome in unit `direction`, from the formulas and gradients (not the cubemaps), RGB: tint and
 * ground in it, sun and moon not. Evaluated in double; the GPU's dome is compared with it. */
WELKIN_API WelkinResult welkin_dome_radiance(const WelkinSky* sky, const WelkinSkySample* sample,
                                             const float direction[3], float radiance[3]);

/* Radiance of the discs of the sun and the moon in unit `direction`, RGB, softened over `pixel_rad` radians: to be
 * added to the dome's. The moon shows its phase under the sample's sun. Nothing below the horizon. */
WELKIN_API WelkinResult welkin_disc_radiance(const WelkinSkySample* sample, const float direction[3], float pixel_rad,
                                             float radiance[3]);

/* Radiance of the star map in unit `direction`, RGB, bilinear, faded by the dome's luminance there: to be added to it.
 * 0 below the horizon and without a map. */
WELKIN_API WelkinResult welkin_star_radiance(const WelkinSky* sky, const WelkinSkySample* sample,
                                             const float direction[3], float radiance[3]);

#ifdef __cplusplus
}
#endif

#endif
