// SPDX-License-Identifier: Apache-2.0
// The part of the C interface that looks up the light of points.
#include <algorithm>
#include <cmath>

#include "core/floats.h"
#include "probes/look_up.h"

namespace welkin::probes {
namespace {

static_assert(sizeof(WelkinColours) == kColours * sizeof(float));

/// Weights of the directions for a normal, as floats.
Directions weightsFor(const float normal[3]) {
  const f64::TransferWeights weight = f64::transferWeights(core::load(normal));
  return Directions{static_cast<float>(weight.v[0]), static_cast<float>(weight.v[1]), static_cast<float>(weight.v[2]),
                    static_cast<float>(weight.v[3])};
}

format::InWorld inWorld(const float v[3]) {
  return {double{v[0]}, double{v[1]}, double{v[2]}};
}

bool isFinite(const float v[3]) {
  return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
}

}  // namespace
}  // namespace welkin::probes

using namespace welkin::core;
using namespace welkin::probes;

WelkinResult welkin_level_irradiance(const WelkinLevel* level, size_t count, const float (*position)[3],
                                     const float (*normal)[3], float (*irradiance)[3], uint8_t* served) {
  if (const auto r = nonNull(__func__, {{"level", level}})) return r;
  if (count == 0) return WELKIN_OK;
  if (const auto r = nonNull(__func__, {{"position", position}, {"normal", normal}, {"irradiance", irradiance}}))
    return r;
  for (std::size_t i = 0; i < count; ++i) {
    if (!isFinite(position[i])) return refuse(__func__, "position %zu is not finite", i);
    const float* n = normal[i];
    if (unit(__func__, "normal", n) != WELKIN_OK)
      return refuse(__func__, "normal %zu has the length %g, must be a unit vector", i,
                    std::sqrt(double{n[0]} * double{n[0]} + double{n[1]} * double{n[1]} + double{n[2]} * double{n[2]}));
    const PointLight light = lightOff(*level, inWorld(position[i]), inWorld(normal[i]));
    const Directions weight = weightsFor(normal[i]);
    for (std::size_t c = 0; c < kChannels; ++c) {
      const Directions part = weight * light.channel[c];
      irradiance[i][c] = std::max((part[0] + part[1]) + (part[2] + part[3]), 0.0F);
    }
    if (served != nullptr) served[i] = light.is_served ? 1 : 0;
  }
  return WELKIN_OK;
}

WelkinResult welkin_level_colours(const WelkinLevel* level, size_t count, const float (*position)[3],
                                  WelkinColours* colours, uint8_t* served) {
  if (const auto r = nonNull(__func__, {{"level", level}})) return r;
  if (count == 0) return WELKIN_OK;
  if (const auto r = nonNull(__func__, {{"position", position}, {"colours", colours}})) return r;
  for (std::size_t i = 0; i < count; ++i) {
    if (!isFinite(position[i])) return refuse(__func__, "position %zu is not finite", i);
    const PointLight light = lightAt(*level, inWorld(position[i]));
    for (std::size_t c = 0; c < kChannels; ++c)
      for (std::size_t b = 0; b < kDirections; ++b) colours[i].irradiance[b][c] = light.channel[c][b];
    if (served != nullptr) served[i] = light.is_served ? 1 : 0;
  }
  return WELKIN_OK;
}

WelkinResult welkin_colours_irradiance(const WelkinColours* colours, const float normal[3], float irradiance[3]) {
  if (const auto r = nonNull(__func__, {{"colours", colours}, {"irradiance", irradiance}})) return r;
  if (const auto r = unit(__func__, "normal", normal)) return r;
  const auto weight = weightsFor(normal);
  for (std::size_t c = 0; c < kChannels; ++c) {
    float sum = 0.0F;
    for (std::size_t b = 0; b < kDirections; ++b) sum += weight[b] * colours->irradiance[b][c];
    irradiance[c] = std::max(sum, 0.0F);
  }
  return WELKIN_OK;
}

WelkinResult welkin_colours_sh(const WelkinColours* colours, float radiance_sh[4][3]) {
  using welkin::f64::transferWeights;
  if (const auto r = nonNull(__func__, {{"colours", colours}, {"radiance_sh", radiance_sh}})) return r;
  // The weights are linear in the normal: their values for +y, +z, +x and -y give the constant and the three slopes.
  const auto up = transferWeights({0, 1, 0}), down = transferWeights({0, -1, 0});
  const auto front = transferWeights({0, 0, 1}), side = transferWeights({1, 0, 0});
  const double constant = welkin::f64::cosineLobe(0) * welkin::f64::kShConstant;
  const double linear = welkin::f64::cosineLobe(1) * welkin::f64::kShLinear;
  for (std::size_t c = 0; c < kChannels; ++c) {
    double sh[4] = {};
    for (std::size_t b = 0; b < kDirections; ++b) {
      const double e = double{colours->irradiance[b][c]};
      const double mean = (up.v[b] + down.v[b]) / 2.0;
      sh[0] += e * mean / constant;
      sh[1] += e * (up.v[b] - mean) / linear;
      sh[2] += e * (front.v[b] - mean) / linear;
      sh[3] += e * (side.v[b] - mean) / linear;
    }
    for (std::size_t k = 0; k < 4; ++k) radiance_sh[k][c] = toFloat(sh[k]);
  }
  return WELKIN_OK;
}
