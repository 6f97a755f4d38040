// SPDX-License-Identifier: Apache-2.0
// Each part of a certificate, on a table that is worse in that one way, against the same computed apart.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>

#include "baked_day.h"
#include "sh/basis.h"
#include "some_skies.h"

namespace welkin::tests {
namespace {

using det::Number3;
using model::SkyInstant;
using table::Certificate;
using table::Encoding;

/// Maxima over other normals.
constexpr double kPartOff = 0.1;

/// A day whose sun and colours change quickly enough for every cause to show; no ground.
const SampledDay& sampledClearDay() {
  static const SampledDay day(someSkies()[0].sky, everyHours(1.0));
  return day;
}

/// Irradiance of radiance coefficients of the sun's frame at a normal of that frame (x across, y up, z along), by
/// the series of its definition: polar axis y, azimuth from z.
Number3 irradianceOf(const std::vector<Number3>& polar, const Number3& n) {
  constexpr double kLobe[] = {M_PI, 2.0 * M_PI / 3.0, M_PI / 4.0, 0.0, -M_PI / 24.0};
  std::vector<double> basis(25);
  static const sh::LatitudeRecurrence kFiveBands(5);
  sh::evaluateBasis(kFiveBands, {n.z, n.x, n.y}, basis);  // polar axis to z, the sun's azimuth to x
  Number3 sum(0.0);
  for (int l = 0; model::polarIndex(l, 0) < polar.size(); ++l)
    for (int m = 0; m <= l; ++m)
      sum += polar[model::polarIndex(l, m)] * (kLobe[l] * basis[static_cast<std::size_t>(sh::indexOf(l, m))]);
  return sum;
}

double largestOver(const std::vector<double>& time_h,
                   const std::function<Number3(const SkyInstant&, const Number3&)>& off) {
  double worst = 0.0;
  for (const double t : time_h) {
    const SkyInstant instant(sampledClearDay().sky, t);
    const Number3 divisor = divisorOf(instant);
    for (const Number3& n : evenNormals(24, 24)) {
      const Number3 e =
          det::desaturate(off(instant, n) * instant.intensity(), sampledClearDay().sky.ambient_saturation.at(t));
      for (int c = 0; c < 3; ++c) worst = std::max(worst, std::abs(e[c]) / divisor[c]);
    }
  }
  return worst;
}

std::vector<Number3> polarAt(const model::SkyProjector& projector, double time_h) {
  return projector.projectPolar(SkyInstant(sampledClearDay().sky, time_h)).radiance_sh;
}

}  // namespace

TEST_CASE("CertificateParts, QuadratureIsTheTolerancesShare") {
  const auto& day = sampledClearDay();
  const BakedDay baked(day, table::coefficientsOf(day.values, 5, false));
  const auto quadrature = [&](double tolerance) {
    return bake::certify(
               baked.opened.sky.get(),
               {day.sky, baked.representation, baked.table, baked.encoding, {tolerance}, table::brightestOf(day.sky)},
               bake::Certify::fast, {}, 12.0)
        .parts.quadrature;
  };
  const model::SkyProjector coarse(day.sky.luminance, 5, 1e-4);
  const model::SkyProjector fine(day.sky.luminance, 5, 1e-12);
  std::vector<double> half_hours;
  for (int i = 0; i < 24; ++i) half_hours.push_back(i + 0.5);
  double time = -1.0;
  std::vector<Number3> difference;
  const double want = largestOver(half_hours, [&](const SkyInstant& instant, const Number3& n) {
    if (time != instant.time_h()) {
      time = instant.time_h();
      difference = polarAt(coarse, time);
      const auto exact = polarAt(fine, time);
      for (std::size_t i = 0; i < exact.size(); ++i) difference[i] = difference[i] - exact[i];
    }
    return irradianceOf(difference, n);
  });
  CHECK(quadrature(1e-4) == Approx(want).epsilon(kPartOff));
  CHECK(quadrature(1e-4) > 2.0 * quadrature(1e-5));
  CHECK(quadrature(1e-9) < 1e-7);
}

TEST_CASE("CertificateParts, TruncationIsWhatBandsLeaveOut") {
  const auto& day = sampledClearDay();
  const BakedDay baked(day, table::coefficientsOf(day.values, 2, false));
  const Certificate c = baked.certificate(1.0);
  const model::SkyProjector projector(day.sky.luminance, 2, 1e-9);
  const model::SkyProjector direct(day.sky.luminance, 1, 1e-5);
  // Near its worst instants only, which the certificate names for all causes together.
  double time = -1.0;
  std::vector<Number3> polar;
  const double want = largestOver({5.0, 6.0, 7.0, c.time_h, 18.0}, [&](const SkyInstant& instant, const Number3& n) {
    if (time != instant.time_h()) {
      time = instant.time_h();
      polar = polarAt(projector, time);
    }
    const double azimuth = std::atan2(n.x, n.z);
    return irradianceOf(polar, n) - direct.irradiance(instant, normalAt(instant, n.y, azimuth));
  });
  CHECK(c.parts.truncation == Approx(want).epsilon(kPartOff));
  const BakedDay finer(day, table::coefficientsOf(day.values, 5, false));
  CHECK(finer.certificate(1.0).parts.truncation < 0.3 * c.parts.truncation);
}

TEST_CASE("CertificateParts, TimeIsWhatLiesBetweenKeys") {
  const SampledDay sparse(someSkies()[0].sky, everyHours(6.0));
  const BakedDay baked(sparse, table::coefficientsOf(sparse.values, 3, false));
  const Certificate c = baked.certificate(1.0);
  const model::SkyProjector projector(sparse.sky.luminance, 3, 1e-9);
  double time = -1.0;
  std::vector<Number3> difference;
  const double want = largestOver(everyHours(1.0), [&](const SkyInstant& instant, const Number3& n) {
    if (time != instant.time_h()) {
      time = instant.time_h();
      const double first = 6.0 * std::floor(time / 6.0);
      const double share = (time - first) / 6.0;
      const auto a = polarAt(projector, first);
      const auto b = polarAt(projector, first + 6.0);
      difference = polarAt(projector, time);
      for (std::size_t i = 0; i < a.size(); ++i) difference[i] = a[i] * (1.0 - share) + b[i] * share - difference[i];
    }
    return irradianceOf(difference, n);
  });
  CHECK(c.parts.time == Approx(want).epsilon(kPartOff));
  const BakedDay denser(sampledClearDay(), table::coefficientsOf(sampledClearDay().values, 3, false));
  CHECK(denser.certificate(1.0).parts.time < 0.5 * c.parts.time);
}

TEST_CASE("CertificateParts, EncodingIsTheDifferenceOfTwoFiles") {
  const auto& day = sampledClearDay();
  for (const Encoding encoding : {Encoding::fixed8, Encoding::fixed16}) {
    const BakedDay baked(day, table::coefficientsOf(day.values, 5, false), encoding);
    const OpenedTable exact(day.sky, baked.table);
    const Certificate c = baked.certificate(1.0);
    double want = 0.0;
    for (const double t : everyHours(0.5)) {
      const Number3 divisor = divisorOf(SkyInstant(day.sky, t));
      const WelkinSkySample rounded = baked.opened.at(t);
      const WelkinSkySample floats = exact.at(t);
      for (const Number3& n : evenNormals(16, 16)) {
        const Number3 off = baked.opened.irradiance(rounded, n) - exact.irradiance(floats, n);
        for (int i = 0; i < 3; ++i) want = std::max(want, std::abs(off[i]) / divisor[i]);
      }
    }
    CHECK(c.parts.encoding == Approx(want).epsilon(kPartOff));
    CHECK(c.parts.encoding > 0.0);
  }
}

TEST_CASE("CertificateParts, TheReferencesOwnErrorIsSmallButForNarrowLobes") {
  model::Sky narrow = stillSky(*model::findLuminance("cie-12"), 25.0);
  narrow.luminance.c = 1e4;
  narrow.luminance.d = -120.0;
  for (const bool is_narrow : {false, true}) {
    const SampledDay day(is_narrow ? narrow : someSkies()[1].sky, everyHours(12.0));
    const BakedDay baked(day, table::coefficientsOf(day.values, 2, false));
    const double error = baked.certificate(2.0).reference_error;
    CAPTURE(is_narrow, error);
    CHECK(error > (is_narrow ? 5e-3 : model::IrradianceProjector::kError / 2.0));
    CHECK(error < (is_narrow ? 0.2 : 3.0 * model::IrradianceProjector::kError));
  }
}

}  // namespace welkin::tests
