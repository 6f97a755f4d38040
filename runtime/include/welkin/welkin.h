/* SPDX-License-Identifier: Apache-2.0
 *
 * Welkin runtime: opens a baked sky (.welkin) and blends it to any time of day. C99; welkin.hpp wraps it for C++17.
 *
 * Use
 *   At load time    welkin_sky_open_file.
 *   Every frame     welkin_sky_sample. The sample holds sun, moon, ambient light, ground and the cubemaps to blend.
 *                   welkin_vulkan.h draws it and passes it to shaders; welkin_sky_irradiance gives light on the CPU.
 *                   On another graphics API, welkin_sky_constants fills the uniform block of the shaders.
 *   At the end      welkin_sky_close.
 *
 * Conventions
 *   Axes         right-handed, +x east, +y up, -z north. A direction points away from the observer.
 *   Vectors      a normal or direction of the caller has finite components and a length within 0.1 % of 1; any other
 *                is WELKIN_ERROR_ARGUMENT. It is used as it is: the error of its length is in the result.
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
 *   The only state outside the objects is the text of welkin_argument_error, which each thread has for itself.
 *   Functions that take a const WelkinSky may be called from any number of threads at once. welkin_sky_close must not
 *   overlap any other call on the same sky. Only opening allocates. Nothing throws.
 *
 * Errors
 *   Every function that returns a WelkinResult returns WELKIN_ERROR_ARGUMENT for a null pointer or a struct_size out of
 *   range, unless its comment allows null. On an error the output is left as it was, unless its comment says otherwise.
 */
#ifndef WELKIN_WELKIN_H
#define WELKIN_WELKIN_H

#include <welkin/types.h>

/* Version of this header: major, minor, patch. docs/runtime.md states the changes that each may bring. */
#define WELKIN_VERSION_MAJOR 0
#define WELKIN_VERSION_MINOR 2
#define WELKIN_VERSION_PATCH 0
#define WELKIN_VERSION ((WELKIN_VERSION_MAJOR << 20) | (WELKIN_VERSION_MINOR << 10) | WELKIN_VERSION_PATCH)

/* WELKIN_SHARED_LIBRARY: the program links the shared library. The package's target welkin::library sets it. */
#if defined(_WIN32) && defined(WELKIN_SHARED_LIBRARY)
#define WELKIN_API __declspec(dllimport)
#elif defined(__GNUC__) && !defined(_WIN32)
#define WELKIN_API __attribute__((visibility("default")))
#else
#define WELKIN_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* WELKIN_VERSION of the library that runs. A library of the same major version, and while that is 0 of the same minor
 * version, works with programs that were compiled against an older header. */
WELKIN_API uint32_t welkin_version(void);

/* Version of the format of skies that this library reads and the tool of the same release writes. */
WELKIN_API uint32_t welkin_format_version(void);

/* A short English description of a result. Never null; the text is static. */
WELKIN_API const char* welkin_result_string(WelkinResult result);

/* The argument that this thread's last WELKIN_ERROR_ARGUMENT was about, and the rule that it breaks, such as
 * "welkin_sky_sample: time_h is nan, must be finite". Never null; empty before the first. The text stays until the
 * thread's next such error. */
WELKIN_API const char* welkin_argument_error(void);

/* Kind of the file whose first bytes are `data`; 64 bytes are enough. Nothing behind the header is checked. */
WELKIN_API WelkinFileKind welkin_file_kind(const void* data, size_t size);

/* Opens the baked sky at `path` and checks its header, checksum, structure and every value. It reads the file once. On
 * an error *sky is null, and `message` gives the reason and the path. Every error but WELKIN_ERROR_DEVICE is possible.
 *
 * The file is mapped: its bytes must stay as they are until the sky is closed. A file that is overwritten in place can
 * end the program by a signal, or give light that nothing checked. To replace it, write another file and rename it
 * over the first, as the tool does; the open sky then keeps the old bytes. Else open it with WELKIN_OPEN_COPY. */
WELKIN_API WelkinResult welkin_sky_open_file(const char* path, WelkinSky** sky, WelkinMessage* message);

/* Opens a baked sky of `size` bytes at `data`, as welkin_sky_open_file does. `data` must be aligned to 16, else
 * WELKIN_ERROR_ARGUMENT. The sky reads the bytes in place: keep them unchanged until it is closed. */
WELKIN_API WelkinResult welkin_sky_open_memory(const void* data, size_t size, WelkinSky** sky, WelkinMessage* message);

/* Opens a sky in one of these two ways, with the game's memory, a log, or a copy of the bytes. */
WELKIN_API WelkinResult welkin_sky_open(const WelkinOpenInfo* info, WelkinSky** sky, WelkinMessage* message);

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

struct WelkinSkyConstants;

/* Writes the sky at `time_h` hours to `sample`. A NaN or an infinity is WELKIN_ERROR_ARGUMENT. If `sample` already
 * holds the result, bit for bit, `unchanged` becomes 1: no new upload is needed then. */
WELKIN_API WelkinResult welkin_sky_sample(const WelkinSky* sky, double time_h, WelkinSkySample* sample);

/* RGB irradiance of a surface from sky and ground: pi included, scene units, at least 0. `normal` is a unit vector. The
 * result comes from the modes if the sample has them, else from the ambient coefficients. The certificate measures this
 * function. `sample` comes from the same sky or from welkin_sample_blend; a sample of other modes is
 * WELKIN_ERROR_ARGUMENT. */
WELKIN_API WelkinResult welkin_sky_irradiance(const WelkinSky* sky, const WelkinSkySample* sample,
                                              const float normal[3], float irradiance[3]);

/* The same irradiance, from the sample's ambient coefficients alone. More than WELKIN_MAX_COEFFICIENTS of them are
 * WELKIN_ERROR_ARGUMENT. */
WELKIN_API WelkinResult welkin_sample_irradiance(const WelkinSkySample* sample, const float normal[3],
                                                 float irradiance[3]);

/* Blends two skies, for weather: lights, tint, ambient coefficients and ground. `weight`, in [0, 1], is the weight of
 * the second sky. Directions are blended and normalised. Skies that were baked as a family share their modes: their
 * blend has modes, and its irradiance is the blend of both. Other blends have none, nor have samples whose suns differ
 * in azimuth: the coefficients give their irradiance. Fields that belong to one file (luminance_norm, intensity,
 * cubemaps) are copied from the first sample. So draw both domes, the second with `weight` as its opacity. Different
 * coefficient counts and other weights are WELKIN_ERROR_ARGUMENT. */
WELKIN_API WelkinResult welkin_sample_blend(const WelkinSkySample* first, const WelkinSkySample* second, float weight,
                                            WelkinSkySample* blended);

/* The light for a renderer with one shadowed directional light: the sun or the moon, whichever lights a facing surface
 * more. Its irradiance and illuminance are reduced by the other light's. So they are 0 at the moment when the two
 * change places, and the change of direction does not show. They already contain `visible`, which is 1 in the result.
 */
WELKIN_API WelkinResult welkin_sample_key_light(const WelkinSkySample* sample, WelkinLight* light);

/* Fills the first `size` bytes of the uniform block through which shaders/welkin/dome.glsl, ambient.glsl and modes.glsl
 * read the sky: WelkinSkyConstants of welkin/sky_constants.h, the same struct as in the shaders. `size` is a multiple
 * of 16, at most its size and at least that of its first release, 832. welkin_vulkan_update does the same on Vulkan.
 * `sample` comes from the same sky. */
WELKIN_API WelkinResult welkin_sky_constants(const WelkinSky* sky, const WelkinSkySample* sample,
                                             struct WelkinSkyConstants* constants, size_t size);

/* Replaces the ambient light in such a block by that of a cross-blend from welkin_sample_blend; `size` as above. */
WELKIN_API WelkinResult welkin_sample_ambient_constants(const WelkinSkySample* blended,
                                                        struct WelkinSkyConstants* constants, size_t size);

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

#ifdef __cplusplus
}
#endif

#endif
