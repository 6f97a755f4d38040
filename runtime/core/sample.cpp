// SPDX-License-Identifier: Apache-2.0
// The sky at an instant. Lights, intensity, tint and saturation are evaluated from their own keys, exactly as the bake
// did; only the shape of the sky's radiance is interpolated between the table's keys.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "core/arguments.h"
#include "core/floats.h"
#include "core/sky.h"
#include "format/key_segment.h"

namespace welkin::core {
namespace {

using f64::Number3;

/// f64::desaturate of a colour whose luminance is already known.
void desaturate(const Channels& v, double saturation, double out[3]) {
  for (std::size_t c = 0; c < 3; ++c) out[c] = v[3] + (v[c] - v[3]) * saturation;
}

Number3 onGround(const Light::Instant& light) {
  return f64::levelIrradiance(light.normal_irradiance, light.direction);
}

void blendTable(const WelkinSky& opened, double time_h, double intensity, const Light::Instant& sun,
                const Number3& of_lights, WelkinSkySample& out) {
  const double saturation = double{out.ambient_saturation};
  Day::Shape shape;
  opened.day.shapeAt(time_h, shape);
  const Azimuth azimuth(sun.direction);
  std::array<Channels, WELKIN_MAX_COEFFICIENTS> world;
  opened.frame.toWorld(opened.day.bands(), shape.polar, azimuth, world);

  const Number3 radiance = f64::groundRadiance(opened.albedo, intensity * shape.horizontal_irradiance + of_lights);
  const Channels ground = {radiance.x, radiance.y, radiance.z, f64::luminanceOf(radiance)};
  double ambient[3 * WELKIN_MAX_COEFFICIENTS];
  desaturate(ground, saturation, ambient);
  store(ground.data(), 3, out.ground_radiance);
  store(ambient, 3, out.ambient_ground);

  const std::size_t count = opened.day.bands() * opened.day.bands();
  double flat[3 * WELKIN_MAX_COEFFICIENTS];
  for (std::size_t i = 0; i < count; ++i) {
    Channels v;
    for (std::size_t c = 0; c < 4; ++c) v[c] = intensity * world[i][c] + ground[c] * opened.ground_sh[i];
    std::copy_n(v.data(), 3, flat + 3 * i);
    desaturate(v, saturation, ambient + 3 * i);
  }
  store(flat, 3 * count, out.radiance_sh[0]);
  store(ambient, 3 * count, out.ambient_sh[0]);
  out.coefficient_count = static_cast<std::uint32_t>(count);

  const std::size_t modes = opened.day.modes().count();
  for (std::size_t k = 0; k < modes; ++k) {
    Channels v;
    for (std::size_t c = 0; c < 4; ++c) v[c] = intensity * shape.weight[k][c];
    desaturate(v, saturation, ambient + 3 * k);
  }
  store(ambient, 3 * modes, out.mode_weight[0]);
  out.mode_count = static_cast<std::uint32_t>(modes);
  out.mode_family = opened.day.family();
  out.mode_azimuth[0] = toFloat(azimuth.sine * azimuth.share);
  out.mode_azimuth[1] = toFloat(azimuth.cosine * azimuth.share);
}

/// The cubemaps before and after the hour. The weight of the second is below 1 as a float, too.
void chooseCubemaps(const WelkinSky& opened, double time_h, WelkinSkySample& out) {
  if (opened.cubemap_count == 0) return;
  const auto s = format::findSegment({opened.cubemap_time_h.get(), opened.cubemap_count}, time_h);
  out.cubemap[0] = static_cast<std::uint32_t>(s.first);
  out.cubemap[1] = static_cast<std::uint32_t>(s.second);
  out.cubemap_weight = std::min(toFloat(s.weight), std::nextafter(1.0F, 0.0F));
}

/// Sets every byte of `out`, which has the size of this library's struct; `unchanged` becomes 0.
void sampleAt(const WelkinSky& sky, double time_h, WelkinSkySample& out) {
  std::memset(static_cast<void*>(&out), 0, sizeof out);
  out.struct_size = sizeof out;
  out.time_h = time_h;
  const double intensity = sky.intensity.at(time_h);
  out.intensity = toFloat(intensity);
  out.ambient_saturation = toFloat(sky.ambient_saturation.at(time_h));
  store(sky.polarising_tint.colourAt(time_h), out.polarising_tint);

  const Light::Instant sun = sky.sun.at(time_h, out.sun);
  Number3 of_lights = onGround(sun);
  if (sky.moon) of_lights += onGround(sky.moon->at(time_h, out.moon));
  const double norm = f64::luminanceNormFrom(sky.luminance, sun.direction, sky.normalise_to_sun, sky.constant_norm);
  out.luminance_norm = toFloat(std::max(kLeastDivisor, norm));  // checkContent checks whole minutes only
  blendTable(sky, time_h, intensity, sun, of_lights, out);
  chooseCubemaps(sky, time_h, out);
}

}  // namespace
}  // namespace welkin::core

WelkinResult welkin_sky_sample(const WelkinSky* sky, double time_h, WelkinSkySample* sample) {
  using namespace welkin;
  using namespace welkin::core;
  if (const auto r = nonNull(__func__, {{"sky", sky}})) return r;
  if (const auto r = sized(__func__, "sample", sample)) return r;
  if (!std::isfinite(time_h)) return refuse(__func__, "time_h is %g, must be finite", time_h);
  const double wrapped_h = format::wrapTime(time_h);
  const std::size_t size = sample->struct_size;
  // A sample of another hour differs anyway: compare only if the hour is the same.
  if (size == sizeof *sample && std::memcmp(&wrapped_h, &sample->time_h, sizeof wrapped_h) != 0) {
    sampleAt(*sky, wrapped_h, *sample);
    return WELKIN_OK;
  }
  WelkinSkySample out;
  sampleAt(*sky, wrapped_h, out);
  out.struct_size = sample->struct_size;
  out.unchanged = sample->unchanged;
  const bool unchanged = std::memcmp(&out, sample, size) == 0;
  if (!unchanged) std::memcpy(static_cast<void*>(sample), &out, size);
  sample->unchanged = unchanged ? 1 : 0;
  return WELKIN_OK;
}
