// SPDX-License-Identifier: Apache-2.0
// The certificate against direct integration, and on files that are wrong in a known way.
#include "sky/bake/certify.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "baked_day.h"
#include "some_skies.h"

namespace welkin::tests {
namespace {

using bake::Certify;
using det::Number3;
using table::Certificate;
using table::Encoding;

/// By how much the certificate may be off: of an independent dense check of the same file.
constexpr double kOff = 0.05;

/// The file's error at an instant and normals, by definition.
double errorAt(const BakedDay& baked, double time_h, const std::vector<Number3>& normals) {
  const model::SkyProjector direct(baked.day.sky.luminance, 1, 1e-5);
  const model::SkyInstant instant(baked.day.sky, time_h);
  const Number3 ground = instant.groundRadiance(direct.irradiance(instant, {0.0, 1.0, 0.0}));
  const Number3 divisor = divisorOf(instant);
  const WelkinSkySample sample = baked.opened.at(time_h);
  double worst = 0.0;
  for (const Number3& n : normals) {
    const Number3 want =
        det::desaturate(direct.irradiance(instant, n) * instant.intensity() + ground * (M_PI * 0.5 * (1.0 - n.y)),
                        baked.day.sky.ambient_saturation.at(time_h));
    const Number3 off = baked.opened.irradiance(sample, n) - want;
    for (int c = 0; c < 3; ++c) worst = std::max(worst, std::abs(off[c]) / divisor[c]);
  }
  return worst;
}

/// Normals within about `radius` of one.
std::vector<Number3> around(const Number3& normal, double radius) {
  std::vector<Number3> normals;
  for (const double x : {-1.0, -0.5, 0.0, 0.5, 1.0})
    for (const double y : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
      const Number3 side = std::abs(normal.y) < 0.9 ? Number3(normal.z, 0.0, -normal.x) : Number3(1.0, 0.0, 0.0);
      const Number3 n = normal + side * (radius * x) + Number3(0.0, radius * y, radius * (1.0 - std::abs(y)));
      normals.push_back(n / std::sqrt(dot(n, n)));
    }
  return normals;
}

/// Coefficients at every three hours of a day in colours, with a ground and less than full saturation.
model::Sky groundedSky(std::size_t which) {
  model::Sky sky = someSkies()[which].sky;
  sky.ground_albedo = {0.1, 0.2, 0.15};
  sky.ambient_saturation = {1, {3.0, 14.0}, {0.6, 0.9}};
  return sky;
}

}  // namespace

TEST_CASE("Certificate, IsAnIndependentDenseCheck") {
  for (const std::size_t which : {0U, 2U}) {
    const SampledDay day(groundedSky(which), everyHours(2.0));
    const BakedDay baked(day, table::coefficientsOf(day.values, 5, true));
    const Certificate got = baked.certificate(0.1);
    double dense = 0.0;
    for (const double minutes : {-7.0, -3.0, 0.0, 2.0, 5.0})
      dense = std::max(dense, errorAt(baked, got.time_h + minutes / 60.0, around(got.normal, 0.1)));
    for (const double time_h : {3.1, 5.27, 6.15, 7.1, 8.83, 11.05, 13.9, 17.1, 18.22, 18.9, 21.2})
      dense = std::max(dense, errorAt(baked, time_h, evenNormals(6, 8)));
    dense = std::max(dense, errorAt(baked, got.time_h, evenNormals(8, 12)));
    CAPTURE(which, got.max_error, got.time_h, got.normal.y, dense);
    CHECK(got.max_error < dense * (1.0 + kOff));
    CHECK(got.max_error > dense * (1.0 - kOff));
    // And where it says it is.
    CHECK(errorAt(baked, got.time_h, {got.normal}) == Approx(got.max_error).epsilon(0.01));
  }
}

TEST_CASE("Certificate, FastIsFull") {
  model::Sky sky = stillSky(*model::findLuminance("cie-12"), 25.0);
  sky.gradient_sun = {2, 2, {1.0F, 0.5F, 0.3F, 0.7F, 0.6F, 0.5F, 0.3F, 0.4F, 0.9F, 0.2F, 0.4F, 0.9F}};
  const SampledDay day(sky, {0.0, 12.0});
  const BakedDay baked(day, table::coefficientsOf(day.values, 5, false));
  const Certificate fast = baked.certificate(12.0);
  const Certificate full = baked.certificate(12.0, Certify::full);
  CHECK(fast.method == Certificate::Method::fast);
  CHECK(full.method == Certificate::Method::full);
  CHECK(full.instants == fast.instants);
  CHECK(full.max_error >= fast.max_error);
  CHECK(full.max_error < fast.max_error * (1.0 + kOff));
  CHECK(full.mean_error == Approx(fast.mean_error).epsilon(0.2));  // over other normals: those are not evenly spread
}

TEST_CASE("Certificate, FindsOneBrokenNumber") {
  const SampledDay day(someSkies()[0].sky, everyHours(1.0));
  const BakedDay baked(day, table::coefficientsOf(day.values, 5, true));
  const Certificate good = baked.certificate(0.5);
  table::DayTable broken = baked.table;
  constexpr std::size_t kKey = 14;
  broken.number[kKey * broken.numbersOfKey() + 1] *= 3.0;  // green of the mean
  const OpenedTable file(day.sky, broken);
  const Certificate bad = baked.certificate(0.5, Certify::fast, &file);
  CHECK(good.max_error < 0.5);
  CHECK(bad.max_error == Approx(2.0).epsilon(0.2));
  CHECK(bad.time_h == baked.table.key_time_h[kKey]);
  CHECK(bad.channel == 1);
}

TEST_CASE("Certificate, LooksBetweenKeys") {
  // The sun climbs and sinks again, never below the horizon; three modes hold the keys, two of which are alike.
  model::Sky sky = stillSky(*model::findLuminance("cie-12"), 5.0);
  sky.sun.path.key_time_h = {0.0, 12.0};
  sky.sun.path.key_azimuth_rad = {1.0, 1.0};
  sky.sun.path.key_elevation_rad = {0.1, 1.2};
  const SampledDay day(sky, everyHours(6.0));
  const table::ModeSet set = table::DayModes(day.fields, day.grid).best(3);
  const BakedDay baked(day, table::modesOf(day.values, set, table::weightsOf(day.values, set), 25, 25, 3));
  const Certificate c = baked.certificate(24.0);
  CHECK(std::fmod(c.time_h, 6.0) == 3.0);
  CHECK(c.max_error == Approx(errorAt(baked, c.time_h, {c.normal})).epsilon(0.01));
  CHECK(c.parts.time > 0.8 * c.max_error);
}

TEST_CASE("Certificate, SeesTheGround") {
  // A file made for another ground: E differs by the albedo times E_h, at the nadir most.
  model::Sky sky = stillSky(*model::findLuminance("cie-5"), 30.0);
  sky.ground_albedo = det::Number3(0.3);
  const SampledDay day(sky, {0.0, 12.0});
  const BakedDay baked(day, table::coefficientsOf(day.values, 5, false));
  model::Sky other = sky;
  other.ground_albedo = det::Number3(0.2);
  const OpenedTable file(other, baked.table);
  const Certificate right = baked.certificate(6.0);
  const Certificate wrong = baked.certificate(6.0, Certify::fast, &file);
  // E_h = pi, the mean pi/2 + 0.3 pi/2. Five bands of half a sphere: (1 + y) / 2 exactly.
  CHECK(right.max_error < 1e-3);
  CHECK(wrong.max_error == Approx(0.1 * M_PI / (M_PI / 2.0 * 1.3)).epsilon(0.01));
  CHECK(wrong.normal.y < -0.99);
}

TEST_CASE("Certificate, ABlackDayHasNoError") {
  model::Sky sky = someSkies()[0].sky;
  sky.intensity = base::Curve::constant(0.0);
  const SampledDay day(sky, everyHours(6.0));
  const BakedDay baked(day, table::coefficientsOf(day.values, 2, false));
  const Certificate c = baked.certificate(1.0);
  CHECK(c.max_error == 0.0);
  CHECK(c.mean_error == 0.0);
  for (const double part : {c.parts.quadrature, c.parts.truncation, c.parts.time, c.parts.encoding}) CHECK(part == 0.0);
  CHECK(c.instants > 24);
}

}  // namespace welkin::tests
