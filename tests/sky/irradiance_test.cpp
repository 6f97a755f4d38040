// SPDX-License-Identifier: Apache-2.0
// Irradiance of all normals at once against direct integration, normal by normal.
#include "sky/irradiance.h"

#include <tbb/parallel_for.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <mutex>

namespace welkin::sky {
namespace {

constexpr double kDegree = M_PI / 180.0;

/// A sky with the sun fixed at an elevation, azimuth 40 degrees.
Sky fixedSky(const LuminanceModel& model, double elevation_deg) {
  Sky sky;
  sky.luminance = model;
  sky.sun.path.key_time_h = {0.0};
  sky.sun.path.key_azimuth_rad = {40.0 * kDegree};
  sky.sun.path.key_elevation_rad = {elevation_deg * kDegree};
  return sky;
}

/// The world's direction of a normal at a row's y and an azimuth from the sun's; the sign says on which side.
Number3 normalAt(double y, double alpha) {
  const double across = std::sqrt(std::max(1.0 - y * y, 0.0));
  const double azimuth = 40.0 * kDegree + alpha;
  return {across * std::sin(azimuth), y, -across * std::cos(azimuth)};
}

Number3 valueOf(const IrradianceField& field, int row, double alpha) {
  Number3 sum(0.0);
  for (int m = 0; m < IrradianceProjector::kOrders; ++m)
    sum += field.series[static_cast<std::size_t>(row * IrradianceProjector::kOrders + m)] * std::cos(m * alpha);
  return sum;
}

/// Largest difference of any channel over the mean, at every `stride`-th row and some azimuths on both sides.
double worstOf(const Sky& sky, int stride) {
  const SkyInstant instant(sky, 0.0);
  const IrradianceProjector projector(sky.luminance);
  const IrradianceField field = projector.fieldOf(instant);
  const SkyProjector direct(sky.luminance, 1, 1e-9);
  double worst = 0.0;
  for (int row = 0; row < IrradianceProjector::kRows; row += stride)
    for (const double alpha : {0.0, 0.4, -1.1, 2.0, M_PI}) {
      const Number3 up = normalAt(projector.rowY(row), alpha);
      const Number3 above = valueOf(field, row, alpha);
      const Number3 below = above - field.excess(projector.rowY(row), std::cos(alpha));
      const Number3 want_above = direct.irradiance(instant, up);
      const Number3 want_below = direct.irradiance(instant, -up);
      for (int c = 0; c < 3; ++c) {
        worst = std::max(worst, std::abs(above[c] - want_above[c]) / field.mean[c]);
        worst = std::max(worst, std::abs(below[c] - want_below[c]) / field.mean[c]);
      }
    }
  return worst;
}

}  // namespace

TEST_CASE("IrradianceField, IsDirectIntegrationForEveryModelAndSun") {
  const auto& named = namedLuminances();
  const double elevations[] = {-18.0, 0.0, 2.0, 12.0, 50.0, 90.0};
  double worst = 0.0;
  std::string where;
  std::mutex mutex;
  tbb::parallel_for(std::size_t{0}, named.size() * std::size(elevations), [&](std::size_t i) {
    const auto& [name, model] = named[i / std::size(elevations)];
    const double elevation = elevations[i % std::size(elevations)];
    const double here = worstOf(fixedSky(model, elevation), 8);
    const std::lock_guard lock(mutex);
    if (here > worst) {
      worst = here;
      where = std::string(name) + " at " + std::to_string(elevation);
    }
  });
  CAPTURE(where, worst);
  CHECK(worst < IrradianceProjector::kError);

}

TEST_CASE("IrradianceField, ColoursOnBothSides") {
  Sky sky = fixedSky(*findLuminance("cie-12"), 15.0);
  sky.gradient_sun = {1, 3, {1.0F, 0.4F, 0.1F, 0.5F, 0.5F, 0.6F, 0.1F, 0.3F, 0.9F}};
  sky.gradient_anti = {1, 2, {0.2F, 0.3F, 0.8F, 0.4F, 0.2F, 0.6F}};
  normalise(sky.gradient_sun, sky.gradient_anti);
  CHECK(worstOf(sky, 4) < IrradianceProjector::kError);
}

TEST_CASE("IrradianceField, UniformSkyIsALinearFunction") {
  // E(n) = pi (1 + n_y) / 2. Panels are widest here, and the clip lies inside them.
  const Sky sky = fixedSky(*findLuminance("cie-5"), 30.0);
  const IrradianceProjector projector(sky.luminance);
  const IrradianceField field = projector.fieldOf(SkyInstant(sky, 0.0));
  for (int row = 0; row < IrradianceProjector::kRows; ++row)
    for (const double alpha : {0.0, 0.7, 2.9})
      CHECK(valueOf(field, row, alpha).x == Approx(M_PI * (1.0 + projector.rowY(row)) / 2.0).margin(IrradianceProjector::kError * M_PI / 2.0));
  CHECK(field.mean.x == Approx(M_PI / 2.0).epsilon(1e-6));
}

TEST_CASE("IrradianceField, NearDeltaSkyIsAlmostAClippedCosine") {
  // Nearly all light from within a degree of the sun: E over E at the sun is the cosine of the angle to it, but for the
  // lobe's width, 2 / 120 rad, and the orders that are left out of a kink, 2 / (pi 24^2).
  Sky sky = fixedSky(*findLuminance("cie-5"), 40.0);
  sky.luminance.c = 1e4;
  sky.luminance.d = -120.0;
  const SkyInstant instant(sky, 0.0);
  const IrradianceProjector projector(sky.luminance);
  const IrradianceField field = projector.fieldOf(instant);
  const double most = SkyProjector(sky.luminance, 1, 1e-9).irradiance(instant, instant.sunDirection()).x;
  double worst = 0.0;
  for (int row = 0; row < IrradianceProjector::kRows; ++row)
    for (const double alpha : {0.0, 0.7, 2.9}) {
      const double cosine = std::max(dot(instant.sunDirection(), normalAt(projector.rowY(row), alpha)), 0.0);
      worst = std::max(worst, std::abs(valueOf(field, row, alpha).x / most - cosine));
    }
  CHECK(worst < 0.45);
  CHECK(projector.truncationOf(field) > 0.0);
}

}  // namespace welkin::sky
