// SPDX-License-Identifier: Apache-2.0
#include "always.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace welkin::tests {
namespace {

/// Keeps the first complaint.
class Check {
 public:
  void finite(const char* what, double value) { inside(what, value, -kLargest, kLargest); }
  void positive(const char* what, double value) { inside(what, value, 0.0, kLargest); }
  void inside(const char* what, double value, double low, double high) {
    if (fault_.empty() && !(value >= low && value <= high))
      fault_ = fmt::format("{} is {}, not {} to {}", what, value, low, high);
  }
  void positive(const char* what, const float (&values)[3]) {
    for (const float v : values) positive(what, double{v});
  }
  void positive(const char* what, const Number3& v) {
    for (int i = 0; i < 3; ++i) positive(what, v[i]);
  }
  void unit(const char* what, const float (&d)[3]) {
    inside(what, std::hypot(double{d[0]}, double{d[1]}, double{d[2]}), 1.0 - 1e-6, 1.0 + 1e-6);
  }
  void that(const char* what, bool holds) {
    if (fault_.empty() && !holds) fault_ = what;
  }
  const Fault& fault() const { return fault_; }

 private:
  static constexpr double kLargest = std::numeric_limits<double>::max();
  Fault fault_;
};

double largestOf(const Number3& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

void checkLight(Check& check, const WelkinLight& light) {
  check.unit("a light's direction", light.direction);
  check.positive("a light's illuminance", double{light.illuminance});
  check.positive("a light's colour", light.colour);
  check.positive("a light's irradiance", light.normal_irradiance);
  check.inside("a light's visible share", double{light.visible}, 0.0, 1.0);
}

}  // namespace

Fault faultOfModel(const model::SkyInstant& instant, const Number3& direction) {
  Check check;
  check.positive("the normalising luminance", instant.luminanceNorm());
  check.positive("the model's intensity", instant.intensity());
  check.positive("the model's shape", instant.shape(direction));
  const Number3 ground = instant.groundRadiance(Number3(1.0));
  check.positive("the model's ground", ground);
  check.positive("the model's dome", instant.dome(direction, ground));
  return check.fault();
}

Fault faultOfSample(const WelkinSkySample& s) {
  Check check;
  checkLight(check, s.sun);
  if (s.moon.direction[0] != 0.0F || s.moon.direction[1] != 0.0F || s.moon.direction[2] != 0.0F)
    checkLight(check, s.moon);
  check.inside("the sample's time", s.time_h, 0.0, std::nextafter(24.0, 0.0));
  check.positive("the sample's intensity", double{s.intensity});
  check.inside("the sample's saturation", double{s.ambient_saturation}, 0.0, 1.0);
  check.positive("the sample's tint", s.polarising_tint);
  check.positive("the sample's ground", s.ground_radiance);
  check.inside("the sample's norm", double{s.luminance_norm}, 1e-31, 1e38);
  for (std::uint32_t i = 0; i < WELKIN_MAX_COEFFICIENTS; ++i)
    for (int c = 0; c < 3; ++c) {
      check.finite("a radiance coefficient", double{s.radiance_sh[i][c]});
      check.finite("an ambient coefficient", double{s.ambient_sh[i][c]});
      // |Y_lm| of any direction is at most sqrt((2 l + 1) / 4 pi) = sqrt(2 l + 1) Y_00.
      const double most = 3.001 * std::abs(double{s.radiance_sh[0][c]}) + 1e-44;  // The smallest float is 1.4e-45.
      check.inside("a coefficient, in a sky of one sign,", double{s.radiance_sh[i][c]}, -most, most);
    }
  WelkinLight key{};
  check.that("no key light", welkin_sample_key_light(&s, &key) == WELKIN_OK);
  check.positive("the key light", key.normal_irradiance);
  return check.fault();
}

Fault faultOfDirection(const welkin::Sky& sky, const WelkinSkySample& sample, const Number3& direction) {
  const float d[3] = {float(direction.x), float(direction.y), float(direction.z)};
  float value[3];
  Check check;
  check.that("no dome", welkin_dome_radiance(sky.get(), &sample, d, value) == WELKIN_OK);
  check.positive("the dome", value);
  check.that("no irradiance", welkin_sample_irradiance(&sample, d, value) == WELKIN_OK);
  check.positive("the irradiance", value);
  check.that("no discs", welkin_disc_radiance(&sample, d, 1e-3F, value) == WELKIN_OK);
  check.positive("the discs", value);
  check.that("no stars", welkin_star_radiance(sky.get(), &sample, d, value) == WELKIN_OK);
  check.positive("the stars", value);
  return check.fault();
}

Shown domeOf(const model::SkyInstant& instant, const Number3& direction) {
  const Number3 tint = instant.sky().polarising_tint.colourAt(instant.time_h());
  return {instant.dome(direction, Number3(0.0)),
          largestOf(instant.shape(direction)) * instant.intensity() * largestOf(tint)};
}

std::vector<Shown> seen(const welkin::Sky& sky, const WelkinSkySample& sample, const Number3& direction) {
  const float d[3] = {float(direction.x), float(direction.y), float(direction.z)};
  float dome[3];
  float irradiance[3];
  welkin_dome_radiance(sky.get(), &sample, d, dome);
  welkin_sample_irradiance(&sample, d, irradiance);
  const float* c0 = sample.ambient_sh[0];
  const double mean = f64::kPi * f64::kShConstant * double{std::max({c0[0], c0[1], c0[2]})};
  double size = 0.0;
  for (int c = 0; c < 3; ++c)
    if (const double tint = double{sample.polarising_tint[c]}; tint > 0.0)
      size = std::max(
          size, double{dome[c]} / tint * double{*std::max_element(sample.polarising_tint, sample.polarising_tint + 3)});
  return {{{double{dome[0]}, double{dome[1]}, double{dome[2]}}, size},
          {{double{irradiance[0]}, double{irradiance[1]}, double{irradiance[2]}}, mean}};
}

std::vector<Number3> specialDirections(const Number3& sun) {
  constexpr double kUnit = std::numeric_limits<double>::denorm_min();
  const double length = std::hypot(sun.x, sun.z);
  std::vector<Number3> list = {
      {0, 1, 0},      {0, -1, 0},   {1, 0, 0},     {-1, 0, 0},     {0, 0, 1},       {0, 0, -1}, {1, kUnit, 0},
      {1, -kUnit, 0}, {0, -0.0, 1}, {0, 1e-7, -1}, {1e-8, 1, 0.0}, {0, -1, 1e-300}, sun,        -sun};
  if (length > 0.0) {
    list.push_back({sun.x / length, 0.0, sun.z / length});
    list.push_back({-sun.x / length, 0.0, -sun.z / length});
  }
  return list;
}

Step largestStep(const std::function<std::vector<Shown>(double)>& function, double low, double high,
                 double resolution) {
  std::vector<Shown> at_low = function(low);
  std::vector<Shown> at_high = function(high);
  std::vector<double> size(at_low.size(), 0.0);
  const auto change = [&](const std::vector<Shown>& a, const std::vector<Shown>& b) {
    double largest = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
      for (const Shown* s : {&a[i], &b[i]}) size[i] = std::max({size[i], s->size, largestOf(s->colour)});
      largest = std::max(largest, largestOf(a[i].colour - b[i].colour) / (size[i] > 1e-30 ? size[i] : 1.0));
    }
    return largest;
  };
  while (high - low > resolution) {
    const double middle = 0.5 * (low + high);
    if (middle <= low || middle >= high) break;
    std::vector<Shown> at_middle = function(middle);
    if (change(at_low, at_middle) > change(at_middle, at_high)) {
      high = middle;
      at_high = std::move(at_middle);
    } else {
      low = middle;
      at_low = std::move(at_middle);
    }
  }
  return {change(at_low, at_high), low, high};
}

}  // namespace welkin::tests
