// SPDX-License-Identifier: Apache-2.0
// The reference against closed forms of the sky, the sun and the ground beyond the level.
#include <catch2/catch.hpp>

#include "probes/geometry/directions.h"
#include "probes/transfer/transfer_basis.h"
#include "skies.h"
#include "sky/model/projection.h"
#include "tests/probes/closed_forms/closed_forms.h"
#include "tests/sky/some_skies.h"

namespace welkin::tests {

using f64::Number3;
namespace {

const std::vector<Number3> kTiltedNormals = {
    {0, 1, 0}, {0, -1, 0}, {1, 0, 0}, geometry::unit({0.3, 0.5, -0.7}), geometry::unit({-0.2, -0.6, 0.4})};
const Number3 kColoured(0.2, 0.5, 0.9);

/// Height of a point above ground without walls. Rays to the horizon that miss the ground see black below it.
constexpr double kOver_m = 0.1;
constexpr double kMissedGround = 2.0 * kOver_m / kEndless_m;

reference::ReferenceIrradiance irradianceAt(const geometry::Surfaces& level, const model::Sky& sky,
                                            const Number3& position, const Number3& normal, int bounces = 2,
                                            std::size_t samples = 16384) {
  const geometry::Tracer tracer(level);
  return reference::traceReference(tracer, reference::DistantLight(sky, 12.0), {}, position, normal,
                                   {samples, bounces, 1});
}

std::vector<Number3> normalsAndBasis() {
  std::vector<Number3> normals = kTiltedNormals;
  for (const Number3& direction : transfer::transferBasis()) normals.push_back(direction);
  return normals;
}

}  // namespace

TEST_CASE("Reference, APlaneUnderAUniformSkyHasItsClosedForm") {
  const double radiance = 1.7;
  for (const Number3& albedo : {kColoured, Number3(1.0)})
    for (const Number3& n : normalsAndBasis()) {
      const Number3 expected = (Number3(0.5 * (1.0 + n.y)) + albedo * (0.5 * (1.0 - n.y))) * (radiance * det::kPi);
      const auto e = irradianceAt(groundOf(albedo, kEndless_m), uniformSky(radiance), {0, kOver_m, 0}, n);
      checkEstimate(e.sky, expected, radiance * kMissedGround);
      CHECK(e.sun_bounce.value == Number3(0.0));
      CHECK(e.local.value == Number3(0.0));
      model::Sky beyond = uniformSky(radiance);
      beyond.ground_albedo = albedo;
      checkEstimate(irradianceAt({}, beyond, {0, 1, 0}, n).sky, expected);
    }
  const Number3 basis = transfer::transferBasis()[1];
  const auto e = irradianceAt(groundOf(Number3(0.2)), uniformSky(1.0), {0, 0.01, 0}, basis, 2, 65536);
  CHECK(e.sky.value.x / det::kPi == Approx(0.83094).margin(5e-4));
}

TEST_CASE("Reference, APlaneUnderTheSunHasItsClosedForm") {
  for (const double elevation : {0.02, 0.4, 1.1, 1.5})
    for (const Number3& n : normalsAndBasis()) {
      model::Sky sky = sunOnly(3.0, 2.1, elevation);
      const Number3 expected = kColoured * (3.0 * std::sin(elevation) * 0.5 * (1.0 - n.y));
      const auto e = irradianceAt(groundOf(kColoured, kEndless_m), sky, {0, kOver_m, 0}, n);
      checkEstimate(e.sun_bounce, expected, 3.0 * kMissedGround);
      CHECK(e.sky.value == Number3(0.0));
      sky.ground_albedo = kColoured;
      const auto beyond = irradianceAt({}, sky, {0, 1, 0}, n);
      checkEstimate(beyond.sun_bounce, expected);
      CHECK(beyond.sky.value == Number3(0.0));
    }
}

TEST_CASE("Reference, AMoonLightsLikeASunAndALightBelowTheHorizonDoesNot") {
  model::Sky sky = sunOnly(3.0, 2.1, -0.3);
  sky.moon = sunOnly(0.5, 1.0, 0.6).sun;
  sky.moon->colour = base::Curve::constant(Number3(0.5, 0.6, 1.0));
  const Number3 moon = sky.moon->normalIrradianceAt(12.0);
  const auto e = irradianceAt(groundOf(kColoured), sky, {0, 0.01, 0}, {0, -1, 0});
  checkEstimate(e.sun_bounce, kColoured * moon * std::sin(0.6));
  // Only a wall that faces the sun below the horizon.
  geometry::Surfaces wall;
  addQuad(wall, {-50, -50, 0}, {100, 0, 0}, {0, 100, 0}, addMaterial(wall, Number3(1.0), true));
  CHECK(irradianceAt(wall, sunOnly(3.0, 0.0, -0.3), {0, 0, -5}, {0, 0, 1}).total.value == Number3(0.0));
  CHECK(irradianceAt(wall, sunOnly(3.0, 0.0, 0.3), {0, 0, -5}, {0, 0, 1}).total.value.x > 0.5);
}

TEST_CASE("Reference, TheGroundBeyondTheLevelIsOneOfTheBounces") {
  model::Sky sky = clearSky(1.0, 0.6);
  sky.ground_albedo = kColoured;
  const Number3 down(0, -1, 0);
  CHECK(irradianceAt({}, sky, {0, 1, 0}, down, 0).total.value == Number3(0.0));
  const auto once = irradianceAt({}, sky, {0, 1, 0}, down, 1);
  CHECK(once.sky.value.x > 0.0);
  CHECK(once.total.value == irradianceAt({}, sky, {0, 1, 0}, down, 2).total.value);
}

TEST_CASE("Reference, BlackWallsLeaveTheSkyViewFactor") {
  const Number3 black(0.0);
  const Number3 up(0, 1, 0);
  const auto view = [&](const geometry::Surfaces& level) {
    return irradianceAt(level, uniformSky(2.0), {0, 0, 0}, up).sky;
  };
  const auto check = [&](const geometry::Surfaces& level, double factor) {
    checkEstimate(view(level), Number3(2.0 * det::kPi * factor), 2.0 * det::kPi * 1e-6);
  };
  for (const double g : {0.3, 0.8, 1.3}) check(wallTo(g, black, black), skyViewOfWall(g));
  for (const double h : {2.0, 8.0, 20.0}) check(canyonOf(8.0, h, black, black), skyViewOfCanyon(8.0, h));
  for (const double h : {1.0, 2.0, 4.0})
    for (const int sides : {4, 256}) check(wellOf(1.0, h, sides, black, black), skyViewOfWell(1.0, h, sides));
}

TEST_CASE("Reference, TheOvercastSkyHasItsClosedForm") {
  model::Sky sky = uniformSky(2.0);
  sky.luminance = *model::findLuminance("cie-overcast");
  checkEstimate(irradianceAt({}, sky, {0, 0, 0}, {0, 1, 0}).sky, Number3(2.0 * det::kPi * 7.0 / 9.0));
  const double ratio = (det::kPi / 6.0 + 4.0 / 9.0) / (det::kPi * 7.0 / 9.0);
  CHECK(ratio == Approx(0.39618).margin(5e-6));
  checkEstimate(irradianceAt({}, sky, {0, 0, 0}, {1, 0, 0}).sky, Number3(2.0 * ratio * det::kPi * 7.0 / 9.0));
}

TEST_CASE("Reference, SeesTheSkyAsTheQuadratureDoes") {
  std::vector<NamedSky> skies = someSkies();
  model::Sky peaked = clearSky(1.2, 0.5);
  peaked.luminance = {-1.0, -0.3, 2000.0, -40.0, 0.3, 0.0};  // a lobe of 1.5 degrees
  skies.push_back({"peaked", peaked, {12.0}});
  const geometry::Surfaces nothing;
  const geometry::Tracer empty(nothing);
  for (const auto& named : skies)
    for (const double time_h : {7.0, 12.0, 17.5}) {
      INFO(named.name << " at " << time_h << " h");
      const model::SkyInstant instant(named.sky, time_h);
      const model::SkyProjector projector(named.sky.luminance, 1, 1e-9);
      const double horizontal = projector.irradiance(instant, {0, 1, 0}).y * instant.intensity();
      for (const Number3& n : kTiltedNormals) {
        const auto e = reference::traceReference(empty, reference::DistantLight(named.sky, time_h), {}, {0, 0, 0}, n,
                                                 {16384, 0, 1});
        checkEstimate(e.sky, projector.irradiance(instant, n) * instant.intensity(), 1e-8);
        CHECK(e.sky.standard_error.y <= 0.012 * std::max(horizontal, e.sky.value.y));
      }
    }
}

TEST_CASE("Reference, TheSkyLosesItsColourBeforeItBounces") {
  model::Sky sky = uniformSky(1.0);
  const Number3 blue(0.3, 0.5, 1.0);
  sky.gradient_sun = sky.gradient_anti = model::Gradient::constant(blue);
  sky.ambient_saturation = base::Curve::constant(0.4);
  const Number3 colour = blue / det::luminanceOf(blue);
  const Number3 seen = Number3(1.0) + (colour - Number3(1.0)) * 0.4;
  const Number3 n = geometry::unit({0.6, -0.3, 0.2});
  const Number3 expected = seen * (Number3(0.5 * (1.0 + n.y)) + kColoured * (0.5 * (1.0 - n.y))) * det::kPi;
  constexpr double kFloatGradient = 1e-6;
  checkEstimate(irradianceAt(groundOf(kColoured, kEndless_m), sky, {0, kOver_m, 0}, n).sky, expected,
                2.0 * kMissedGround + kFloatGradient);
  sky.ground_albedo = kColoured;
  checkEstimate(irradianceAt({}, sky, {0, 1, 0}, n).sky, expected, kFloatGradient);
}

}  // namespace welkin::tests
