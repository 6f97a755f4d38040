// SPDX-License-Identifier: Apache-2.0
#include "sky/projection.h"

#include <algorithm>
#include <cmath>

#include "sh/basis.h"

namespace welkin::sky {
namespace {

/// cos(m phi) and sin(m phi) of a direction's azimuth in the polar frame; the pole itself counts as azimuth 0.
struct Turn {
  double cosine = 1.0;
  double sine = 0.0;
  explicit Turn(const Number3& direction) {
    const double length = det::horizontalLength(direction);
    if (length > 0.0) {
      cosine = direction.z / length;
      sine = direction.x / length;
    }
  }
};

}  // namespace

SkyProjector::SkyProjector(int bands, int refinement)
    : bands_(bands),
      quadrature_(refinement),
      fading_(2 * refinement),
      recurrence_(bands),
      to_world_(bands, sh::kPolarAxes) {}

const HemisphereQuadrature& SkyProjector::quadratureFor(const SkyInstant& instant) const {
  return HemisphereQuadrature::fades(instant) ? fading_ : quadrature_;
}

SkyMoments SkyProjector::project(const SkyInstant& instant) const {
  const auto count = static_cast<std::size_t>(sh::coefficientCount(bands_));
  const HemisphereQuadrature& quadrature = quadratureFor(instant);
  SkyMoments moments;
  std::vector<Number3> in_sun_frame(count);  // orders m >= 0 only: the sky is symmetric about the sun's plane
  std::vector<double> factor(count);
  std::vector<Number3> order(static_cast<std::size_t>(bands_));

  quadrature.forEachLatitude(instant, {}, [&](const Latitude& at) {
    std::fill(order.begin(), order.end(), Number3(0.0));
    double storage[1];
    quadrature.forEachAzimuth(at, HemisphereQuadrature::fadeCrossing(at, storage), [&](double alpha, double weight) {
      const double cosine = det::cos(alpha);
      const Number3 shape = shapeOn(instant, at, cosine) * weight;
      double before = cosine;  // Chebyshev's recurrence: cos (m + 1) a = 2 cos a cos m a - cos (m - 1) a
      double current = 1.0;
      for (auto& sum : order) {
        sum += shape * current;
        const double next = 2.0 * cosine * current - before;
        before = current;
        current = next;
      }
      ++moments.evaluations;
    });
    recurrence_.evaluate(at.sine, at.cosine, factor);
    for (int l = 0; l < bands_; ++l)
      for (int m = 0; m <= l; ++m) {
        const auto i = static_cast<std::size_t>(sh::indexOf(l, m));
        in_sun_frame[i] += order[static_cast<std::size_t>(m)] * (2.0 * at.weight * factor[i]);
      }
    moments.horizontal_irradiance += order[0] * (2.0 * at.weight * at.sine);
  });

  const Turn turn(instant.sunDirection());
  std::vector<double> polar(count);
  std::vector<double> world(count);
  moments.radiance_sh.resize(count);
  for (int channel = 0; channel < 3; ++channel) {
    double cos_m = 1.0;
    double sin_m = 0.0;
    for (int m = 0; m < bands_; ++m) {
      for (int l = m; l < bands_; ++l) {
        const double moment = in_sun_frame[static_cast<std::size_t>(sh::indexOf(l, m))][channel];
        polar[static_cast<std::size_t>(sh::indexOf(l, m))] = moment * cos_m;
        if (m > 0) polar[static_cast<std::size_t>(sh::indexOf(l, -m))] = moment * sin_m;
      }
      const double next = cos_m * turn.cosine - sin_m * turn.sine;
      sin_m = sin_m * turn.cosine + cos_m * turn.sine;
      cos_m = next;
    }
    to_world_.apply(polar, world);
    for (std::size_t i = 0; i < count; ++i) moments.radiance_sh[i][channel] = world[i];
  }
  return moments;
}

Number3 SkyProjector::irradiance(const SkyInstant& instant, const Number3& normal) const {
  const Turn sun(instant.sunDirection());
  const Turn facing(normal);
  // Azimuth of the normal from the sun's, and the elevation at which the plane of the surface leaves the circle.
  const double cos_facing = facing.cosine * sun.cosine + facing.sine * sun.sine;
  const double sin_facing = facing.sine * sun.cosine - facing.cosine * sun.sine;
  const double facing_rad = det::atan(sin_facing, cos_facing);
  const double horizontal = det::horizontalLength(normal);
  const double tangent = det::atan(horizontal, std::abs(normal.y));
  std::vector<double> extra = {tangent};
  for (double r = 0.3; r > 1e-3; r /= 3.0) extra.insert(extra.end(), {tangent - r, tangent + r});

  const HemisphereQuadrature& quadrature = quadratureFor(instant);
  Number3 sum(0.0);
  quadrature.forEachLatitude(instant, extra, [&](const Latitude& at) {
    const double across = horizontal * at.cosine;
    const double along = normal.y * at.sine;
    for (const double side : {1.0, -1.0}) {
      double bend[3];
      std::size_t bends = 0;
      double storage[1];
      for (const double alpha : HemisphereQuadrature::fadeCrossing(at, storage)) bend[bends++] = alpha;
      if (std::abs(along) < across) {  // the surface's plane cuts the circle at +-beta from the normal's azimuth
        const double beta = det::atan(std::sqrt(across * across - along * along), -along);
        for (const double phi : {facing_rad - beta, facing_rad + beta}) {
          const double alpha = std::remainder(side * phi, det::kTwoPi);
          if (alpha > 0.0) bend[bends++] = alpha;
        }
      }
      quadrature.forEachAzimuth(at, {bend, bends}, [&](double alpha, double weight) {
        const double cosine = det::cos(alpha);
        const double lit = along + across * (cosine * cos_facing + side * det::sin(alpha) * sin_facing);
        if (lit > 0.0) sum += shapeOn(instant, at, cosine) * (weight * at.weight * lit);
      });
    }
  });
  return sum;
}

}  // namespace welkin::sky
