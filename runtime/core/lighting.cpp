// SPDX-License-Identifier: Apache-2.0
// Functions of samples for renderers: irradiance, cross-blends, the key light. All functions are pure.
#include <algorithm>
#include <cmath>

#include "core/arguments.h"
#include "core/floats.h"
#include "core/sky.h"

namespace welkin::core {
namespace {

using f64::Number3;

float lerp(float a, float b, float weight) {
  return toFloat((1.0 - double{weight}) * double{a} + double{weight} * double{b});
}

void lerp3(const float a[3], const float b[3], float weight, float out[3]) {
  for (int i = 0; i < 3; ++i) out[i] = lerp(a[i], b[i], weight);
}

WelkinLight blendLights(const WelkinLight& a, const WelkinLight& b, float weight) {
  WelkinLight light = a;
  const Number3 between = mix(load(a.direction), load(b.direction), double{weight});
  const double length = std::sqrt(dot(between, between));
  if (length > 1e-6) store(between / length, light.direction);  // opposite directions have no middle: keep the first
  light.illuminance = lerp(a.illuminance, b.illuminance, weight);
  lerp3(a.colour, b.colour, weight, light.colour);
  lerp3(a.normal_irradiance, b.normal_irradiance, weight, light.normal_irradiance);
  light.disc_radius_rad = lerp(a.disc_radius_rad, b.disc_radius_rad, weight);
  light.visible = lerp(a.visible, b.visible, weight);
  return light;
}

/// Whether the weights of both samples are of the same functions of the normal: the same modes about the same azimuth.
bool shareModes(const WelkinSkySample& a, const WelkinSkySample& b) {
  return a.mode_count > 0 && a.mode_count == b.mode_count && familyOf(a) != 0 && familyOf(a) == familyOf(b) &&
         std::equal(a.mode_azimuth, a.mode_azimuth + 2, b.mode_azimuth);
}

/// Luminance of the light's irradiance on a surface that faces it, with the visible share.
double facing(const WelkinLight& light) {
  return f64::luminanceOf(load(light.normal_irradiance)) * double{light.visible};
}

}  // namespace
}  // namespace welkin::core

WelkinResult welkin_sample_irradiance(const WelkinSkySample* sample, const float normal[3], float irradiance[3]) {
  using namespace welkin;
  using namespace welkin::core;
  if (const auto r = checkSample(__func__, "sample", sample)) return r;
  if (const auto r = unit(__func__, "normal", normal)) return r;
  if (const auto r = nonNull(__func__, {{"irradiance", irradiance}})) return r;
  const f64::ShBasis basis = f64::shBasis(load(normal));
  Number3 sum(0.0);
  for (std::uint32_t i = 0; i < sample->coefficient_count; ++i)
    sum += load(sample->ambient_sh[i]) * (f64::cosineLobe(bandOf(i)) * basis.v[i]);
  for (int i = 0; i < 3; ++i) irradiance[i] = toFloat(std::max(sum[i], 0.0));
  return WELKIN_OK;
}

WelkinResult welkin_sky_irradiance(const WelkinSky* sky, const WelkinSkySample* sample, const float normal[3],
                                   float irradiance[3]) {
  using namespace welkin;
  using namespace welkin::core;
  if (const auto r = nonNull(__func__, {{"sky", sky}, {"irradiance", irradiance}})) return r;
  if (const auto r = checkSample(__func__, "sample", sample)) return r;
  if (sample->mode_count == 0) return welkin_sample_irradiance(sample, normal, irradiance);
  if (const auto r = unit(__func__, "normal", normal)) return r;
  if (const auto r = checkModes(__func__, "sample", *sample, sky->day.modes().count(), sky->day.family())) return r;
  const Number3 n = load(normal);
  const Number3 up = n.y < 0.0 ? -n : n;
  const double horizontal = f64::horizontalLength(up);
  const double column =
      f64::modeColumn(up, horizontal, double{sample->mode_azimuth[0]}, double{sample->mode_azimuth[1]});
  const auto mode = sky->day.modes().at(column, std::clamp(f64::modeRow(horizontal, up.y), 0.0, 1.0));
  Number3 sum = load(sample->ambient_ground) * f64::groundIrradiance(up.y);
  if (n.y < 0.0)
    sum +=
        f64::excessIrradiance(n, load(sample->ambient_sh[1]), load(sample->ambient_sh[2]), load(sample->ambient_sh[3]));
  for (std::uint32_t k = 0; k < sample->mode_count; ++k) sum += load(sample->mode_weight[k]) * mode[k];
  for (int i = 0; i < 3; ++i) irradiance[i] = toFloat(std::max(sum[i], 0.0));
  return WELKIN_OK;
}

WelkinResult welkin_sample_blend(const WelkinSkySample* first, const WelkinSkySample* second, float weight,
                                 WelkinSkySample* blended) {
  using namespace welkin::core;
  if (const auto r = checkSample(__func__, "first", first)) return r;
  if (const auto r = checkSample(__func__, "second", second)) return r;
  if (const auto r = sized(__func__, "blended", blended)) return r;
  if (!(weight >= 0.0F && weight <= 1.0F)) return refuse(__func__, "weight is %g, must be 0 to 1", double{weight});
  if (first->coefficient_count != second->coefficient_count)
    return refuse(__func__, "first has %u coefficients and second has %u", first->coefficient_count,
                  second->coefficient_count);
  WelkinSkySample out = take(*first);
  out.sun = blendLights(first->sun, second->sun, weight);
  out.moon = blendLights(first->moon, second->moon, weight);
  out.ambient_saturation = lerp(first->ambient_saturation, second->ambient_saturation, weight);
  lerp3(first->polarising_tint, second->polarising_tint, weight, out.polarising_tint);
  lerp3(first->ground_radiance, second->ground_radiance, weight, out.ground_radiance);
  for (std::uint32_t i = 0; i < out.coefficient_count; ++i) {
    lerp3(first->radiance_sh[i], second->radiance_sh[i], weight, out.radiance_sh[i]);
    lerp3(first->ambient_sh[i], second->ambient_sh[i], weight, out.ambient_sh[i]);
  }
  lerp3(first->ambient_ground, second->ambient_ground, weight, out.ambient_ground);
  if (shareModes(*first, *second)) {
    for (std::uint32_t k = 0; k < out.mode_count; ++k)
      lerp3(first->mode_weight[k], second->mode_weight[k], weight, out.mode_weight[k]);
  } else {
    out.mode_count = 0;
    out.mode_family = 0;
    std::fill_n(&out.mode_weight[0][0], 3 * WELKIN_MAX_MODES, 0.0F);
  }
  out.unchanged = 0;
  give(out, blended);
  return WELKIN_OK;
}

WelkinResult welkin_sample_key_light(const WelkinSkySample* sample, WelkinLight* light) {
  using namespace welkin::core;
  if (const auto r = checkSample(__func__, "sample", sample)) return r;
  if (const auto r = nonNull(__func__, {{"light", light}})) return r;
  const double sun = facing(sample->sun);
  const double moon = facing(sample->moon);
  const bool is_sun = sun >= moon;
  WelkinLight out = is_sun ? sample->sun : sample->moon;
  const double strong = std::max(sun, moon);
  const double share = strong > 0.0 ? (strong - std::min(sun, moon)) / strong * double{out.visible} : 0.0;
  store(load(out.normal_irradiance) * share, out.normal_irradiance);
  out.illuminance = toFloat(double{out.illuminance} * share);
  out.visible = 1.0F;
  *light = out;
  return WELKIN_OK;
}
