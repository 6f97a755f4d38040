// SPDX-License-Identifier: Apache-2.0
#include "sh/window.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <vector>

#include "sh/basis.h"

namespace welkin::sh {
namespace {

using Bands = std::array<double, 5>;

/// Irradiance from one set of coefficients at a normal, by band.
Bands irradianceByBand(std::span<const double> radiance, int bands, const det::ShBasis& basis) {
  Bands irradiance{};
  for (int l = 0; l < bands; ++l) {
    double sum = 0.0;
    for (int m = -l; m <= l; ++m)
      sum += radiance[static_cast<std::size_t>(indexOf(l, m))] * basis.v[static_cast<std::size_t>(indexOf(l, m))];
    irradiance[static_cast<std::size_t>(l)] = det::cosineLobe(l) * sum;
  }
  return irradiance;
}

/// Whether the irradiance under `window` is high enough at every normal (mildestWindow).
bool holds(const Window& window, std::span<const Bands> irradiance) {
  for (const Bands& at : irradiance) {
    double sum = 0.0;
    for (std::size_t l = at.size(); l-- > 1;) sum += window.factor[l] * at[l];
    if (at[0] + sum < -kWindowTolerance * at[0]) return false;
  }
  return true;
}

/// The least strength that holds, above `low`, which does not.
double bisect(double low, std::span<const Bands> irradiance) {
  double high = 1.0;  // where the mean alone is left
  for (int step = 0; step < 40; ++step) {
    const double middle = 0.5 * (low + high);
    (holds(windowOf(middle), irradiance) ? high : low) = middle;
  }
  return high;
}

}  // namespace

Window windowOf(double strength) {
  Window window;
  window.strength = strength;
  double power = 1.0;
  for (std::size_t l = 1; l < window.factor.size(); ++l) {  // from l - 1 to l the exponent grows by l
    power *= 1.0 - strength;
    window.factor[l] = window.factor[l - 1] * power;
  }
  return window;
}

Window mildestWindow(std::span<const double> radiance, int bands, std::span<const det::Number3> normals) {
  assert(bands >= 2 && bands <= 5);
  const auto size = static_cast<std::size_t>(coefficientCount(bands));
  std::vector<det::ShBasis> basis;
  for (const det::Number3& normal : normals) basis.push_back(det::shBasis(normal));
  std::vector<Bands> irradiance(normals.size());
  double strength = 0.0;
  // Irradiance may be lower between the normals than at them, and diffusion spreads such a low to them. So a set that
  // held can fail, by a little, at a greater strength. The loop repeats until all sets hold at one strength.
  for (bool grew = true; grew;) {
    grew = false;
    for (std::size_t first = 0; first < radiance.size(); first += size) {
      assert(radiance[first] >= 0.0);
      for (std::size_t i = 0; i < basis.size(); ++i)
        irradiance[i] = irradianceByBand(radiance.subspan(first, size), bands, basis[i]);
      if (holds(windowOf(strength), irradiance)) continue;
      strength = bisect(strength, irradiance);
      grew = true;
    }
  }
  return windowOf(strength);
}

}  // namespace welkin::sh
