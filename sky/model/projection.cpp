// SPDX-License-Identifier: Apache-2.0
#include "sky/model/projection.h"

#include <algorithm>
#include <cmath>

#include "sh/basis.h"

namespace welkin::model {
namespace {

/// From this tolerance on, tables with an error of IndicatrixTable::kError may be used.
constexpr double kTableTolerance = 1e-6;

/// The named models have lobes up to c = 24. For a much stronger lobe the rest of the sky no longer hides the rule's
/// error: up to 2e-5 of c0 where the rule promises 1e-5, at c = 1e4, d = -50.
double toleranceFor(const LuminanceModel& model, double tolerance) {
  constexpr double kStrong = 100.0;
  return std::abs(model.c) > kStrong ? 1e-2 * tolerance : tolerance;
}

/// cos(m phi) and sin(m phi) of a direction's azimuth in the polar frame. The pole itself has azimuth 0.
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

SkyProjector::SkyProjector(const LuminanceModel& model, int bands, double tolerance)
    : bands_(bands),
      quadrature_(toleranceFor(model, tolerance), bands, model.d),
      recurrence_(bands),
      to_world_(bands, sh::kPolarAxes) {
  if (tolerance >= kTableTolerance && model.d >= -IndicatrixTable::kSteepest) table_.emplace(model.d);
}

void addMoments(const Latitude& at, std::span<const Number3> order, std::span<const double> factor, int bands,
                PolarMoments& moments) {
  for (int l = 0; l < bands; ++l)
    for (int m = 0; m <= l; ++m)
      moments.radiance_sh[polarIndex(l, m)] +=
          order[static_cast<std::size_t>(m)] * (2.0 * at.weight * factor[static_cast<std::size_t>(sh::indexOf(l, m))]);
  moments.horizontal_irradiance += order[0] * (2.0 * at.weight * at.sine);
}

PolarMoments SkyProjector::projectPolar(const SkyInstant& instant) const {
  PolarMoments moments;
  moments.radiance_sh.resize(polarIndex(bands_, 0));
  std::vector<double> factor(static_cast<std::size_t>(sh::coefficientCount(bands_)));
  std::vector<Number3> order(static_cast<std::size_t>(bands_));

  const SunFrame sun(instant, table_ ? &*table_ : nullptr);
  quadrature_.forEachLatitude(sun, {}, [&](const Latitude& at) {
    std::fill(order.begin(), order.end(), Number3(0.0));
    moments.evaluations += quadrature_.addOrders(sun, at, order);
    recurrence_.evaluate(at.sine, at.cosine, factor);
    addMoments(at, order, factor, bands_, moments);
  });
  return moments;
}

SkyMoments SkyProjector::project(const SkyInstant& instant) const {
  const PolarMoments in_sun_frame = projectPolar(instant);
  const auto count = static_cast<std::size_t>(sh::coefficientCount(bands_));
  SkyMoments moments{std::vector<Number3>(count), in_sun_frame.horizontal_irradiance, in_sun_frame.evaluations};
  const Turn turn(instant.sunDirection());
  std::vector<double> polar(count);
  std::vector<double> world(count);
  for (int channel = 0; channel < 3; ++channel) {
    double cos_m = 1.0;
    double sin_m = 0.0;
    for (int m = 0; m < bands_; ++m) {
      for (int l = m; l < bands_; ++l) {
        const double moment = in_sun_frame.radiance_sh[polarIndex(l, m)][channel];
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
  const Turn sun_turn(instant.sunDirection());
  const Turn facing(normal);
  // Azimuth of the normal from the sun's, and the elevation at which the surface's plane leaves the circle.
  const double cos_facing = facing.cosine * sun_turn.cosine + facing.sine * sun_turn.sine;
  const double sin_facing = facing.sine * sun_turn.cosine - facing.cosine * sun_turn.sine;
  const double facing_rad = det::atan(sin_facing, cos_facing);
  const double horizontal = det::horizontalLength(normal);
  const double tangent = det::atan(horizontal, std::abs(normal.y));
  std::vector<double> extra = {tangent};
  for (double r = 0.3; r > 1e-3; r /= 3.0) extra.insert(extra.end(), {tangent - r, tangent + r});

  Number3 sum(0.0);
  const SunFrame sun(instant, table_ ? &*table_ : nullptr);
  quadrature_.forEachLatitude(sun, extra, [&](const Latitude& at) {
    const double across = horizontal * at.cosine;
    const double along = normal.y * at.sine;
    for (const double side : {1.0, -1.0}) {
      double bend[3];
      std::size_t bends = 0;
      double storage[1];
      for (const double t : HemisphereQuadrature::fadeCrossing(at, storage)) bend[bends++] = t;
      if (std::abs(along) < across) {  // The surface's plane cuts the circle at +-beta from the normal's azimuth.
        const double beta = det::atan(std::sqrt(across * across - along * along), -along);
        for (const double phi : {facing_rad - beta, facing_rad + beta}) {
          const double alpha = std::remainder(side * phi, det::kTwoPi);
          if (alpha > 0.0) bend[bends++] = det::sin(0.5 * alpha) / det::cos(0.5 * alpha);
        }
      }
      quadrature_.forEachAzimuth(at, {bend, bends}, [&](const Azimuth& azimuth) {
        const double lit = along + across * (azimuth.cosine * cos_facing + side * azimuth.sine * sin_facing);
        if (lit > 0.0) sum += shapeOn(sun, at, azimuth) * (azimuth.weight * at.weight * lit);
      });
    }
  });
  return sum;
}

}  // namespace welkin::model
