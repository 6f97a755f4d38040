/* SPDX-License-Identifier: Apache-2.0
 *
 * Probes of a baked level (level.welkin, sectors/sector_X_Z.welkin): streamed, relit for any time of day, and looked up
 * at points. C99; conventions, threads and errors as in welkin.h. Stefanov, "Deferred Radiance Transfer Volumes"
 * (GDC 2012).
 *
 * Use
 *   At load time    welkin_level_open, with the sky of the same bake.
 *   Streaming       welkin_sector_open on any thread; welkin_level_add and welkin_level_remove between frames. The two
 *                   only link and unlink, so they never stall.
 *   Every frame     welkin_level_set_lights if there are dynamic lights, welkin_level_set_light with a sample of the
 *                   sky, welkin_level_relight with a budget, then welkin_level_irradiance or welkin_level_colours for
 *                   characters, particles and transparents.
 *   At the end      welkin_level_close, which closes the resident sectors too.
 *
 * Threads
 *   Functions that take a const WelkinLevel may be called from any number of threads at once, but not while a function
 *   that changes the level runs. welkin_level_relight_range changes the probes of its range only.
 *   Only opening allocates.
 */
#ifndef WELKIN_LEVEL_H
#define WELKIN_LEVEL_H

#include <welkin/welkin.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The index of an opened level, and the sectors that are resident. */
typedef struct WelkinLevel WelkinLevel;
/* An opened sector: a square of 64 m, its probes and their light. */
typedef struct WelkinSector WelkinSector;

/* Limits of a level. Zero-initialise it for the defaults. */
typedef struct WelkinLevelLimits {
  WELKIN_STRUCT_SIZE(WelkinLevelLimits);
  uint32_t sector_capacity; /* most resident sectors, 1..65535; 0: 64 */
  uint32_t light_capacity;  /* most dynamic lights, 1..65536 of 320 bytes; 0: 256 */
} WelkinLevelLimits;

/* The form of the bounced light of sun and moon. */
typedef enum WelkinSunTransfer {
  WELKIN_SUN_TRANSFER_NONE = 0,       /* none */
  WELKIN_SUN_TRANSFER_SH = 1,         /* by the sky's transfer, in 2 bands */
  WELKIN_SUN_TRANSFER_DIRECTIONAL = 2 /* by its own transfer along the path of the light */
} WelkinSunTransfer;

/* Sizes of a level. */
typedef struct WelkinLevelInfo {
  WELKIN_STRUCT_SIZE(WelkinLevelInfo);
  uint32_t sector_count;    /* sectors of the index */
  uint32_t probe_count;     /* their probes */
  uint32_t sector_capacity; /* most resident sectors */
  uint32_t resident_sectors;
  uint32_t resident_probes;
  uint64_t resident_bytes; /* memory of the resident sectors, without the files' own */
  WelkinSunTransfer sun_transfer;
  float sky_scale, sun_bounce_scale; /* the artist's factors, which relighting applies */
  uint32_t light_capacity;           /* most dynamic lights */
} WelkinLevelInfo;

/* A sector in the index. Its file is sectors/sector_X_Z.welkin. */
typedef struct WelkinSectorEntry {
  int32_t x, z;    /* floor(x / 64 m) and floor(z / 64 m) of its points */
  uint32_t probes; /* 0..255 */
  uint32_t reserved;
  uint64_t bytes; /* size of the file */
} WelkinSectorEntry;

/* Light of one instant on the probes. */
typedef struct WelkinLevelLight {
  WELKIN_STRUCT_SIZE(WelkinLevelLight);
  uint32_t reserved;             /* 0 */
  const WelkinSkySample* sample; /* of the level's sky, or a blend; used during the call alone */
  float sky, sun_bounce, local;  /* the game's factors on the three parts, finite, >= 0; 1 leaves them as they are.
                                    The third is on emitted light, the level's own lights and dynamic lights */
} WelkinLevelLight;

/* Result of relighting. */
typedef struct WelkinRelight {
  WELKIN_STRUCT_SIZE(WelkinRelight);
  uint32_t relit;     /* probes that this call relit; 0: nothing changed */
  uint32_t remaining; /* probes that still have the light of an earlier instant */
} WelkinRelight;

/* A dynamic light of the game: a lamp, or with a cone a spot. Its position and its light may change in every frame. The
 * probes get the light that the level reflects of it; what shines on a surface directly is the game's to add. */
typedef struct WelkinPointLight {
  float position[3];          /* metres, below 2^30 */
  float intensity[3];         /* radiant intensity on the axis, RGB, scene units, 0 to 1e15 */
  float direction[3];         /* of a spot: its axis, a unit vector */
  float inner_rad, outer_rad; /* of a spot: angles off the axis, 0 <= inner <= outer <= pi and outer > 0. The light is
                                 whole up to the first and ends at the second, as in glTF's KHR_lights_punctual,
                                 with cosines at least 0.001 apart. outer 0 is a lamp: direction and inner have no
                                 meaning */
  uint32_t revision;          /* any number; another one has the sight of this light tested again, as after a door
                                 near it has opened */
} WelkinPointLight;

/* Tells whether the straight line between two points, metres, is free: not 0 if it is. It must not call the level. */
typedef int (*WelkinSees)(void* user, const float from[3], const float to[3]);

/* Result of welkin_level_set_lights. */
typedef struct WelkinLightsResult {
  WELKIN_STRUCT_SIZE(WelkinLightsResult);
  uint32_t unseen;  /* lights that no virtual light sees: they are left out */
  uint32_t shared;  /* lights that this call shared anew */
  uint32_t sectors; /* sectors whose local light this call changed, */
  uint32_t probes;  /* and their probes, which have to be relit */
} WelkinLightsResult;

/* Irradiance of a place in the directions of the transfer basis, RGB, pi included: three directions that look up and
 * one that looks down (welkin_colours_irradiance has the weights that shade with them). */
typedef struct WelkinColours {
  float irradiance[4][3];
} WelkinColours;

/* Opens the index of a level (level.welkin) from `info`, as welkin_sky_open opens a sky. `sky` is the sky of the bake,
 * or one for other weather: its light paths and its ground albedo must be those of the bake, else WELKIN_ERROR_CONTENT.
 * It need not stay open. `limits` may be null. */
WELKIN_API WelkinResult welkin_level_open(const WelkinOpenInfo* info, const WelkinSky* sky,
                                          const WelkinLevelLimits* limits, WelkinLevel** level, WelkinMessage* message);

/* Closes a level and its resident sectors. Null is allowed. */
WELKIN_API void welkin_level_close(WelkinLevel* level);

WELKIN_API WelkinResult welkin_level_info(const WelkinLevel* level, WelkinLevelInfo* info);

/* Entry `index`, in [0, sector_count); entries ascend in x, then z. */
WELKIN_API WelkinResult welkin_level_entry(const WelkinLevel* level, uint32_t index, WelkinSectorEntry* entry);

/* Opens a sector of the level: checks its header, its checksum, every value, and that it is the file that the index
 * names. Else WELKIN_ERROR_CONTENT: it is of another bake. `data` is aligned to 16 and stays unchanged until the sector
 * is closed. Allocates by the level's allocator. Any thread may call it. */
WELKIN_API WelkinResult welkin_sector_open(const WelkinLevel* level, const void* data, size_t size,
                                           WelkinSector** sector, WelkinMessage* message);

/* Closes a sector that is not resident. Null is allowed. */
WELKIN_API void welkin_sector_close(WelkinSector* sector);

/* Makes a sector resident; the level owns it until it is removed. WELKIN_ERROR_ARGUMENT if it is already resident or
 * belongs to another level; WELKIN_ERROR_MEMORY if sector_capacity sectors are resident. Until its probes are relit
 * they have the light of its last residence, at first black. Relighting begins with such sectors: a budget of at least
 * their probes shows none of them black. */
WELKIN_API WelkinResult welkin_level_add(WelkinLevel* level, WelkinSector* sector);

/* Ends the residence of the sector (x, z) and gives it back to the caller. *sector is null if it is not resident. */
WELKIN_API WelkinResult welkin_level_remove(WelkinLevel* level, int32_t x, int32_t z, WelkinSector** sector);

/* The resident sector whose middle is the farthest from a position in x and z: the one to remove when the capacity is
 * spent. WELKIN_ERROR_ARGUMENT if none is resident. */
WELKIN_API WelkinResult welkin_level_farthest(const WelkinLevel* level, const float position[3], int32_t* x,
                                              int32_t* z);

/* Sets the light that the next relighting uses. If it is that of before, bit for bit, nothing has to be relit. */
WELKIN_API WelkinResult welkin_level_set_light(WelkinLevel* level, const WelkinLevelLight* light);

/* Sets all dynamic lights; those of before are forgotten. Probes of sectors with local transfer show them when they are
 * relit, by WelkinLevelLight::local.
 *
 * A level is baked for lights at fixed places, the virtual lights. Here each light is shared among those that see it,
 * at most 64 m away. R is the distance of the fourth nearest, or of the last if fewer see it. Virtual lights within 1.5
 * R get weights (1 / d - 1 / (1.5 R))^2, divided by their sum; with more than 32 of them the 33rd ends the reach. One
 * at the very place takes all. So shares change smoothly with the position, and their sum is the light. A virtual light
 * that several resident sectors know, at places within 1 mm, counts once.
 *
 * The light that a spot has on the whole sphere is shared, as if it were a lamp of that power. The weight of a virtual
 * light is times 1/16 plus the cone's share in its direction, 0 to 1. So the places that a spot shines at take 17 times
 * as much as others. The 16th keeps a spot alive that shines between all virtual lights, and its turns smooth. A cone
 * of pi, pi is the lamp.
 *
 * `sees` tests from a virtual light to the light, nearest first, until the shares are known. The results are kept: a
 * light is tested again only after it, its revision or `sees` has changed, or virtual lights near it came or went. With
 * null all of them see it, through walls too. The same lights again, bit for bit, cost a comparison. Call it again
 * after sectors came or went. Until then lights keep their shares, and those of a removed sector are missing. The sum
 * over lights is in the order of the array, so that the result does not depend on what was set before.
 *
 * `count` is at most the level's light_capacity. `lights` may be null if it is 0, `sees` and `result` may be null. A
 * relighting that has begun must have ended. Nothing changes after an error. */
WELKIN_API WelkinResult welkin_level_set_lights(WelkinLevel* level, uint32_t count, const WelkinPointLight* lights,
                                                WelkinSees sees, void* user, WelkinLightsResult* result);

/* Relights at most `max_probes` probes that have the light of an earlier instant: those of sectors that came since,
 * then the longest waiting. With UINT32_MAX all of them, and the result is exact. `result` may be null. */
WELKIN_API WelkinResult welkin_level_relight(WelkinLevel* level, uint32_t max_probes, WelkinRelight* result);

/* The same work shared among the caller's threads. `begin` chooses the probes and gives their number. Then every index
 * in [0, count) belongs to exactly one call of `range`; those may overlap in time. `end` is called after all of them.
 */
WELKIN_API WelkinResult welkin_level_relight_begin(WelkinLevel* level, uint32_t max_probes, uint32_t* count);
WELKIN_API WelkinResult welkin_level_relight_range(WelkinLevel* level, uint32_t first, uint32_t count);
WELKIN_API WelkinResult welkin_level_relight_end(WelkinLevel* level, WelkinRelight* result);

/* RGB irradiance, pi included, at `count` points on surfaces or in the air: position and normal, three floats each.
 * The probes of the eight cells about the point, pushed off along the normal, are filtered by the rules of the level:
 * rooms and walls. Nothing is below 0. served[i] becomes 1, or 0 where no probe serves: there the irradiance is 0.
 * `served` may be null. A position that is not finite, or a normal that is not a unit vector, is WELKIN_ERROR_ARGUMENT
 * and leaves all results undefined. */
WELKIN_API WelkinResult welkin_level_irradiance(const WelkinLevel* level, size_t count, const float (*position)[3],
                                                const float (*normal)[3], float (*irradiance)[3], uint8_t* served);

/* The same light for objects without one normal, such as particles: all four directions at each position, not pushed.
 */
WELKIN_API WelkinResult welkin_level_colours(const WelkinLevel* level, size_t count, const float (*position)[3],
                                             WelkinColours* colours, uint8_t* served);

/* RGB irradiance of such colours for a unit normal, at least 0. The weights are exact for irradiance that is linear in
 * the normal (shaders/shared/transfer_basis.glsl). */
WELKIN_API WelkinResult welkin_colours_irradiance(const WelkinColours* colours, const float normal[3],
                                                  float irradiance[3]);

/* Coefficients 0..3 of the radiance that gives this irradiance, in the order of welkin.h. */
WELKIN_API WelkinResult welkin_colours_sh(const WelkinColours* colours, float radiance_sh[4][3]);

#ifdef __cplusplus
}
#endif

#endif
