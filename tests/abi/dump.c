/* SPDX-License-Identifier: Apache-2.0
 * Calls the runtime as a C99 program and prints all that it writes. It is compiled against the header of a release and
 * against today's, and linked to today's library: both must print the same. Guard bytes stand around every struct.
 *   dump SKY.welkin      exit status 1 when a call fails or a guard byte changed */
#include <welkin/engines.h>
#include <welkin/sky_constants.h>

#include "guard.h"

static void light(const char* name, const WelkinLight* l) {
  printf("%s\n", name);
  floats("  direction", l->direction, 3);
  floats("  illuminance", &l->illuminance, 1);
  floats("  colour", l->colour, 3);
  floats("  normal_irradiance", l->normal_irradiance, 3);
  floats("  disc_radius_rad", &l->disc_radius_rad, 1);
  floats("  visible", &l->visible, 1);
}

static void sample(const WelkinSkySample* s) {
  printf("sample %u at %a, %u coefficients, %u modes, cubemaps %u %u\n", (unsigned)s->unchanged, s->time_h,
         (unsigned)s->coefficient_count, (unsigned)s->mode_count, (unsigned)s->cubemap[0], (unsigned)s->cubemap[1]);
  light("sun", &s->sun);
  light("moon", &s->moon);
  floats("intensity", &s->intensity, 1);
  floats("ambient_saturation", &s->ambient_saturation, 1);
  floats("polarising_tint", s->polarising_tint, 3);
  floats("ground_radiance", s->ground_radiance, 3);
  floats("luminance_norm", &s->luminance_norm, 1);
  floats("radiance_sh", s->radiance_sh[0], 3 * WELKIN_MAX_COEFFICIENTS);
  floats("ambient_sh", s->ambient_sh[0], 3 * WELKIN_MAX_COEFFICIENTS);
  floats("ambient_ground", s->ambient_ground, 3);
  floats("mode_weight", s->mode_weight[0], 3 * WELKIN_MAX_MODES);
  floats("mode_azimuth", s->mode_azimuth, 2);
  floats("cubemap_weight", &s->cubemap_weight, 1);
}

static void describe(const WelkinSky* sky) {
  GUARDED(WelkinSkyInfo) info;
  GUARDED(WelkinLuminance) luminance;
  GUARDED(WelkinGradients) gradients;
  GUARDED(WelkinCubemap) cubemap;
  GUARDED(WelkinStars) stars;
  GUARDED(WelkinModes) modes;
  GUARDED(WelkinCertificate) certificate;
  info.value.struct_size = sizeof info.value;
  CALL(info, welkin_sky_info(sky, &info.value));
  printf("info %u %u %u %u %u %u %u %u\n", (unsigned)info.value.bands, (unsigned)info.value.coefficient_count,
         (unsigned)info.value.key_count, (unsigned)info.value.mode_count, (unsigned)info.value.cubemap_count,
         (unsigned)info.value.cubemap_size, (unsigned)info.value.cubemap_format, (unsigned)info.value.has_moon);
  floats("luminance_unit", &info.value.luminance_unit, 1);
  floats("ground_albedo", info.value.ground_albedo, 3);
  luminance.value.struct_size = sizeof luminance.value;
  CALL(luminance, welkin_sky_luminance(sky, &luminance.value));
  floats("luminance", &luminance.value.a, 6);
  printf("normalise_to_sun %u\n", (unsigned)luminance.value.normalise_to_sun);
  gradients.value.struct_size = sizeof gradients.value;
  CALL(gradients, welkin_sky_gradients(sky, &gradients.value));
  printf("gradients %u %u %u %u\n", (unsigned)gradients.value.sun.width, (unsigned)gradients.value.sun.height,
         (unsigned)gradients.value.anti.width, (unsigned)gradients.value.anti.height);
  floats("delta", &gradients.value.delta, 1);
  floats("first texels", gradients.value.sun.rgb, 3);
  floats("and of the other", gradients.value.anti.rgb, 3);
  cubemap.value.struct_size = sizeof cubemap.value;
  CALL(cubemap, welkin_sky_cubemap(sky, 0, &cubemap.value));
  printf("cubemap %a %u %u %lu, first byte %u\n", cubemap.value.time_h, (unsigned)cubemap.value.size,
         (unsigned)cubemap.value.format, (unsigned long)cubemap.value.bytes,
         (unsigned)*(const unsigned char*)cubemap.value.texels);
  stars.value.struct_size = sizeof stars.value;
  CALL(stars, welkin_sky_stars(sky, &stars.value));
  printf("stars %u %u %a, first byte %u\n", (unsigned)stars.value.width, (unsigned)stars.value.height,
         stars.value.midnight_h, (unsigned)(stars.value.rgba8 != NULL ? *stars.value.rgba8 : 0));
  floats("stars", &stars.value.intensity, 1);
  floats("latitude_rad", &stars.value.latitude_rad, 1);
  floats("north_offset_rad", &stars.value.north_offset_rad, 1);
  modes.value.struct_size = sizeof modes.value;
  CALL(modes, welkin_sky_modes(sky, &modes.value));
  printf("modes %u %u %u, first texel %u\n", (unsigned)modes.value.count, (unsigned)modes.value.columns,
         (unsigned)modes.value.rows, (unsigned)(modes.value.texels != NULL ? *modes.value.texels : 0));
  certificate.value.struct_size = sizeof certificate.value;
  CALL(certificate, welkin_sky_certificate(sky, &certificate.value));
  printf("certificate %u %a %a %a %a %a %u %a %a %a %a %a %a %a %a %a %a %a\n", (unsigned)certificate.value.method,
         certificate.value.max_error, certificate.value.time_h, certificate.value.normal[0],
         certificate.value.normal[1], certificate.value.normal[2], (unsigned)certificate.value.channel,
         certificate.value.mean_error, certificate.value.quadrature, certificate.value.truncation,
         certificate.value.time, certificate.value.encoding, certificate.value.cubemap_error,
         certificate.value.cubemap_time_h, certificate.value.cubemap_resolution, certificate.value.cubemap_blend,
         certificate.value.cubemap_encoding, certificate.value.dome_error);
}

static void evaluate(const WelkinSky* sky) {
  const float direction[3] = {0.6F, 0.48F, -0.64F};
  GUARDED(WelkinSkySample) first;
  GUARDED(WelkinSkySample) second;
  GUARDED(WelkinSkySample) blended;
  GUARDED(WelkinLight) key;
  GUARDED(WelkinFilamentIrradianceOverPi) filament;
  GUARDED(WelkinUnityIrradianceOverPi) unity;
  GUARDED(WelkinSkyConstants) constants;
  struct {
    unsigned char before[GUARDS];
    float value[3];
    unsigned char after[GUARDS];
  } rgb;
  first.value.struct_size = second.value.struct_size = blended.value.struct_size = sizeof first.value;
  CALL(first, welkin_sky_sample(sky, 7.25, &first.value));
  sample(&first.value);
  CALL(first, welkin_sky_sample(sky, 7.25, &first.value));
  printf("unchanged %u\n", (unsigned)first.value.unchanged);
  CALL(second, welkin_sky_sample(sky, 18.5, &second.value));
  CALL(blended, welkin_sample_blend(&first.value, &second.value, 0.25F, &blended.value));
  sample(&blended.value);
  CALL(key, welkin_sample_key_light(&first.value, &key.value));
  light("key light", &key.value);
  CALL(filament, welkin_pack_filament(&first.value, &filament.value));
  floats("filament", filament.value.sh[0], 27);
  CALL(unity, welkin_pack_unity(&first.value, &unity.value));
  floats("unity", unity.value.shar, 28);
  CALL(constants, welkin_sky_constants(sky, &first.value, &constants.value, sizeof constants.value));
  floats("constants", &constants.value.sun.x, 52 * 4);
  CALL(constants, welkin_sample_ambient_constants(&blended.value, &constants.value, sizeof constants.value));
  floats("constants of the blend", &constants.value.sun.x, 52 * 4);
  CALL(rgb, welkin_sky_irradiance(sky, &first.value, direction, rgb.value));
  floats("irradiance", rgb.value, 3);
  CALL(rgb, welkin_sample_irradiance(&first.value, direction, rgb.value));
  floats("irradiance of the coefficients", rgb.value, 3);
  CALL(rgb, welkin_dome_radiance(sky, &first.value, direction, rgb.value));
  floats("dome", rgb.value, 3);
  CALL(rgb, welkin_disc_radiance(&first.value, first.value.sun.direction, 0.001F, rgb.value));
  floats("disc", rgb.value, 3);
  CALL(rgb, welkin_star_radiance(sky, &first.value, direction, rgb.value));
  floats("stars", rgb.value, 3);
}

/* What the game's functions were called with. */
static struct { unsigned allocations, frees, lines; } called;

static void* allocate(void* user, size_t bytes, size_t alignment) {
  if (user != &called || bytes == 0 || alignment == 0 || alignment > sizeof(void*) * 2) fail("allocate");
  ++called.allocations;
  return malloc(bytes);
}

static void release(void* user, void* address, size_t bytes) {
  if (user != &called || bytes == 0) fail("free");
  ++called.frees;
  free(address);
}

static void note(void* user, WelkinLogLevel level, const char* text) {
  if (user != &called) fail("write");
  printf("log %d of %lu characters\n", (int)level, (unsigned long)strlen(text));
  ++called.lines;
}

/* Opens a copy of a file in memory with the game's functions, and a part of it, which is refused. */
static void openMemory(const char* path) {
  static unsigned char bytes[1 << 20];
  static WelkinAllocator allocator;
  static WelkinLog log;
  static WelkinOpenInfo info;
  WelkinSky* sky = NULL;
  WelkinMessage message;
  FILE* stream = fopen(path, "rb");
  if (stream == NULL) fail(path);
  info.struct_size = sizeof info;
  info.data = bytes;
  info.size = fread(bytes, 1, sizeof bytes, stream);
  fclose(stream);
  info.flags = WELKIN_OPEN_COPY;
  info.allocator = &allocator;
  info.log = &log;
  allocator.struct_size = sizeof allocator;
  allocator.user = &called;
  allocator.allocate = allocate;
  allocator.free = release;
  log.struct_size = sizeof log;
  log.user = &called;
  log.write = note;
  if (welkin_sky_open(&info, &sky, &message) != WELKIN_OK) fail(message.text);
  memset(bytes, 0, 64);
  welkin_sky_close(sky);
  if (welkin_sky_open(&info, &sky, &message) == WELKIN_OK) fail("zeros open");
  if (called.allocations == 0 || called.allocations != called.frees || called.lines == 0) fail("the game's functions");
}

int main(int argc, char** argv) {
  WelkinOpenInfo info;
  WelkinSky* sky = NULL;
  WelkinMessage message;
  const char* settings = NULL;
  double hour = -1.0;
  if (argc != 2) return 1;
  memset(&info, 0, sizeof info);
  info.struct_size = sizeof info;
  info.path = argv[1];
  if (welkin_sky_open(&info, &sky, &message) != WELKIN_OK) {
    fprintf(stderr, "%s\n", message.text);
    return 1;
  }
  describe(sky);
  evaluate(sky);
  if (welkin_sky_settings(sky, &settings) != WELKIN_OK || welkin_sky_key_time(sky, 0, &hour) != WELKIN_OK) fail("text");
  printf("settings of %lu bytes, first key at %a h\n", (unsigned long)strlen(settings), hour);
  welkin_sky_close(sky);
  openMemory(argv[1]);
  return 0;
}
