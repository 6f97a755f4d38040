// SPDX-License-Identifier: Apache-2.0
// Fuzz target: the bytes of a .welkin file. The runtime reads nothing outside them while it opens the file. An opened
// file answers every call of the runtime's interface with finite numbers.
#include <welkin/engines.h>

#include <algorithm>
#include <cstring>
#include <memory>

#include "format/container.h"
#include "fuzz.h"

namespace welkin::fuzz {
namespace {

constexpr float kDirections[][3] = {{0.0F, 1.0F, 0.0F},  {1.0F, 0.0F, 0.0F},    {0.0F, 0.0F, -1.0F},
                                    {0.0F, -1.0F, 0.0F}, {0.6F, 1e-30F, -0.8F}, {-0.48F, 0.6F, 0.64F}};
constexpr std::uint32_t kMostKeys = 16;  // tried of each kind by one input

void requireOk(WelkinResult result, const char* call) {
  require(result == WELKIN_OK, std::string(call) + " succeeds: " + welkin_result_string(result));
}

void requireFinite(const float* values, std::size_t count, const char* what) {
  require(std::all_of(values, values + count, [](float v) { return std::isfinite(v); }),
          std::string(what) + " is finite");
}

void checkLight(const WelkinLight& light) {
  requireFinite(light.direction, 3, "a light's direction");
  requireFinite(light.colour, 3, "a light's colour");
  requireFinite(light.normal_irradiance, 3, "a light's irradiance");
  require(light.illuminance >= 0.0F && std::isfinite(light.illuminance), "a light's illuminance is not negative");
  require(light.visible >= 0.0F && light.visible <= 1.0F, "a light's visible share is 0 to 1");
  require(light.disc_radius_rad >= 0.0F && light.disc_radius_rad < 1.6F, "a disc's radius is at most a quarter turn");
}

/// Checks the memory that the file of `size` bytes lends: every byte is there, and no more cubemaps than fit.
void checkBorrowed(const WelkinSky* sky, const WelkinSkyInfo& info, std::size_t size) {
  std::size_t sum = 0;
  const auto touch = [&](const void* first, std::size_t bytes) {
    const auto* p = static_cast<const unsigned char*>(first);
    for (std::size_t i = 0; i < bytes; ++i) sum += p[i];
  };
  WelkinLuminance luminance;
  requireOk(welkin_sky_luminance(sky, &luminance), "luminance");
  requireFinite(&luminance.a, 6, "the luminance");
  WelkinGradients gradients;
  requireOk(welkin_sky_gradients(sky, &gradients), "gradients");
  require(gradients.delta > 0.0F && std::isfinite(gradients.delta), "the gradients' delta is positive");
  for (const auto& g : {gradients.sun, gradients.anti}) {
    const std::size_t numbers = std::size_t{3} * g.width * g.height;
    require(numbers > 0, "a gradient has texels");
    requireFinite(g.rgb, numbers, "a gradient");
  }
  const std::size_t texel = info.cubemap_format == WELKIN_CUBEMAP_RGBA16F ? 8 : 4;
  require(6 * texel * info.cubemap_size * info.cubemap_size * info.cubemap_count <= size,
          "every cubemap has texels of its own");
  for (std::uint32_t i = 0; i < info.cubemap_count; ++i) {
    WelkinCubemap cubemap;
    requireOk(welkin_sky_cubemap(sky, i, &cubemap), "cubemap");
    require(cubemap.size == info.cubemap_size && cubemap.format == info.cubemap_format &&
                cubemap.bytes == 6 * texel * cubemap.size * cubemap.size,
            "a cubemap has six faces");
    touch(cubemap.texels, cubemap.bytes);
  }
  WelkinStars stars;
  requireOk(welkin_sky_stars(sky, &stars), "stars");
  touch(stars.rgba8, std::size_t{4} * stars.width * stars.height);
  WelkinModes modes;
  requireOk(welkin_sky_modes(sky, &modes), "modes");
  require(modes.count == info.mode_count && modes.count <= WELKIN_MAX_MODES, "the modes are as many as info says");
  require(modes.count == 0 || (modes.columns > 0 && modes.rows > 0), "the map of the modes has texels");
  touch(modes.texels, sizeof(std::uint16_t) * modes.count * modes.columns * modes.rows);
  const char* settings = nullptr;
  requireOk(welkin_sky_settings(sky, &settings), "settings");
  touch(settings, std::strlen(settings));
  [[maybe_unused]] const volatile std::size_t kept = sum;
}

void checkCertificate(const WelkinSky* sky) {
  WelkinCertificate c;
  requireOk(welkin_sky_certificate(sky, &c), "certificate");
  require(c.method <= WELKIN_CERTIFICATE_FULL && c.channel < 3, "a certificate has a method and a channel");
  require(c.time_h >= 0.0 && c.time_h < 24.0 && c.cubemap_time_h >= 0.0 && c.cubemap_time_h < 24.0,
          "a certificate's times are in the day");
  for (const double error : {c.max_error, c.mean_error, c.quadrature, c.truncation, c.time, c.encoding, c.cubemap_error,
                             c.cubemap_resolution, c.cubemap_blend, c.cubemap_encoding, c.dome_error})
    require(error >= 0.0 && std::isfinite(error), "a certified error is not negative");
  for (const double component : c.normal) require(std::abs(component) <= 1.0, "a certificate's normal is one");
}

void checkSample(const WelkinSky* sky, const WelkinSkyInfo& info, const WelkinSkySample& s) {
  require(s.time_h >= 0.0 && s.time_h < 24.0, "a sample's time is in the day");
  require(s.coefficient_count == info.coefficient_count, "a sample has every coefficient");
  checkLight(s.sun);
  checkLight(s.moon);
  requireFinite(&s.radiance_sh[0][0], 3 * WELKIN_MAX_COEFFICIENTS, "the radiance");
  requireFinite(&s.ambient_sh[0][0], 3 * WELKIN_MAX_COEFFICIENTS, "the ambient light");
  requireFinite(s.polarising_tint, 3, "the tint");
  requireFinite(s.ground_radiance, 3, "the ground");
  requireFinite(s.ambient_ground, 3, "the ground of the ambient light");
  require(s.mode_count == info.mode_count, "a sample has every mode");
  requireFinite(&s.mode_weight[0][0], 3 * WELKIN_MAX_MODES, "the modes' weights");
  require(std::hypot(s.mode_azimuth[0], s.mode_azimuth[1]) < 1.0F + 1e-5F, "the modes' azimuth is at most a unit");
  require(std::isfinite(s.luminance_norm) && s.luminance_norm > 0.0F, "the normalising luminance is positive");
  require(std::isfinite(s.intensity) && s.intensity >= 0.0F, "the intensity is not negative");
  require(s.ambient_saturation >= 0.0F && s.ambient_saturation <= 1.0F, "the saturation is 0 to 1");
  require(info.cubemap_count == 0 || std::max(s.cubemap[0], s.cubemap[1]) < info.cubemap_count, "cubemaps exist");
  require(s.cubemap_weight >= 0.0F && s.cubemap_weight < 1.0F, "the cubemaps' weight is in [0, 1)");
  for (const auto& direction : kDirections) {
    float rgb[3];
    requireOk(welkin_sample_irradiance(&s, direction, rgb), "irradiance");
    requireFinite(rgb, 3, "the irradiance");
    requireOk(welkin_sky_irradiance(sky, &s, direction, rgb), "sky_irradiance");
    requireFinite(rgb, 3, "the best irradiance");
    require(*std::min_element(rgb, rgb + 3) >= 0.0F, "the best irradiance is not negative");
    requireOk(welkin_dome_radiance(sky, &s, direction, rgb), "dome_radiance");
    requireFinite(rgb, 3, "the dome");
    requireOk(welkin_disc_radiance(&s, direction, 0.001F, rgb), "disc_radiance");
    requireFinite(rgb, 3, "the discs");
    requireOk(welkin_disc_radiance(&s, s.sun.direction, 0.0F, rgb), "disc_radiance");
    requireFinite(rgb, 3, "the sun's disc");
    requireOk(welkin_star_radiance(sky, &s, direction, rgb), "star_radiance");
    requireFinite(rgb, 3, "the stars");
  }
  WelkinFilamentIrradianceOverPi filament;
  requireOk(welkin_pack_filament(&s, &filament), "pack_filament");
  requireFinite(&filament.sh[0][0], 27, "Filament's packing");
  WelkinUnityIrradianceOverPi unity;
  requireOk(welkin_pack_unity(&s, &unity), "pack_unity");
  requireFinite(unity.shar, 28, "Unity's packing");
  WelkinRadianceSh radiance;
  requireOk(welkin_pack_radiance(&s, WELKIN_AXES_UNREAL, &radiance), "pack_radiance");
  requireFinite(&radiance.sh[0][0], 27, "radiance in Unreal's axes");
  WelkinFilamentRadiance filament_radiance;
  requireOk(welkin_pack_filament_radiance(&s, &filament_radiance), "pack_filament_radiance");
  requireFinite(&filament_radiance.sh[0][0], 27, "Filament's radiance");
  WelkinUnityProbe probe;
  requireOk(welkin_pack_unity_probe(&s, WELKIN_AXES_UNITY, &probe), "pack_unity_probe");
  requireFinite(&probe.sh[0][0], 27, "Unity's probe");
  WelkinUnrealIrradianceOverPi unreal;
  requireOk(welkin_pack_unreal(&s, &unreal), "pack_unreal");
  requireFinite(&unreal.vectors[0][0], 28, "Unreal's packing");
  WelkinGodotIrradianceOverPi godot;
  requireOk(welkin_pack_godot(&s, &godot), "pack_godot");
  requireFinite(&godot.vectors[0][0], 64, "Godot's packing");
  WelkinLight key;
  requireOk(welkin_sample_key_light(&s, &key), "key_light");
  checkLight(key);
}

void use(const WelkinSky* sky, std::size_t size) {
  WelkinSkyInfo info;
  requireOk(welkin_sky_info(sky, &info), "info");
  require(info.bands >= 2 && info.bands <= WELKIN_MAX_BANDS && info.key_count >= 1, "there are bands and keys");
  requireFinite(&info.luminance_unit, 1, "the luminance unit");
  requireFinite(info.ground_albedo, 3, "the albedo");
  checkBorrowed(sky, info, size);
  checkCertificate(sky);
  WelkinCubemap none;
  require(welkin_sky_cubemap(sky, info.cubemap_count, &none) == WELKIN_ERROR_ARGUMENT, "no cubemap after the last");

  WelkinSkySample before{};
  requireOk(welkin_sky_sample(sky, 0.0, &before), "sample");
  const auto sampleAt = [&](double time_h) {
    WelkinSkySample sample{};
    WelkinSkySample blended{};
    requireOk(welkin_sky_sample(sky, time_h, &sample), "sample");
    checkSample(sky, info, sample);
    requireOk(welkin_sample_blend(&before, &sample, 0.5F, &blended), "blend");
    checkLight(blended.sun);
    checkLight(blended.moon);
    requireFinite(&blended.ambient_sh[0][0], 3 * WELKIN_MAX_COEFFICIENTS, "the blended light");
    float rgb[3];
    requireOk(welkin_sky_irradiance(sky, &blended, kDirections[0], rgb), "sky_irradiance");
    requireFinite(rgb, 3, "the blended irradiance");
    before = sample;
  };
  for (const double time_h : {0.0, 3.217, 6.0, 12.0, 18.0083, 23.9999, -0.5, 1e300}) sampleAt(time_h);
  for (std::uint32_t i = 0; i < std::min(info.key_count, kMostKeys); ++i) {
    double time_h = -1.0;
    requireOk(welkin_sky_key_time(sky, i, &time_h), "key_time");
    sampleAt(time_h);
  }
  for (std::uint32_t i = 0; i < std::min(info.cubemap_count, kMostKeys); ++i) {
    WelkinCubemap cubemap;
    requireOk(welkin_sky_cubemap(sky, i, &cubemap), "cubemap");
    sampleAt(cubemap.time_h);
  }
}

struct Free {
  void operator()(void* p) const { std::free(p); }
};

}  // namespace
}  // namespace welkin::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace welkin;
  // Of the exact size, so that a read past the end is caught.
  void* copy = nullptr;
  fuzz::require(::posix_memalign(&copy, format::kAlignment, size) == 0, "memory for the input");
  const std::unique_ptr<void, fuzz::Free> owner(copy);
  if (size > 0) std::memcpy(copy, bytes, size);
  WelkinSky* sky = nullptr;
  WelkinMessage message{};
  const WelkinResult result = welkin_sky_open_memory(copy, size, &sky, &message);
  fuzz::require((result == WELKIN_OK) == (sky != nullptr), "a sky is there exactly when it opened");
  fuzz::require(result == WELKIN_OK || message.text[0] != '\0', "a failure has a message");
  if (sky != nullptr) fuzz::use(sky, size);
  welkin_sky_close(sky);
  return 0;
}
