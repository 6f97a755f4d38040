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

/* The reason of a failure, in English, terminated by a zero. A function that takes one fills it only when it fails.
 * The pointer may be null. */
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
  uint32_t bands;                     /* of the coefficients, 2..5 */
  uint32_t coefficient_count;         /* bands^2 */
  uint32_t key_count;                 /* keys of the day's table, >= 1 */
  uint32_t mode_count;                /* modes of the irradiance, 0..12; 0: the coefficients give the irradiance */
  uint32_t cubemap_count;             /* 0 without cubemaps */
  uint32_t cubemap_size;              /* texels along a face's edge; 0 without cubemaps */
  WelkinCubemapFormat cubemap_format; /* of all cubemaps */
  uint32_t has_moon;                  /* 0 or 1 */
  float luminance_unit;               /* luminance of radiance 1, cd/m2, > 0 */
  float ground_albedo[3];             /* RGB, 0..1 */
} WelkinSkyInfo;

/* The sun or the moon at an instant. */
typedef struct WelkinLight {
  float direction[3];         /* unit vector towards the light; a light below the horizon lights nothing */
  float illuminance;          /* of a surface that faces the light, scene units, >= 0 */
  float colour[3];            /* the artist's colour; only its hue and saturation count */
  float normal_irradiance[3]; /* RGB irradiance of a surface that faces the light:
                                 illuminance * colour / luminance(colour) */
  float disc_radius_rad;      /* angular radius of the disc that the dome draws, 0..pi/2; 0: no disc */
  float visible;              /* share of the disc above the horizon, 0..1. Multiply the irradiance by it: the light
                                 then rises and sets without a jump. A light without a disc counts as one of half a
                                 degree across */
} WelkinLight;

/* The sky at an instant: all that a frame needs. Zero-initialise it before its first use. */
typedef struct WelkinSkySample {
  double time_h; /* hours, in [0, 24) */
  WelkinLight sun;
  WelkinLight moon;           /* all zero without a moon */
  float intensity;            /* factor on the sky's radiance, >= 0; it is already in the coefficients */
  float ambient_saturation;   /* saturation of the ambient coefficients, 0..1 */
  float polarising_tint[3];   /* RGB factor on the dome above the horizon, in the cubemaps too */
  float ground_radiance[3];   /* RGB radiance below the horizon, scene units */
  float luminance_norm;       /* relative luminance that the dome divides by, > 0 */
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

/* Irradiance over pi, which an albedo multiplies, RGB, world axes. The coefficients are scaled as Filament's
 * IndirectLight::Builder::irradiance takes them:
 * sh0 + sh1 y + sh2 z + sh3 x + sh4 yx + sh5 yz + sh6 (3 z2 - 1) + sh7 zx + sh8 (x2 - y2). */
typedef struct WelkinFilamentIrradianceOverPi {
  float sh[9][3];
} WelkinFilamentIrradianceOverPi;

/* Irradiance over pi in Unity's seven constants. For a channel it is
 * dot(SHA, (n, 1)) + dot(SHB, n.xyzz * n.yzzx) + SHC (x2 - y2).
 * The normal n has the world axes of this library: negate z of a normal of a left-handed world. */
typedef struct WelkinUnityIrradianceOverPi {
  float shar[4], shag[4], shab[4]; /* x, y, z, constant */
  float shbr[4], shbg[4], shbb[4]; /* xy, yz, zz, zx */
  float shc[4];                    /* x2 - y2: red, green, blue, and 1 */
} WelkinUnityIrradianceOverPi;

/* Coefficients of the relative luminance, the CIE standard general sky; shaders/shared/luminance.glsl has its formula
 * and its sources. b < 0, d < 0. */
typedef struct WelkinLuminance {
  float a, b, c, d, e, k;
  uint32_t normalise_to_sun; /* 1: luminance 1 is at the sun; 0: at the zenith */
} WelkinLuminance;

/* A gradient image: rows from the horizon to the zenith, columns over the day from 0 h. The floats, row-major RGB of at
 * least 0, belong to the sky: they live until it is closed. */
typedef struct WelkinGradient {
  uint32_t width, height;
  const float* rgb;
} WelkinGradient;

typedef struct WelkinGradients {
  WelkinGradient sun;  /* colours at the sun's azimuth */
  WelkinGradient anti; /* colours at the opposite azimuth */
  float delta;         /* luminance below which a gradient's colour fades to grey, > 0 */
} WelkinGradients;

/* A cubemap in Vulkan's orientation: faces +x, -x, +y, -y, +z, -z, each size x size texels, rows from the top. It shows
 * the sky with its tint, and the ground, but neither sun nor moon. Every component is finite and at least 0. The texels
 * belong to the sky: they live until it is closed. */
typedef struct WelkinCubemap {
  double time_h; /* hours, in [0, 24) */
  uint32_t size; /* texels along an edge, 1..16384 */
  WelkinCubemapFormat format;
  const void* texels; /* aligned to 16 */
  size_t bytes;       /* of all six faces */
} WelkinCubemap;

/* A star map: width x height texels, sRGB-encoded RGBA, rows from the celestial north pole. Directions of its texels:
 * shaders/shared/stars.glsl. The texels belong to the sky: they live until it is closed. */
typedef struct WelkinStars {
  uint32_t width, height; /* 0 x 0: no stars */
  const uint8_t* rgba8;
  float intensity;        /* radiance of white, scene units, >= 0 */
  float latitude_rad;     /* of the observer, in [-pi/2, pi/2] */
  float north_offset_rad; /* angle from true north to the world's -z */
  double midnight_h;      /* hour at which the middle column crosses the meridian, in [0, 24] */
} WelkinStars;

/* Modes of the sky's irradiance over the day: a map of IEEE half floats, row-major, `count` modes a texel. Read it
 * bilinearly at modeColumn and modeRow of an upper normal (shaders/shared/modes.glsl). Coordinates 0 and 1 are the
 * centres of the outer texels. The texels belong to the sky: they live until it is closed. */
typedef struct WelkinModes {
  uint32_t count;         /* 0..12; 0 without modes */
  uint32_t columns, rows; /* 2..256 */
  const uint16_t* texels;
} WelkinModes;

/* Reference that the file's irradiance was compared with when it was baked. */
typedef enum WelkinCertificateMethod {
  WELKIN_CERTIFICATE_NONE = 0, /* not measured */
  WELKIN_CERTIFICATE_FAST = 1, /* the model's irradiance at 884 normals on both sides of the sun's vertical plane */
  WELKIN_CERTIFICATE_FULL = 2  /* that, and a direct integration at 642 evenly spread normals */
} WelkinCertificateMethod;

/* Error of a file's irradiance, measured through this runtime when it was baked. The error is |E - E_ref| of the worst
 * channel, divided by the mean of E_ref over all normals (docs/conventions.md). All errors are fractions: 0.01 is 1 %.
 */
typedef struct WelkinCertificate {
  WelkinCertificateMethod method; /* NONE: all else is 0 */
  double max_error;
  double time_h;    /* hour of max_error, in [0, 24) */
  double normal[3]; /* normal of max_error, unit */
  uint32_t channel; /* channel of max_error; 0, 1, 2: red, green, blue */
  double mean_error;
  double quadrature, truncation, time, encoding; /* largest error from each cause */
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

/* The same for `size` bytes at `data`. They are aligned to 16, and stay unchanged until the sky is closed. */
WELKIN_API WelkinResult welkin_sky_open_memory(const void* data, size_t size, WelkinSky** sky, WelkinMessage* message);

/* Closes a sky and frees its memory. Null is allowed. Pointers that the sky gave out become invalid. */
WELKIN_API void welkin_sky_close(WelkinSky* sky);

/* Sizes, luminance model and gradients of a sky. */
WELKIN_API WelkinResult welkin_sky_info(const WelkinSky* sky, WelkinSkyInfo* info);
WELKIN_API WelkinResult welkin_sky_luminance(const WelkinSky* sky, WelkinLuminance* luminance);
WELKIN_API WelkinResult welkin_sky_gradients(const WelkinSky* sky, WelkinGradients* gradients);
/* Cubemap `index`, in [0, cubemap_count); cubemaps are sorted by time. Another index is WELKIN_ERROR_ARGUMENT. */
WELKIN_API WelkinResult welkin_sky_cubemap(const WelkinSky* sky, uint32_t index, WelkinCubemap* cubemap);
/* The star map; all fields are 0 without one. */
WELKIN_API WelkinResult welkin_sky_stars(const WelkinSky* sky, WelkinStars* stars);
/* The modes of the irradiance; all fields are 0 without modes. */
WELKIN_API WelkinResult welkin_sky_modes(const WelkinSky* sky, WelkinModes* modes);
/* The error that the bake measured; all fields are 0 if it measured none. */
WELKIN_API WelkinResult welkin_sky_certificate(const WelkinSky* sky, WelkinCertificate* certificate);
/* Hour of key `index`, in [0, key_count); hours ascend with the index. Another index is WELKIN_ERROR_ARGUMENT. */
WELKIN_API WelkinResult welkin_sky_key_time(const WelkinSky* sky, uint32_t index, double* time_h);
/* The settings of the bake as JSON, terminated by a zero. The text belongs to the sky: it lives until that is closed.
 */
WELKIN_API WelkinResult welkin_sky_settings(const WelkinSky* sky, const char** json);

/* Writes the sky at `time_h` hours. A NaN or an infinity is WELKIN_ERROR_ARGUMENT. If `sample` already holds the
 * result, bit for bit, `unchanged` becomes 1: an upload after the last call need not be repeated. */
WELKIN_API WelkinResult welkin_sky_sample(const WelkinSky* sky, double time_h, WelkinSkySample* sample);

/* RGB irradiance, pi included, of a surface from sky and ground, scene units, at least 0. `normal` is a unit vector.
 * The modes give it if the sample has them, else the ambient coefficients. The certificate measures this function.
 * `sample` is of the same sky or of welkin_sample_blend; one with another number of modes is WELKIN_ERROR_ARGUMENT. */
WELKIN_API WelkinResult welkin_sky_irradiance(const WelkinSky* sky, const WelkinSkySample* sample,
                                              const float normal[3], float irradiance[3]);

/* The same, from the sample's ambient coefficients alone. */
WELKIN_API WelkinResult welkin_sample_irradiance(const WelkinSkySample* sample, const float normal[3],
                                                 float irradiance[3]);

/* Blends two skies, for weather: lights, tint, ambient coefficients and ground. `weight`, in [0, 1], is of the second.
 * Directions are blended and normalised. The blend has no modes: the coefficients give its irradiance. Fields that
 * belong to one file (luminance_norm, intensity, cubemaps) are the first's. So draw both domes, the second with the
 * weight as its opacity. Different coefficient counts and other weights are WELKIN_ERROR_ARGUMENT. */
WELKIN_API WelkinResult welkin_sample_blend(const WelkinSkySample* first, const WelkinSkySample* second, float weight,
                                            WelkinSkySample* blended);

/* The light for a renderer with one shadowed directional light: the sun or the moon, whichever lights a facing surface
 * more. Its irradiance is reduced by the other's. So it is 0 where the two change places, and the change of direction
 * does not show. `visible` is multiplied into the irradiance, and is then 1. */
WELKIN_API WelkinResult welkin_sample_key_light(const WelkinSkySample* sample, WelkinLight* light);

/* The first three bands of the ambient light, ready for Filament's and Unity's shaders. Higher bands are left out: band
 * 3 has no irradiance, and band 4 at most a few percent. */
WELKIN_API WelkinResult welkin_pack_filament(const WelkinSkySample* sample, WelkinFilamentIrradianceOverPi* packed);
WELKIN_API WelkinResult welkin_pack_unity(const WelkinSkySample* sample, WelkinUnityIrradianceOverPi* packed);

/* RGB radiance of the dome in unit `direction`, scene units, from the formulas and gradients, not the cubemaps. It
 * shows the sky with its tint, and the ground, but neither sun nor moon. It is evaluated in double, as the reference of
 * the GPU's dome. `sample` is of the same sky. */
WELKIN_API WelkinResult welkin_dome_radiance(const WelkinSky* sky, const WelkinSkySample* sample,
                                             const float direction[3], float radiance[3]);

/* RGB radiance of the sun's and the moon's discs in unit `direction`, to be added to the dome's; 0 below the horizon.
 * Their edges are softened over `pixel_rad` >= 0 radians. The moon shows its phase under the sample's sun. */
WELKIN_API WelkinResult welkin_disc_radiance(const WelkinSkySample* sample, const float direction[3], float pixel_rad,
                                             float radiance[3]);

/* RGB radiance of the star map in unit `direction`, to be added to the dome's, whose luminance fades it. The map is
 * read bilinearly. 0 below the horizon and without a map. */
WELKIN_API WelkinResult welkin_star_radiance(const WelkinSky* sky, const WelkinSkySample* sample,
                                             const float direction[3], float radiance[3]);

#ifdef __cplusplus
}
#endif

#endif
