/* SPDX-License-Identifier: Apache-2.0
 * Lights a baked level as a C99 program and prints all that the library writes. It is compiled against the headers of a
 * release and against today's, as dump.c. Guard bytes stand around every struct.
 *   dump_level SKY.welkin LEVEL.welkin SECTOR.welkin      exit status 1 when a call fails or a guard byte changed */
#include <welkin/volume.h>
#include <welkin/volume_constants.h>

#include "guard.h"

static unsigned char file[1 << 20];

/* Reads a file to an address that is a multiple of 16. */
static void* aligned(const char* path, size_t* size) {
  unsigned char* first = file + (16 - (size_t)file % 16) % 16;
  FILE* stream = fopen(path, "rb");
  if (stream == NULL) fail(path);
  *size = fread(first, 1, sizeof file - 16, stream);
  fclose(stream);
  return first;
}

static void describe(const WelkinLevel* level) {
  GUARDED(WelkinLevelInfo) info;
  GUARDED(WelkinSectorEntry) entry;
  info.value.struct_size = sizeof info.value;
  CALL(info, welkin_level_info(level, &info.value));
  printf("level %u %u %u %u %u %lu %u\n", (unsigned)info.value.sector_count, (unsigned)info.value.probe_count,
         (unsigned)info.value.sector_capacity, (unsigned)info.value.resident_sectors,
         (unsigned)info.value.resident_probes, (unsigned long)info.value.resident_bytes,
         (unsigned)info.value.sun_transfer);
  floats("sky_scale", &info.value.sky_scale, 1);
  floats("sun_bounce_scale", &info.value.sun_bounce_scale, 1);
  CALL(entry, welkin_level_entry(level, 0, &entry.value));
  printf("sector %d %d, %u probes, %lu bytes\n", (int)entry.value.x, (int)entry.value.z, (unsigned)entry.value.probes,
         (unsigned long)entry.value.bytes);
}

static void relight(WelkinLevel* level, const WelkinSkySample* sample) {
  static WelkinLevelLight light;
  GUARDED(WelkinRelight) result;
  GUARDED(uint32_t) count;
  light.struct_size = sizeof light;
  light.sample = sample;
  light.sky = 1.0F;
  light.sun_bounce = 0.5F;
  light.local = 1.0F;
  if (welkin_level_set_light(level, &light) != WELKIN_OK) fail("set_light");
  result.value.struct_size = sizeof result.value;
  CALL(result, welkin_level_relight(level, 3, &result.value));
  printf("relit %u, remaining %u\n", (unsigned)result.value.relit, (unsigned)result.value.remaining);
  CALL(count, welkin_level_relight_begin(level, UINT32_MAX, &count.value));
  if (welkin_level_relight_range(level, 0, count.value) != WELKIN_OK) fail("relight_range");
  CALL(result, welkin_level_relight_end(level, &result.value));
  printf("relit %u, remaining %u\n", (unsigned)result.value.relit, (unsigned)result.value.remaining);
}

/* All lights but the one of `user` see everything. */
static int sees(void* user, const float from[3], const float to[3]) {
  (void)from;
  return to[0] != ((const WelkinPointLight*)user)->position[0];
}

/* A lamp, a spot and a lamp that nothing sees. */
static void lamps(WelkinLevel* level) {
  static WelkinPointLight light[3];
  GUARDED(WelkinLightsResult) result;
  int i;
  for (i = 0; i < 3; ++i) {
    light[i].position[0] = 20.0F + 3.0F * (float)i;
    light[i].position[1] = 2.5F;
    light[i].position[2] = 30.0F;
    light[i].intensity[0] = 50.0F;
    light[i].intensity[1] = 20.0F * (float)i;
    light[i].intensity[2] = 10.0F;
  }
  light[1].direction[1] = -1.0F;
  light[1].inner_rad = 0.3F;
  light[1].outer_rad = 0.8F;
  light[1].revision = 7;
  result.value.struct_size = sizeof result.value;
  CALL(result, welkin_level_set_lights(level, 3, light, sees, &light[2], &result.value));
  printf("lamps: %u unseen, %u shared, %u sectors, %u probes\n", (unsigned)result.value.unseen,
         (unsigned)result.value.shared, (unsigned)result.value.sectors, (unsigned)result.value.probes);
  if (result.value.probes == 0) fail("the lamps light no probe");
}

static void lookUp(const WelkinLevel* level) {
  static const float position[2][3] = {{20.5F, 1.0F, 30.25F}, {45.0F, 7.5F, 9.0F}};
  static const float normal[2][3] = {{0.0F, 1.0F, 0.0F}, {0.6F, 0.0F, -0.8F}};
  struct {
    unsigned char before[GUARDS];
    float value[2][3];
    unsigned char after[GUARDS];
  } rgb;
  struct {
    unsigned char before[GUARDS];
    WelkinColours value[2];
    unsigned char after[GUARDS];
  } colours;
  struct {
    unsigned char before[GUARDS];
    uint8_t value[2];
    unsigned char after[GUARDS];
  } served;
  struct {
    unsigned char before[GUARDS];
    float value[4][3];
    unsigned char after[GUARDS];
  } sh;
  CALL(rgb, welkin_level_irradiance(level, 2, position, normal, rgb.value, NULL));
  CALL(served, welkin_level_irradiance(level, 2, position, normal, rgb.value, served.value));
  printf("served %u %u\n", (unsigned)served.value[0], (unsigned)served.value[1]);
  floats("irradiance", rgb.value[0], 6);
  CALL(colours, welkin_level_colours(level, 2, position, colours.value, NULL));
  floats("colours", colours.value[0].irradiance[0], 24);
  CALL(rgb, welkin_colours_irradiance(&colours.value[0], normal[1], rgb.value[0]));
  floats("of the colours", rgb.value[0], 3);
  CALL(sh, welkin_colours_sh(&colours.value[0], sh.value));
  floats("sh", sh.value[0], 12);
}

static void fill(WelkinLevel* level, const WelkinSkySample* sample, WelkinVolumeFormat format) {
  static const float camera[3] = {30.0F, 4.0F, 20.0F}, up[3] = {0.0F, 1.0F, 0.0F};
  static WelkinVolumeSettings settings;
  WelkinVolume* volume = NULL;
  GUARDED(WelkinVolumeUpdate) update;
  GUARDED(WelkinVolumeConstants) constants;
  struct {
    unsigned char before[GUARDS];
    float value[3];
    unsigned char after[GUARDS];
  } rgb;
  const void* texels = NULL;
  size_t bytes = 0, i;
  unsigned sum = 0;
  struct {
    unsigned char before[GUARDS];
    uint32_t value[3];
    unsigned char after[GUARDS];
  } extent;
  float inside = -1.0F;
  settings.struct_size = sizeof settings;
  settings.format = format;
  settings.texels[0] = settings.texels[2] = 16;
  settings.texels[1] = 8;
  if (welkin_volume_create(&settings, &volume) != WELKIN_OK) fail("volume_create");
  update.value.struct_size = sizeof update.value;
  CALL(update, welkin_volume_update(volume, level, sample, camera, UINT32_MAX, &update.value));
  printf("volume of %u boxes, first %u %u %u, %u texels, %u left\n", (unsigned)update.value.box_count,
         (unsigned)update.value.box[0].size[0], (unsigned)update.value.box[0].size[1],
         (unsigned)update.value.box[0].size[2], (unsigned)update.value.filled, (unsigned)update.value.remaining);
  CALL(constants, welkin_volume_constants(volume, &constants.value, sizeof constants.value));
  floats("volume constants", &constants.value.low.x, 20); /* those of the first release */
  CALL(rgb, welkin_volume_irradiance(volume, camera, up, rgb.value, &inside));
  floats("volume irradiance", rgb.value, 3);
  floats("inside", &inside, 1);
  CALL(extent, welkin_volume_extent(volume, extent.value));
  if (welkin_volume_cuts(volume, &texels, &bytes) != WELKIN_OK) fail("volume_cuts");
  printf("extent %u %u %u, cuts of %lu bytes\n", (unsigned)extent.value[0], (unsigned)extent.value[1],
         (unsigned)extent.value[2], (unsigned long)bytes);
  if (welkin_volume_texels(volume, 1, &texels, &bytes) != WELKIN_OK) fail("volume_texels");
  for (i = 0; i < bytes; ++i) sum = 31 * sum + ((const unsigned char*)texels)[i];
  printf("texels of %lu bytes, hash %u\n", (unsigned long)bytes, sum);
  welkin_volume_destroy(volume);
}

int main(int argc, char** argv) {
  static const float place[3] = {0.0F, 0.0F, 0.0F};
  static WelkinOpenInfo info;
  static WelkinLevelLimits limits;
  static WelkinSkySample sample;
  WelkinSky* sky = NULL;
  WelkinLevel* level = NULL;
  WelkinSector* sector = NULL;
  WelkinMessage message;
  int32_t x = 9, z = 9;
  size_t size = 0;
  void* bytes;
  if (argc != 4) return 1;
  info.struct_size = sizeof info;
  info.path = argv[1];
  if (welkin_sky_open(&info, &sky, NULL) != WELKIN_OK) fail("sky_open");
  info.path = argv[2];
  limits.struct_size = sizeof limits;
  limits.sector_capacity = 3;
  if (welkin_level_open(&info, sky, &limits, &level, &message) != WELKIN_OK) fail(message.text);
  bytes = aligned(argv[3], &size);
  if (welkin_sector_open(level, bytes, size, &sector, &message) != WELKIN_OK) fail(message.text);
  if (welkin_level_add(level, sector) != WELKIN_OK) fail("level_add");
  describe(level);
  sample.struct_size = sizeof sample;
  if (welkin_sky_sample(sky, 9.5, &sample) != WELKIN_OK) fail("sky_sample");
  relight(level, &sample);
  lookUp(level);
  lamps(level);
  relight(level, &sample);
  lookUp(level);
  fill(level, &sample, WELKIN_VOLUME_RGBA16F);
  fill(level, &sample, WELKIN_VOLUME_RGBA8);
  if (welkin_level_farthest(level, place, &x, &z) != WELKIN_OK) fail("level_farthest");
  printf("farthest %d %d\n", (int)x, (int)z);
  if (welkin_level_remove(level, x, z, &sector) != WELKIN_OK || sector == NULL) fail("level_remove");
  welkin_sector_close(sector);
  welkin_level_close(level);
  welkin_sky_close(sky);
  return 0;
}
