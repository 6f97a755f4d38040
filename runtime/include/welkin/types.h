/* SPDX-License-Identifier: Apache-2.0
 *
 * Values of the Welkin runtime's C interface: results, options, descriptions of a sky, and its samples. welkin.h has
 * their conventions and the functions.
 *
 * A struct that begins with struct_size can grow at its end in a later release. A caller sets struct_size to the size
 * of the struct in its own header; in C++ that is its default value. The library neither reads nor writes past it. A
 * size below that of the first release, or above that of the library, is WELKIN_ERROR_ARGUMENT. All other structs stay
 * as they are.
 */
#ifndef WELKIN_TYPES_H
#define WELKIN_TYPES_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
#define WELKIN_STRUCT_SIZE(type) uint32_t struct_size = sizeof(type)
extern "C" {
#else
#define WELKIN_STRUCT_SIZE(type) uint32_t struct_size
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
  WELKIN_ERROR_DEVICE = 9,    /* a Vulkan call failed, or the device lacks a feature */
  WELKIN_ERROR_KIND = 10      /* a .welkin file of another kind, such as a sector where a sky is needed */
} WelkinResult;

/* The reason for a failure, in English, terminated by a zero. A function that takes a pointer to one fills it only when
 * the function fails. The pointer may be null. */
typedef struct WelkinMessage {
  char text[256];
} WelkinMessage;

/* Kind of a file by its first bytes. */
typedef enum WelkinFileKind {
  WELKIN_FILE_FOREIGN = 0, /* not a .welkin file, or cut before its header ends */
  WELKIN_FILE_SKY = 1,     /* sky.welkin: the sky over a day */
  WELKIN_FILE_SECTOR = 2,  /* sectors/sector_X_Z.welkin: the probes of a square of 64 m of a level */
  WELKIN_FILE_LEVEL = 3    /* level.welkin: the index of a level's files */
} WelkinFileKind;

/* An opened sky. It holds the memory mapping of its file, or a copy of it. */
typedef struct WelkinSky WelkinSky;

/* Memory of the game for all that opening a sky allocates. Both functions may be called by any thread that opens or
 * closes a sky with it, and must not throw. */
typedef struct WelkinAllocator {
  WELKIN_STRUCT_SIZE(WelkinAllocator);
  uint32_t reserved; /* 0 */
  void* user;
  /* Returns `bytes` > 0 bytes at an address that `alignment`, a power of two, divides. Null: there are none. */
  void* (*allocate)(void* user, size_t bytes, size_t alignment);
  void (*free)(void* user, void* address, size_t bytes);
} WelkinAllocator;

typedef enum WelkinLogLevel {
  WELKIN_LOG_INFO = 0,    /* a file was opened: its size, its format and its stated error */
  WELKIN_LOG_WARNING = 1, /* the file can be used, but not as its author may believe: its error was not measured */
  WELKIN_LOG_ERROR = 2    /* the text of the message with which the call fails */
} WelkinLogLevel;

/* Receives one line about a call, without a line break. It is called during the call, by the thread of the call. */
typedef struct WelkinLog {
  WELKIN_STRUCT_SIZE(WelkinLog);
  uint32_t reserved; /* 0 */
  void* user;
  void (*write)(void* user, WelkinLogLevel level, const char* text);
} WelkinLog;

/* Copies the bytes of the file at once. A mapped file must not be changed while the sky is open (see welkin.h). */
#define WELKIN_OPEN_COPY 1u

/* The source of a sky, and the ways to open it. Zero-initialise it; give either `path` or `data`. */
typedef struct WelkinOpenInfo {
  WELKIN_STRUCT_SIZE(WelkinOpenInfo);
  uint32_t flags;                   /* 0 or WELKIN_OPEN_COPY */
  const char* path;                 /* a file; UTF-8 on Windows */
  const void* data;                 /* or its bytes; aligned to 16, unless they are copied */
  size_t size;                      /* number of bytes at `data` */
  const WelkinAllocator* allocator; /* null: malloc. Copied: need not outlive the call */
  const WelkinLog* log;             /* null: none. Used during the call alone */
} WelkinOpenInfo;

/* Format of a cubemap's texels, little-endian. */
typedef enum WelkinCubemapFormat {
  WELKIN_CUBEMAP_RGBA16F = 0,  /* IEEE half floats, alpha 1: VK_FORMAT_R16G16B16A16_SFLOAT, 8 bytes */
  WELKIN_CUBEMAP_RGB9E5 = 1,   /* shared exponent: VK_FORMAT_E5B9G9R9_UFLOAT_PACK32, 4 bytes */
  WELKIN_CUBEMAP_B10G11R11 = 2 /* small floats: VK_FORMAT_B10G11R11_UFLOAT_PACK32, 4 bytes */
} WelkinCubemapFormat;

/* Sizes and constants of a sky. */
typedef struct WelkinSkyInfo {
  WELKIN_STRUCT_SIZE(WelkinSkyInfo);
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

/* The sky at an instant: all that a frame needs. Zero-initialise it before its first use. Its arrays
 * have the sizes of the largest sky. */
typedef struct WelkinSkySample {
  WELKIN_STRUCT_SIZE(WelkinSkySample);
  uint32_t unchanged; /* 1 if the sample already held this result, bit for bit; else 0 */
  double time_h;      /* hours, in [0, 24) */
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
  uint32_t mode_count;                           /* number of weights below; 0 without modes, and after a blend of
                                                    skies that do not share their modes */
  float mode_weight[WELKIN_MAX_MODES][3];        /* RGB weight of each mode, after desaturation. The weighted modes
                                                    sum to the sky's irradiance, pi included, without ground */
  float mode_azimuth[2]; /* x and z of the unit horizontal direction towards the sun's azimuth; within 1e-5 rad of
                            the zenith or the nadir it fades to 0 */
  uint32_t cubemap[2];   /* indices of the two cubemaps to blend; equal if there is one, 0 without */
  float cubemap_weight;  /* weight of the second cubemap, in [0, 1): sky = mix(first, second, weight) */
  uint64_t mode_family;  /* WelkinModes::family of the modes that the weights are of; 0 without modes */
} WelkinSkySample;

/* Coefficients of the sky's relative luminance, in the form of the CIE standard general sky. The file
 * shaders/shared/luminance.glsl has the formula and its sources. b < 0, d < 0. */
typedef struct WelkinLuminance {
  WELKIN_STRUCT_SIZE(WelkinLuminance);
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
  WELKIN_STRUCT_SIZE(WelkinGradients);
  WelkinGradient sun;  /* colours at the sun's azimuth */
  WelkinGradient anti; /* colours at the opposite azimuth */
  float delta;         /* luminance below which a gradient's colour fades to grey, > 0 */
} WelkinGradients;

/* A cubemap in Vulkan's orientation: faces +x, -x, +y, -y, +z, -z, each size x size texels, rows from the top. It shows
 * the tinted sky and the ground, without sun and moon. Every component is finite and at least 0. The texels belong to
 * the sky: they live until it is closed. */
typedef struct WelkinCubemap {
  WELKIN_STRUCT_SIZE(WelkinCubemap);
  uint32_t size; /* texels along an edge, 1..16384 */
  double time_h; /* hours, in [0, 24) */
  WelkinCubemapFormat format;
  const void* texels; /* aligned to 16 */
  size_t bytes;       /* size of all six faces */
} WelkinCubemap;

/* A star map: width x height texels, sRGB-encoded RGBA, rows from the celestial north pole. The file
 * shaders/shared/stars.glsl maps directions to texels. The texels belong to the sky: they live until it is closed. */
typedef struct WelkinStars {
  WELKIN_STRUCT_SIZE(WelkinStars);
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
  WELKIN_STRUCT_SIZE(WelkinModes);
  uint32_t count;         /* 0..12; 0 without modes */
  uint32_t columns, rows; /* 2..256 */
  const uint16_t* texels;
  uint64_t family; /* hash of the modes, not 0; skies that were baked as a family share them. 0 without modes */
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
  WELKIN_STRUCT_SIZE(WelkinCertificate);
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
  double dome_error;   /* error of welkin_dome_radiance, measured as cubemap_error is */
  double blend_error;  /* largest error of the blends with each sky of its family, as max_error; 0 for a sky alone */
  double blend_time_h; /* hour of blend_error, in [0, 24) */
} WelkinCertificate;

#ifdef __cplusplus
}
#endif

#endif
