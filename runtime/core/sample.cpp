// SPDX-License-Identifier: Apache-2.0
// The sky at an instant. Lights, intensity, tint and saturation are evaluated from their own keys, exactly as the bake
// did; only the shape of the sky's radiance is interpolated between the table's keys.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "core/sky.h"
#include "format/key_segment.h"

namespace welkin::core {

float toFloat(double value) {
  constexpr double kLargest = double{std::numeric_limits<float>::max()};
  return static_cast<float>(std::clamp(value, -kLargest, kLargest));
}

Course::Course(const format::LightPath& path)
    : time_h_(spanOf(path.key_time_h())),
      azimuth_rad_(spanOf(path.key_azimuth_rad())),
      elevation_rad_(spanOf(path.key_elevation_rad())),
      circle_(f64::dailyCircle(path.declination_rad(), path.latitude_rad(), path.north_offset_rad())),
      transit_h_(path.transit_h()) {}

f64::Number3 Course::directionAt(double time_h) const {
  if (time_h_.empty()) return f64::directionOnCircle(circle_, f64::kTwoPi * (time_h - transit_h_) / 24.0);
  const auto s = format::findSegment(time_h_, time_h);
  return f64::directionOf(format::interpolateAngle(azimuth_rad_[s.first], azimuth_rad_[s.second], s.weight),
                          (1.0 - s.weight) * elevation_rad_[s.first] + s.weight * elevation_rad_[s.second]);
}

namespace {

using f64::Number3;

double evaluate(const format::Curve& curve, double time_h) {
  if (curve.value()->size() == 1) return curve.value()->Get(0);
  double value = 0.0;
  format::interpolate(spanOf(curve.time_h()), spanOf(curve.value()), time_h, {&value, 1});
  return value;
}

Number3 evaluate3(const format::Curve& curve, double time_h) {
  if (const auto& only = *curve.value(); only.size() == 3) return {only[0], only[1], only[2]};
  double v[3];
  format::interpolate(spanOf(curve.time_h()), spanOf(curve.value()), time_h, v);
  return {v[0], v[1], v[2]};
}

void store(Number3 v, float out[3]) {
  for (int i = 0; i < 3; ++i) out[i] = toFloat(v[i]);
}

/// Share of a disc's area above the horizon: a circular segment. Without a disc, of one of a quarter of a degree.
double visibleShare(const Number3& direction, double disc_radius_rad) {
  constexpr double kQuarterDegree = 0.25 * f64::kPi / 180.0;
  const double radius = disc_radius_rad > 0.0 ? disc_radius_rad : kQuarterDegree;
  if (std::abs(direction.y) > radius) return direction.y > 0.0 ? 1.0 : 0.0;  // an arc is longer than its sine
  const double x = std::clamp(f64::elevationOf(direction) / radius, -1.0, 1.0);
  return std::clamp(0.5 + (std::asin(x) + x * std::sqrt(1.0 - x * x)) / f64::kPi, 0.0, 1.0);  // rounding
}

struct LightAt {
  Number3 direction, colour, normal_irradiance;
  double illuminance;
};

LightAt lightAt(const format::Light& light, const Course& course, double time_h) {
  LightAt at;
  at.direction = course.directionAt(time_h);
  at.illuminance = evaluate(*light.illuminance(), time_h);
  at.colour = evaluate3(*light.colour(), time_h);
  const double y = f64::luminanceOf(at.colour);
  at.normal_irradiance = y > 0.0 ? at.colour * (at.illuminance / y) : Number3(0.0);
  return at;
}

WelkinLight lightOf(const LightAt& at, double disc_radius_rad) {
  WelkinLight light{};
  store(at.direction, light.direction);
  light.illuminance = toFloat(at.illuminance);
  store(at.colour, light.colour);
  store(at.normal_irradiance, light.normal_irradiance);
  light.disc_radius_rad = toFloat(disc_radius_rad);
  light.visible = toFloat(visibleShare(at.direction, disc_radius_rad));
  return light;
}

void blendTable(const WelkinSky& opened, double time_h, double intensity, const LightAt& sun, const LightAt* moon,
                WelkinSkySample& out) {
  Day::Shape shape;
  opened.day.shapeAt(time_h, shape);
  const Azimuth azimuth(sun.direction);
  Number3 world[WELKIN_MAX_COEFFICIENTS];
  opened.frame.toWorld(opened.day.bands(), shape.polar, azimuth, world);

  Number3 horizontal = intensity * shape.horizontal_irradiance;
  horizontal += sun.normal_irradiance * std::max(sun.direction.y, 0.0);
  if (moon != nullptr) horizontal += moon->normal_irradiance * std::max(moon->direction.y, 0.0);
  const auto* albedo = opened.file->sky()->ground_albedo();
  const Number3 ground = Number3(double{albedo->r()}, double{albedo->g()}, double{albedo->b()}) * horizontal / f64::kPi;
  const double saturation = double{out.ambient_saturation};
  store(ground, out.ground_radiance);
  store(f64::desaturate(ground, saturation), out.ambient_ground);

  out.coefficient_count = static_cast<std::uint32_t>(opened.day.bands() * opened.day.bands());
  for (std::uint32_t i = 0; i < out.coefficient_count; ++i) {
    const Number3 radiance = intensity * world[i] + ground * opened.ground_sh[i];
    store(radiance, out.radiance_sh[i]);
    store(f64::desaturate(radiance, saturation), out.ambient_sh[i]);
  }
  out.mode_count = static_cast<std::uint32_t>(opened.day.modes().count());
  for (std::uint32_t k = 0; k < out.mode_count; ++k)
    store(f64::desaturate(intensity * shape.weight[k], saturation), out.mode_weight[k]);
  out.mode_azimuth[0] = toFloat(azimuth.sine * azimuth.share);
  out.mode_azimuth[1] = toFloat(azimuth.cosine * azimuth.share);
}

void chooseCubemaps(const format::Sky& sky, double time_h, WelkinSkySample& out) {
  if (sky.cubemaps() == nullptr || sky.cubemaps()->size() == 0) return;
  const auto& cubemaps = *sky.cubemaps();
  const std::uint32_t count = cubemaps.size();
  std::uint32_t second = 0;  // the first cubemap after time_h; their number is small
  while (second < count && cubemaps.Get(second)->time_h() <= time_h) ++second;
  const std::uint32_t first = (second + count - 1) % count;
  second %= count;
  out.cubemap[0] = first;
  out.cubemap[1] = second;
  if (first == second) return;
  const double keys[2] = {cubemaps.Get(first)->time_h(), cubemaps.Get(second)->time_h()};
  const double since = time_h - keys[0] + (time_h < keys[0] ? 24.0 : 0.0);
  const double length = keys[1] - keys[0] + (keys[1] < keys[0] ? 24.0 : 0.0);
  out.cubemap_weight = std::min(toFloat(since / length), std::nextafter(1.0F, 0.0F));
}

}  // namespace
}  // namespace welkin::core

WelkinResult welkin_sky_sample(const WelkinSky* sky, double time_h, WelkinSkySample* sample) {
  using namespace welkin;
  using namespace welkin::core;
  if (sky == nullptr || sample == nullptr || !std::isfinite(time_h)) return WELKIN_ERROR_ARGUMENT;
  const auto& s = *sky->file->sky();
  WelkinSkySample out;
  std::memset(&out, 0, sizeof out);
  out.time_h = format::wrapTime(time_h);
  const double intensity = evaluate(*s.intensity(), out.time_h);
  out.intensity = toFloat(intensity);
  out.ambient_saturation = toFloat(evaluate(*s.ambient_saturation(), out.time_h));
  store(evaluate3(*s.polarising_tint(), out.time_h), out.polarising_tint);

  const LightAt sun = lightAt(*s.sun(), sky->sun, out.time_h);
  out.sun = lightOf(sun, s.sun()->disc_radius_rad());
  LightAt moon;
  if (s.moon() != nullptr) {
    moon = lightAt(*s.moon(), sky->moon, out.time_h);
    out.moon = lightOf(moon, s.moon()->disc_radius_rad());
  }
  const double norm = f64::luminanceNormFrom(luminanceModel(*s.luminance()), sun.direction,
                                             s.luminance()->normalise_to_sun() != 0, sky->constant_norm);
  out.luminance_norm = toFloat(std::max(kLeastDivisor, norm));  // checkContent looks at whole minutes only
  blendTable(*sky, out.time_h, intensity, sun, s.moon() != nullptr ? &moon : nullptr, out);
  chooseCubemaps(s, out.time_h, out);
  out.unchanged = sample->unchanged;
  const bool unchanged = std::memcmp(&out, sample, sizeof out) == 0;
  if (!unchanged) std::memcpy(sample, &out, sizeof out);  // padding too, which the comparison sees
  sample->unchanged = unchanged ? 1 : 0;
  return WELKIN_OK;
}
