// SPDX-License-Identifier: Apache-2.0
#include "probes/sector_light.h"

#include <algorithm>

#include "format/domain_check.h"
#include "format/key_segment.h"
#include "shared.h"

namespace welkin::probes {
namespace {

using f64::Number3;
using format::spanOf;

Number3 vectorOf(const float v[3]) {
  return {double{v[0]}, double{v[1]}, double{v[2]}};
}

/// The nearest float within kMostLight.
float saturated(double light) {
  return static_cast<float>(std::clamp(light, -kMostLight, kMostLight));
}

/// The knots of a light's track, in hours, as the floats of the file.
format::KeySegment segmentOf(std::span<const float> knot_h, double time_h) {
  const auto next =
      std::upper_bound(knot_h.begin(), knot_h.end(), time_h, [](double t, float k) { return t < double{k}; });
  const auto after = static_cast<std::size_t>(next - knot_h.begin());
  format::KeySegment s{after == 0 ? knot_h.size() - 1 : after - 1, after == knot_h.size() ? 0 : after, 0.0};
  const double start = double{knot_h[s.first]} - (after == 0 ? format::kDay_h : 0.0);
  const double end = double{knot_h[s.second]} + (after == knot_h.size() ? format::kDay_h : 0.0);
  if (end > start) s.weight = (time_h - start) / (end - start);
  return s;
}

/// Writes the modes at an hour, times a light's irradiance, for numbers that are steps of 1 / 127 of their scales.
void writeModes(const format::Probes& probes, std::span<const float> knot_h, std::size_t first_knot, double time_h,
                const std::array<double, 3>& irradiance, float (*out)[3]) {
  if (knot_h.empty()) return;
  const format::KeySegment s = segmentOf(knot_h, time_h);
  const auto mode_scale = spanOf(probes.mode_scale()), coefficient_scale = spanOf(probes.coefficient_scale());
  const std::size_t knots = spanOf(probes.sun_time_h()).size() + spanOf(probes.moon_time_h()).size();
  const std::int8_t* first = probes.mode()->data() + 3 * (first_knot + s.first);
  const std::int8_t* second = probes.mode()->data() + 3 * (first_knot + s.second);
  const double of_second = s.weight / (127.0 * 127.0), of_first = (1.0 - s.weight) / (127.0 * 127.0);
  for (std::size_t m = 0; m < mode_scale.size(); ++m) {
    const double scale = double{mode_scale[m]} * double{coefficient_scale[m]};
    for (std::size_t c = 0; c < 3; ++c) {
      const double value = first[3 * m * knots + c] * of_first + second[3 * m * knots + c] * of_second;
      out[m][c] = saturated(value * scale * irradiance[c]);
    }
  }
}

}  // namespace

CommonLight commonOf(const LevelLight& light, bool sh) {
  CommonLight out{};
  out.local = saturated(light.local);
  const f64::TransferBasis basis = f64::transferBasis();
  for (std::size_t b = 0; b < 3; ++b) {
    const f64::ShBasis at = f64::shBasis(basis.v[b]);
    for (std::size_t c = 0; c < 3; ++c) {
      double open = 0.0;
      for (std::size_t k = 0; k < 4; ++k) open += light.sky[k][c] * f64::cosineLobe(k == 0 ? 0 : 1) * at.v[k];
      out.open[b][c] = saturated(open / 65535.0);
    }
  }
  for (std::size_t k = 0; k < 4; ++k)
    for (std::size_t c = 0; c < 3; ++c)
      out.sky[k][c] = saturated((light.sky[k][c] + (sh ? light.light_sh[k][c] : 0.0)) / (k < 2 ? 255.0 : 127.0));
  return out;
}

LevelLight levelLightOf(const WelkinLevelLight& light, const format::Level& level) {
  const WelkinSkySample& sample = *light.sample;
  LevelLight out;
  out.time_h = sample.time_h;
  out.local = double{light.local};
  const double of_sky = out.sky_factor = level.sky_scale() * double{light.sky};
  const double of_sun = level.sun_bounce_scale() * double{light.sun_bounce};
  const f64::ShBasis up = f64::shBasis({0.0, 1.0, 0.0});
  for (std::size_t k = 0; k < 4; ++k)
    for (std::size_t c = 0; c < 3; ++c) {
      const double ground = double{sample.ambient_ground[c]} * f64::groundLobe(k == 0 ? 0 : 1) * up.v[k];
      out.sky[k][c] = (double{sample.ambient_sh[k][c]} - ground) * of_sky;
    }
  std::size_t i = 0;
  for (const WelkinLight* l : {&sample.sun, &sample.moon}) {
    if (l->visible > 0.0F) {
      const f64::ShBasis basis = f64::shBasis(vectorOf(l->direction));
      for (std::size_t c = 0; c < 3; ++c) {
        // By the visible share, so that no wall's light jumps when the light rises.
        out.light_irradiance[i][c] = double{l->normal_irradiance[c]} * double{l->visible} * of_sun;
        for (std::size_t k = 0; k < 4; ++k) out.light_sh[k][c] += out.light_irradiance[i][c] * basis.v[k];
      }
    }
    ++i;
  }
  out.common = commonOf(out, level.sun() == format::SunTransfer::sh);
  return out;
}

SectorLight sectorLightOf(const LevelLight& light, const format::Sector& sector) {
  SectorLight out{light.common, {}, 0};
  if (sector.sun() != format::SunTransfer::directional) return out;
  const format::Probes& probes = *sector.probes();
  const auto sun_h = spanOf(probes.sun_time_h());
  const auto moon_h = spanOf(probes.moon_time_h());
  for (std::size_t i = 0; i < 2; ++i) {
    const auto& e = light.light_irradiance[i];
    if (!(e[0] > 0.0 || e[1] > 0.0 || e[2] > 0.0)) continue;
    writeModes(probes, i == 0 ? sun_h : moon_h, i == 0 ? 0 : sun_h.size(), light.time_h, e, out.mode[out.lights]);
    ++out.lights;
  }
  return out;
}

}  // namespace welkin::probes
