// SPDX-License-Identifier: Apache-2.0
// The sky dome's radiance from the file's formulas and gradients, in double: the reference of the dome shader.
#include <algorithm>
#include <cmath>

#include "core/arguments.h"
#include "core/floats.h"
#include "core/sky.h"

namespace welkin::core {
namespace {

using f64::Number3;

Number3 texel(const WelkinGradient& image, std::uint32_t column, std::uint32_t row) {
  const float* p = image.rgb + 3 * (std::size_t{row} * image.width + column);
  return {double{p[0]}, double{p[1]}, double{p[2]}};
}

Number3 sampleGradient(const WelkinGradient& image, double time_h, double elevation_rad) {
  const double x = f64::gradientColumn(time_h, image.width);
  const double y = f64::gradientRow(elevation_rad, image.height);
  const double left = std::floor(x);
  const double low = std::floor(y);
  const auto column = [&](double i) {
    return static_cast<std::uint32_t>(i < 0.0 ? i + image.width : i >= image.width ? i - image.width : i);
  };
  const auto c0 = column(left);
  const auto c1 = column(left + 1.0);
  const auto r0 = static_cast<std::uint32_t>(low);
  const auto r1 = std::min(r0 + 1, image.height - 1);
  return mix(mix(texel(image, c0, r0), texel(image, c1, r0), x - left),
             mix(texel(image, c0, r1), texel(image, c1, r1), x - left), y - low);
}

/// Bilinear between texel centres, in linear light; columns wrap, rows clamp.
Number3 sampleStars(const WelkinStars& map, double u, double v) {
  const double x = u * map.width - 0.5;
  const double y = std::clamp(v * map.height - 0.5, 0.0, map.height - 1.0);
  const double left = std::floor(x);
  const auto low = static_cast<std::uint32_t>(y);
  const auto texelAt = [&](double column, std::uint32_t row) {
    const double wrapped = column < 0.0 ? column + map.width : column >= map.width ? column - map.width : column;
    const std::uint8_t* p = map.rgba8 + 4 * (std::size_t{row} * map.width + static_cast<std::uint32_t>(wrapped));
    return Number3(f64::srgbDecode(p[0] / 255.0), f64::srgbDecode(p[1] / 255.0), f64::srgbDecode(p[2] / 255.0));
  };
  const auto high = std::min(low + 1, map.height - 1);
  return mix(mix(texelAt(left, low), texelAt(left + 1.0, low), x - left),
             mix(texelAt(left, high), texelAt(left + 1.0, high), x - left), y - low);
}

}  // namespace
}  // namespace welkin::core

WelkinResult welkin_dome_radiance(const WelkinSky* sky, const WelkinSkySample* sample, const float direction[3],
                                  float radiance[3]) {
  using namespace welkin;
  using namespace welkin::core;
  if (const auto r = nonNull(__func__, {{"sky", sky}, {"radiance", radiance}})) return r;
  if (const auto r = checkSample(__func__, "sample", sample)) return r;
  if (const auto r = unit(__func__, "direction", direction)) return r;
  const Number3 d = load(direction);
  if (!(d.y >= 0.0)) {
    std::copy_n(sample->ground_radiance, 3, radiance);
    return WELKIN_OK;
  }
  WelkinGradients gradients;
  welkin_sky_gradients(sky, &gradients);
  const Number3 sun = load(sample->sun.direction);
  const double elevation = f64::elevationOf(d);
  const Number3 colour = mix(sampleGradient(gradients.anti, sample->time_h, elevation),
                             sampleGradient(gradients.sun, sample->time_h, elevation), f64::azimuthWeight(d, sun));
  const double luminance =
      f64::relativeLuminance(sky->luminance, d, sun, double{sample->luminance_norm}) * double{sample->intensity};
  const Number3 tint = load(sample->polarising_tint);
  const Number3 value = f64::chromaticity(colour, double{gradients.delta}) * luminance * tint;
  store(value, radiance);
  return WELKIN_OK;
}

WelkinResult welkin_disc_radiance(const WelkinSkySample* sample, const float direction[3], float pixel_rad,
                                  float radiance[3]) {
  using namespace welkin;
  using namespace welkin::core;
  if (const auto r = checkSample(__func__, "sample", sample)) return r;
  if (const auto r = unit(__func__, "direction", direction)) return r;
  if (const auto r = nonNull(__func__, {{"radiance", radiance}})) return r;
  if (!(pixel_rad >= 0.0F && std::isfinite(pixel_rad)))
    return refuse(__func__, "pixel_rad is %g, must be finite and at least 0", double{pixel_rad});
  const Number3 d = load(direction);
  const Number3 sun = load(sample->sun.direction);
  Number3 sum(0.0);
  for (const WelkinLight* light : {&sample->sun, &sample->moon}) {
    const double radius = double{light->disc_radius_rad};
    if (!(radius > 0.0) || d.y < 0.0) continue;
    const Number3 towards = load(light->direction);
    const double coverage = f64::discCoverage(f64::angleBetween(d, towards), radius, double{pixel_rad});
    const double phase = light == &sample->moon ? f64::moonPhase(d, towards, radius, sun) : 1.0;
    const double sine = std::sin(radius);
    if (coverage > 0.0) sum += load(light->normal_irradiance) * (coverage * phase / (f64::kPi * sine * sine));
  }
  store(sum, radiance);
  return WELKIN_OK;
}

WelkinResult welkin_star_radiance(const WelkinSky* sky, const WelkinSkySample* sample, const float direction[3],
                                  float radiance[3]) {
  using namespace welkin;
  using namespace welkin::core;
  if (const auto r = nonNull(__func__, {{"radiance", radiance}})) return r;
  float dome[3];
  if (const auto r = welkin_dome_radiance(sky, sample, direction, dome)) return r;
  WelkinStars map;
  welkin_sky_stars(sky, &map);
  std::fill_n(radiance, 3, 0.0F);
  if (map.width == 0 || !(map.intensity > 0.0F) || !(direction[1] >= 0.0F)) return WELKIN_OK;
  const Number3 at = f64::starCoordinates(load(direction), double{map.latitude_rad}, double{map.north_offset_rad},
                                          f64::kTwoPi * (sample->time_h - map.midnight_h) / 24.0);
  const double luminance = f64::luminanceOf(load(dome));
  const Number3 value =
      sampleStars(map, at.x, at.y) * (double{map.intensity} * f64::starFade(luminance, double{map.intensity}));
  store(value, radiance);
  return WELKIN_OK;
}
