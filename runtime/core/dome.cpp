// SPDX-License-Identifier: Apache-2.0
// The sky dome's radiance from the file's formulas and gradients, in double: the reference of the dome shader.
#include <algorithm>
#include <cmath>

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

}  // namespace
}  // namespace welkin::core

WelkinResult welkin_dome_radiance(const WelkinSky* sky, const WelkinSkySample* sample, const float direction[3],
                                  float radiance[3]) {
  using namespace welkin;
  using namespace welkin::core;
  if (sky == nullptr || sample == nullptr || direction == nullptr || radiance == nullptr) return WELKIN_ERROR_ARGUMENT;
  const Number3 d{double{direction[0]}, double{direction[1]}, double{direction[2]}};
  if (!(d.y >= 0.0)) {
    std::copy_n(sample->ground_radiance, 3, radiance);
    return WELKIN_OK;
  }
  WelkinGradients gradients;
  welkin_sky_gradients(sky, &gradients);
  const float* s = sample->sun.direction;
  const Number3 sun{double{s[0]}, double{s[1]}, double{s[2]}};
  const double elevation = f64::elevationOf(d);
  const Number3 colour = mix(sampleGradient(gradients.anti, sample->time_h, elevation),
                             sampleGradient(gradients.sun, sample->time_h, elevation), f64::azimuthWeight(d, sun));
  const double luminance =
      f64::relativeLuminance(luminanceModel(*sky->file->sky()->luminance()), d, sun, double{sample->luminance_norm}) *
      double{sample->intensity};
  const float* t = sample->polarising_tint;
  const Number3 tint{double{t[0]}, double{t[1]}, double{t[2]}};
  const Number3 value = f64::chromaticity(colour, double{gradients.delta}) * luminance * tint;
  for (int i = 0; i < 3; ++i) radiance[i] = toFloat(value[i]);
  return WELKIN_OK;
}
