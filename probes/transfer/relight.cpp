// SPDX-License-Identifier: Apache-2.0
#include "probes/transfer/relight.h"

#include <cmath>

#include "sh/deterministic.h"

namespace welkin::transfer {
namespace {

std::array<double, 4> twoBands(const Number3& direction) {
  const det::ShBasis basis = det::shBasis(direction);
  return {basis.v[0], basis.v[1], basis.v[2], basis.v[3]};
}

Number3 product(const std::array<Number3, 4>& a, const std::array<Number3, 4>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
}

}  // namespace

std::array<Number3, 4> fittedToHemisphere(const std::array<Number3, 4>& sh) {
  // Inner products: 1/2 of each function with itself, sqrt(3)/4 of the constant with the function of y, otherwise 0.
  const double mixed = 4.0 * std::sqrt(3.0);
  return {sh[0] * 8.0 - sh[1] * mixed, sh[1] * 8.0 - sh[0] * mixed, sh[2] * 2.0, sh[3] * 2.0};
}

std::array<Number3, kDirections> ProbeIrradiance::total() const {
  std::array<Number3, kDirections> sum;
  for (std::size_t b = 0; b < kDirections; ++b) sum[b] = sky[b] + sun_bounce[b] + local[b];
  return sum;
}

Relight relightAt(double time_h, const std::array<Number3, 4>& sky_sh, const LightAt& sun, const LightAt& moon,
                  SunTransfer sun_transfer, const SunModes& modes, const RelightScale& scale, SkyBounce sky_bounce) {
  Relight result;
  result.sky = sky_sh;
  result.bounced_sky = sky_bounce == SkyBounce::fitted ? fittedToHemisphere(sky_sh) : sky_sh;
  result.sun_transfer = sun_transfer;
  result.scale = scale;
  std::size_t i = 0;
  for (const LightAt* light : {&sun, &moon}) {
    if (light->direction.y > 0.0) {
      result.light_irradiance[i] = light->irradiance;
      const auto basis = twoBands(light->direction);
      for (std::size_t k = 0; k < 4; ++k) result.light_sh[k] += light->irradiance * basis[k];
    }
    result.mode[i] = modesAt(modes, i == 0 ? LightOf::sun : LightOf::moon, time_h);
    ++i;
  }
  return result;
}

ProbeIrradiance relit(const ProbeTransfer& transfer, const SunCoefficients& sun, const Relight& light) {
  const auto basis = transferBasis();
  ProbeIrradiance result;
  for (std::size_t b = 0; b < kDirections; ++b) {
    const auto at = twoBands(basis[b]);
    Number3 open = light.sky[0] * (det::cosineLobe(0) * at[0]);
    for (std::size_t k = 1; k < 4; ++k) open += light.sky[k] * (det::cosineLobe(1) * at[k]);
    result.sky[b] = (open * transfer.visibility[b] + product(transfer.sky[b], light.bounced_sky)) * light.scale.sky;
    if (light.sun_transfer == SunTransfer::sh)
      result.sun_bounce[b] = product(transfer.sky[b], light.light_sh) * light.scale.sun_bounce;
    if (light.sun_transfer == SunTransfer::directional)
      for (std::size_t i = 0; i < 2; ++i)
        result.sun_bounce[b] += sunTransfer(sun[b], light.mode[i]) * light.light_irradiance[i] * light.scale.sun_bounce;
    result.local[b] = transfer.emitted[b];
  }
  return result;
}

}  // namespace welkin::transfer
