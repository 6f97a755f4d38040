/* SPDX-License-Identifier: Apache-2.0
 *
 * Volume textures of a level's light around the camera, for lighting per pixel (shaders/welkin/volume.glsl). C99.
 * Stefanov, "Deferred Radiance Transfer Volumes" (GDC 2012): three 3D textures, one a colour channel; the four channels
 * of a texel are the irradiances in the four directions of the transfer basis.
 *
 * A texel holds the light of the cell of the grid that its middle lies in. Texel (x, y, z) is that of every cell whose
 * indices, counted from the world's origin, have these remainders. So the camera moves and no texel does: only slabs
 * that it enters are filled. Sample with repeating coordinates and linear filtering.
 *
 * Filtering alone would light a place through thin walls. So the textures go on after the volume's slices: each side of
 * the walls in a cell, and each cell beside these, has a brick of 3 x 3 x 3 texels there. It is the cell and the 26
 * about it as that side sees them: what lies behind a wall has the light of what lies before it. A buffer of words
 * leads the shader from a place to its brick, and the three fetches are of the brick.
 *
 * Beyond the volume a surface gets the open sky's light, times the sky's visibility in a far map: a texture from above,
 * with a tile for each resident sector about the camera. A texel is a column of cells of 4 m and holds how much of a
 * uniform sky is hidden from the probe that serves the surface seen from above, and that probe's height. The effect
 * fades with the difference of heights. Texels wrap as those of the volume do (shaders/welkin/far.glsl).
 *
 * Every frame: welkin_level_relight, welkin_volume_update, then copy the boxes that changed to the textures, the words
 * that changed to the buffer and the rectangles that changed to the far map, and give welkin_volume_constants to the
 * shader. welkin_vulkan_volume.h does all on Vulkan.
 */
#ifndef WELKIN_VOLUME_H
#define WELKIN_VOLUME_H

#include <welkin/level.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct WelkinVolume WelkinVolume;

typedef enum WelkinVolumeFormat {
  WELKIN_VOLUME_RGBA16F = 0, /* half floats: VK_FORMAT_R16G16B16A16_SFLOAT, 8 bytes */
  WELKIN_VOLUME_RGBA8 = 1, /* VK_FORMAT_R8G8B8A8_UNORM, 4 bytes, over a scale of all texels; light below 0 becomes 0 */
  /* The device relights the probes and fills textures of half floats: welkin_vulkan_volume_record does it, and no call
   * of welkin_level_relight is needed for it. The processor keeps one word for each texel, which probe lights it. So
   * a change of the light costs it nothing, and all texels show the newest light. */
  WELKIN_VOLUME_DEVICE = 2
} WelkinVolumeFormat;

/* Zero-initialise it for the defaults. */
typedef struct WelkinVolumeSettings {
  WELKIN_STRUCT_SIZE(WelkinVolumeSettings);
  WelkinVolumeFormat format;
  uint32_t texels[3];               /* along x, y, z, each 2..512; 0: 96, 16, 96 */
  float texel_height_m;             /* >= 0.5; 0: 4. In x and z texels are the grid's cells of 4 m */
  const WelkinAllocator* allocator; /* null: malloc. Copied */
  uint32_t bricks; /* room for sides of walls and rooms, 27 texels each; 0: 4096; WELKIN_VOLUME_NO_BRICKS: none, light
                      leaks */
  uint32_t far_texels; /* edge of the far map: whole sectors of 16 texels of 4 m, 32..1024; 0: 256, 1024 m */
  float far_fade_m; /* height difference at which the far map's effect ends, 1..10000; it is whole up to half; 0: 16 */
} WelkinVolumeSettings;

#define WELKIN_VOLUME_NO_BRICKS UINT32_MAX

/* A box of texels that changed. It does not wrap. */
typedef struct WelkinVolumeBox {
  uint32_t first[3], size[3];
} WelkinVolumeBox;

#define WELKIN_VOLUME_MAX_BOXES 12

/* A rectangle of texels of the far map that changed, x then z. It does not wrap. */
typedef struct WelkinFarBox {
  uint32_t first[2], size[2];
} WelkinFarBox;

#define WELKIN_VOLUME_MAX_FAR_BOXES 8

/* Result of an update. */
typedef struct WelkinVolumeUpdate {
  WELKIN_STRUCT_SIZE(WelkinVolumeUpdate);
  uint32_t box_count; /* 0: no texel changed */
  WelkinVolumeBox box[WELKIN_VOLUME_MAX_BOXES];
  uint32_t filled;        /* texels in the boxes */
  uint32_t remaining;     /* texels that still show earlier light, those of bricks too */
  uint32_t cut_first;     /* first byte of welkin_volume_cuts that changed, a multiple of 16 */
  uint32_t cut_bytes;     /* bytes that changed from there on, a multiple of 16; at first all; 0: none */
  uint32_t cuts_left;     /* sectors with walls or rooms that found no place, the farthest: light leaks there */
  uint32_t bricks;        /* in use */
  uint32_t far_box_count; /* 0: no texel of the far map changed. They change where sectors come, go or enter the map */
  WelkinFarBox far_box[WELKIN_VOLUME_MAX_FAR_BOXES]; /* none overlap */
} WelkinVolumeUpdate;

struct WelkinVolumeConstants;

/* Makes a volume. Allocates; nothing later does. WELKIN_ERROR_MEMORY where it cannot. */
WELKIN_API WelkinResult welkin_volume_create(const WelkinVolumeSettings* settings, WelkinVolume** volume);

/* Frees it. Null is allowed. */
WELKIN_API void welkin_volume_destroy(WelkinVolume* volume);

/* Centres the volume on `camera`, metres, and fills the texels of cells that it enters, whatever their number. It also
 * fills again at most `max_texels` texels whose light or sectors changed, whole slices along z and at least one, the
 * longest waiting first. UINT32_MAX: all of them. Texels beyond the resident sectors get the open light of `sample`,
 * which welkin_level_set_light had. A change of the scale of RGBA8 fills everything. `level` is the same in each call,
 * and no other function of it runs meanwhile. */
WELKIN_API WelkinResult welkin_volume_update(WelkinVolume* volume, WelkinLevel* level, const WelkinSkySample* sample,
                                             const float camera[3], uint32_t max_texels, WelkinVolumeUpdate* update);

/* Size of each texture: the texels of the settings along x and y; along z those, a copy of the first slice after the
 * last, and the bricks. */
WELKIN_API WelkinResult welkin_volume_extent(const WelkinVolume* volume, uint32_t extent[3]);

/* The texels of channel 0, 1 or 2 (red, green, blue): x, then y, then z; 4 or 8 bytes each. They live as long as the
 * volume, and welkin_volume_update alone changes them. WELKIN_ERROR_ARGUMENT for WELKIN_VOLUME_DEVICE. */
WELKIN_API WelkinResult welkin_volume_texels(const WelkinVolume* volume, uint32_t channel, const void** texels,
                                             size_t* bytes);

/* The words that volume.glsl reads as a storage buffer: which brick each place has. They live as long as the volume,
 * and welkin_volume_update alone changes them, when sectors come or go and when the volume's box passes a sector's
 * border. */
WELKIN_API WelkinResult welkin_volume_cuts(const WelkinVolume* volume, const void** words, size_t* bytes);

/* The texels of the far map: x, then z, *edge of each. A texel is 4 bytes, two half floats
 * (VK_FORMAT_R16G16_SFLOAT): the occlusion of the sky in [0, 1], and the occlusion times the probe's height in metres,
 * within 0.1 %. 0, 0 where no sector is resident. They live as long as the volume, and welkin_volume_update alone
 * changes them. */
WELKIN_API WelkinResult welkin_volume_far_map(const WelkinVolume* volume, const void** texels, uint32_t* edge);

/* Fills the constants that volume.glsl and far.glsl read (welkin/volume_constants.h). `size` is that of the struct,
 * 112, or 80 for a game without far.glsl. */
WELKIN_API WelkinResult welkin_volume_constants(const WelkinVolume* volume, struct WelkinVolumeConstants* constants,
                                                size_t size);

/* Irradiance of a surface as the shader computes it from the volume, for tests and tools. `inside` becomes the share of
 * the volume in [0, 1]: 1 near the camera, falling over two texels to 0 at half the volume's width from it, less the
 * push and a texel and a half. The rest is the caller's light beyond. Both are filled; `inside` may be null.
 * WELKIN_ERROR_ARGUMENT for WELKIN_VOLUME_DEVICE. */
WELKIN_API WelkinResult welkin_volume_irradiance(const WelkinVolume* volume, const float position[3],
                                                 const float normal[3], float irradiance[3], float* inside);

/* Share of the open sky's irradiance that a surface beyond the volume gets, in [0, 1], as far.glsl computes it from the
 * far map. 1 where no sector is resident, from half the map's width less 35 m of the camera on along x or z, and at
 * heights that differ from the map's by far_fade_m or more. `position` is in metres, within 1e7. `normal` is a unit
 * vector, or null for a place in the air. WELKIN_ERROR_ARGUMENT for other positions and normals. */
WELKIN_API WelkinResult welkin_volume_far_visibility(const WelkinVolume* volume, const float position[3],
                                                     const float* normal, float* visibility);

#ifdef __cplusplus
}
#endif

#endif
