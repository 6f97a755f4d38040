// SPDX-License-Identifier: Apache-2.0
// The reflected lobe against closed forms, and the filter against closed forms and a slow integral of the radiance.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "sh/spiral.h"
#include "sky/model/luminance.h"
#include "sky/reflection/lobe.h"
#include "sky/reflection/lobe_reference.h"
#include "sky/reflection/prefilter.h"
#include "tests/sky/some_skies.h"

namespace welkin::tests {

using det::Number3;
using reflection::CubePyramid;
using reflection::Prefilter;
using reflection::Radiance;

namespace {

constexpr double kGlosses[] = {0.0, 0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 1.0};

/// Largest difference between two radiances, over the largest component of the second.
double offBy(const Number3& value, const Number3& truth) {
  double difference = 0.0, largest = 0.0;
  for (int c = 0; c < 3; ++c) {
    difference = std::max(difference, std::abs(value[c] - truth[c]));
    largest = std::max(largest, std::abs(truth[c]));
  }
  return difference > 0.0 ? difference / largest : 0.0;
}

/// The integral of w over cosines from `from` to 1, in closed form.
double lobeIntegralFrom(double power, double from) {
  const double p = 0.5 * power, x = 0.5 + 0.5 * from;
  const auto part = [&](double q) { return (1.0 - std::pow(x, q)) / q; };
  return 2.0 * det::kTwoPi * (2.0 * part(p + 2.0) - part(p + 1.0));
}

/// Laplacian of the lobe on the sphere.
double laplacianOf(double power, double cosine) {
  const reflection::LobeSlopes w = reflection::lobeSlopes(power, cosine);
  return (1.0 - cosine * cosine) * w.second - 2.0 * cosine * w.first;
}

/// Axes that a filter could get wrong: faces' middles, edges, corners, beside them, and some others.
std::vector<Number3> someAxes() {
  std::vector<Number3> axes;
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z)
        if (x != 0 || y != 0 || z != 0) {
          const Number3 d(x, y, z), beside = d + Number3(0.01, -0.02, 0.013);
          axes.push_back(d / std::sqrt(dot(d, d)));
          axes.push_back(beside / std::sqrt(dot(beside, beside)));
        }
  for (int i = 0; i < 20; ++i) axes.push_back(sh::onSpiral(1.0 - (2 * i + 1.0) / 20, i));
  return axes;
}

/// Smooth, in colours and without symmetry, with a step at the horizon.
Number3 unevenLight(const Number3& d) {
  const double height = d.y > 0.0 ? 1.0 : 0.2;
  return {height * (1.5 + d.x + 0.3 * d.x * d.z), height * (1.2 - 0.7 * d.z + 0.4 * d.y * d.x),
          height * std::exp(d.x - 0.5 * d.z)};
}

}  // namespace

TEST_CASE("ReflectedLobe, IsBlinnPhongTimesTheCosine") {
  for (const double gloss : kGlosses) {
    const double m = det::powerOfGloss(gloss);
    for (double angle = 0.0; angle < 1.6; angle += 0.1) {
      const Number3 n(0, 1, 0), l(std::sin(angle), std::cos(angle), 0);
      const double expected =
          det::blinnPhong(m, dot(n, det::halfVector(l, n))) / det::blinnPhong(m, 1.0) * std::max(dot(n, l), 0.0);
      REQUIRE(reflection::lobeWeight(m, std::cos(angle)) == Approx(expected).epsilon(1e-9).margin(1e-300));
    }
    CHECK(reflection::lobeWeight(m, -0.5) == 0.0);
    CHECK(reflection::lobeIntegral(m) == Approx(lobeIntegralFrom(m, 0.0)).epsilon(1e-12));
  }
}

TEST_CASE("ReflectedLobe, IntegralAndSlopesAreTheWeights") {
  for (const double gloss : kGlosses) {
    const double m = det::powerOfGloss(gloss), width = std::min(reflection::lobeWidth(m), 0.5);
    double sum = 0.0;  // Simpson's rule out to where w is below 1e-30
    const double end = std::min(det::kHalfPi, 12.0 * width);
    constexpr int kIntervals = 4000;
    for (int i = 0; i <= kIntervals; ++i) {
      const double angle = end * i / kIntervals;
      const double simpson = i == 0 || i == kIntervals ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
      sum += simpson / 3.0 * reflection::lobeWeight(m, std::cos(angle)) * std::sin(angle) * det::kTwoPi;
    }
    CHECK(sum * end / kIntervals == Approx(reflection::lobeIntegral(m)).epsilon(1e-8));
    // By differences: laplacian = (sin t w')'/sin t. They are good to 1e-4 of the value on the axis.
    const double step = 1e-3 * width, scale = std::abs(laplacianOf(m, 1.0));
    const auto w = [&](double t) { return reflection::lobeWeight(m, std::cos(t)); };
    for (const double angle : {0.3 * width, width, 2.0 * width}) {
      const double by_differences = ((w(angle + step) - w(angle)) * std::sin(angle + 0.5 * step) -
                                     (w(angle) - w(angle - step)) * std::sin(angle - 0.5 * step)) /
                                    (step * step * std::sin(angle));
      CHECK(std::abs(laplacianOf(m, std::cos(angle)) - by_differences) < 1e-4 * scale);
    }
  }
}

TEST_CASE("ReflectedLobe, GlossFallsEvenlyToZero") {
  CHECK(reflection::mipsOfSize(1) == 1);
  CHECK(reflection::mipsOfSize(256) == 9);
  CHECK(reflection::mipsOfSize(12) == 4);
  for (const int mips : {2, 4, 9}) {
    CHECK(reflection::glossOfMip(0, mips) == 1.0);
    CHECK(reflection::glossOfMip(mips - 1, mips) == 0.0);
  }
  CHECK(reflection::glossOfMip(3, 9) == 0.625);
}

TEST_CASE("CubePyramid, SolidAnglesFillTheSphereAndMeansKeepTheLight") {
  const CubePyramid pyramid(64, unevenLight);
  REQUIRE(pyramid.levels().size() == 6);
  std::array<double, 3> light{};
  for (const reflection::CubeLevel& level : pyramid.levels()) {
    double sphere = 0.0;
    std::array<double, 3> sum{};
    const std::size_t texels = level.solid_angle.size();
    for (std::size_t i = 0; i < 6 * texels; ++i) {
      sphere += level.solid_angle[i % texels];
      for (std::size_t c = 0; c < 3; ++c) sum[c] += level.solid_angle[i % texels] * double{level.rgb[3 * i + c]};
    }
    CHECK(sphere == Approx(4.0 * det::kPi).epsilon(1e-12));
    if (light[0] == 0.0) light = sum;
    for (std::size_t c = 0; c < 3; ++c) CHECK(sum[c] == Approx(light[c]).epsilon(1e-6));  // means are floats
  }
}

TEST_CASE("Prefilter, ConstantLightStaysConstant") {
  const CubePyramid pyramid(reflection::kSourceSize, [](const Number3&) { return Number3(0.25, 1.0, 65504.0); });
  for (const double gloss : kGlosses) {
    const Prefilter filter(pyramid, det::powerOfGloss(gloss));
    for (const Number3& axis : someAxes()) REQUIRE(offBy(filter.at(axis), {0.25, 1.0, 65504.0}) < 1e-12);
  }
}

TEST_CASE("Prefilter, LinearLightHasItsClosedForm") {
  // Light 1 + k.l comes out as 1 + share k.r, where share is the lobe's mean cosine, 1 - 8/3 (...) by parts.
  const Number3 k(0.3, -0.5, 0.7);
  const CubePyramid pyramid(reflection::kSourceSize, [&](const Number3& l) { return Number3(1.0 + dot(k, l)); });
  for (const double gloss : kGlosses) {
    const double m = det::powerOfGloss(gloss), p = 0.5 * m;
    // cosine = 2 x - 1 with x from 1/2 to 1, so the integral of w cosine is that of x^p (2 x - 1)^2.
    const auto part = [](double q) { return (1.0 - std::pow(2.0, -q)) / q; };
    const double share =
        2.0 * det::kTwoPi * (4.0 * part(p + 3.0) - 4.0 * part(p + 2.0) + part(p + 1.0)) / reflection::lobeIntegral(m);
    const Prefilter filter(pyramid, m);
    double worst = 0.0;
    for (const Number3& axis : someAxes())
      worst = std::max(worst, std::abs(filter.at(axis).x - (1.0 + share * dot(k, axis))));
    CAPTURE(gloss, share, worst);
    CHECK(worst < 3e-4);
  }
}

TEST_CASE("Prefilter, ACapHasTheLobesClosedForm") {
  // Light from a cap about the axis, as wide as the lobe's core: the lobe's integral over it. The cap's edge runs
  // through texels of the source, which costs most where the cap is nine texels wide.
  for (const double gloss : {0.25, 0.5, 0.75, 1.0}) {
    const double allowed = gloss == 1.0 ? 2e-2 : 3e-3;
    const double m = det::powerOfGloss(gloss), edge = std::cos(1.5 * reflection::lobeWidth(m));
    for (const Number3& axis : {sh::onSpiral(0.31, 5), Number3(0, 1, 0), sh::onSpiral(-0.6, 2)}) {
      const CubePyramid pyramid(reflection::kSourceSize,
                                [&](const Number3& l) { return Number3(dot(l, axis) > edge ? 1.0 : 0.0); });
      const double expected = lobeIntegralFrom(m, edge) / reflection::lobeIntegral(m);
      const double value = Prefilter(pyramid, m).at(axis).x;
      CAPTURE(gloss, value, expected);
      CHECK(std::abs(value - expected) < allowed);
    }
  }
}

TEST_CASE("Prefilter, ASmallSourceShowsTheLobe") {
  // A bump of light, a quarter as wide as the lobe: seen from any axis it is the lobe about the source plus half the
  // bump's variance times the Laplacian. The next order, 1/8 (1/4)^4 of the lobe's fourth derivative, is 0.4 %.
  const Number3 source = sh::onSpiral(0.4, 3);
  const Number3 across = [&] {
    const Number3 up(0, 1, 0), part = up - source * dot(source, up);
    return part / std::sqrt(dot(part, part));
  }();
  for (const double gloss : {0.25, 0.5, 0.75}) {
    const double m = det::powerOfGloss(gloss), width = reflection::lobeWidth(m), narrow = 0.25 * width;
    const CubePyramid pyramid(reflection::kSourceSize, [&](const Number3& l) {
      const Number3 d = l - source;
      return Number3(std::exp(-0.5 * dot(d, d) / (narrow * narrow)));
    });
    const double light = det::kTwoPi * narrow * narrow / reflection::lobeIntegral(m);
    const Prefilter filter(pyramid, m);
    double worst = 0.0;
    for (double angle = 0.0; angle < std::min(3.0 * width, 1.4); angle += 0.25 * width) {
      const double cosine = std::cos(angle);
      const double expected =
          light * (reflection::lobeWeight(m, cosine) + 0.5 * narrow * narrow * laplacianOf(m, cosine));
      worst = std::max(worst, std::abs(filter.at(source * cosine + across * std::sin(angle)).x - expected) / light);
    }
    CAPTURE(gloss, worst);
    CHECK(worst < 7e-3);
  }
}

TEST_CASE("LobeReference, AgreesWithAPlainGridOfTheSphere") {
  for (const double power : {1.0, 90.5})
    for (const Number3& axis : {sh::onSpiral(0.05, 4), sh::onSpiral(-0.5, 7), Number3(0, 1, 0), Number3(1, 0, 0)}) {
      Number3 sum(0.0);
      double total = 0.0;
      constexpr int kRows = 1000, kColumns = 1000;  // rows end at the horizon
      for (int row = 0; row < kRows; ++row)
        for (int column = 0; column < kColumns; ++column) {
          const double y = 1.0 - 2.0 * (row + 0.5) / kRows, length = std::sqrt(1.0 - y * y);
          const double turn = det::kTwoPi * (column + 0.5) / kColumns;
          const Number3 d(length * std::cos(turn), y, length * std::sin(turn));
          const double cosine = dot(d, axis);
          if (cosine <= 0.0) continue;
          const double weight = std::pow(0.5 + 0.5 * cosine, 0.5 * power) * cosine;
          sum += unevenLight(d) * weight;
          total += weight;
        }
      CHECK(offBy(reflection::lobeReference(unevenLight, power, axis), sum / total) < 1e-5);
    }
}

TEST_CASE("Prefilter, UnevenLightIsTheReferences") {
  const CubePyramid pyramid(reflection::kSourceSize, unevenLight);
  for (const double gloss : kGlosses) {
    const double m = det::powerOfGloss(gloss);
    const Prefilter filter(pyramid, m);
    double worst = 0.0;
    for (const Number3& axis : someAxes())
      worst = std::max(worst, offBy(filter.at(axis), reflection::lobeReference(unevenLight, m, axis)));
    CAPTURE(gloss, worst);
    CHECK(worst < 2e-3);
  }
}

TEST_CASE("Prefilter, EverySkyIsWithinItsStatedError") {
  // docs/export.md states 0.2 % of the largest component.
  for (const NamedSky& named : someSkies()) {
    constexpr double time_h = 7.0;  // a low sun, whose glow is sharp, and dark ground
    const model::SkyInstant instant(named.sky, time_h);
    const Number3 ground = instant.radiance(Number3(0, 1, 0), Number3(0.0)) * 0.1;
    const Radiance dome = [&](const Number3& d) { return instant.radiance(d, ground); };
    const CubePyramid pyramid(reflection::kSourceSize, dome);
    for (const double gloss : {0.0, 0.25, 0.5, 0.75, 1.0}) {
      const double m = det::powerOfGloss(gloss);
      const Prefilter filter(pyramid, m);
      double worst = 0.0;
      for (int i = 0; i < 12; ++i) {
        const Number3 axis = sh::onSpiral(0.9 - 0.15 * i, i);
        worst = std::max(worst, offBy(filter.at(axis), reflection::lobeReference(dome, m, axis)));
      }
      CAPTURE(named.name, time_h, gloss, worst);
      CHECK(worst < 2e-3);
    }
  }
}

TEST_CASE("Prefilter, KeepsTheMeanOfTheLight") {
  // Each direction of light counts as much as any other, so the mean over all axes stays. 2000 axes of a spiral know
  // the mean of so smooth a function to 1e-4.
  const CubePyramid pyramid(64, unevenLight);
  Number3 mean(0.0);
  const reflection::CubeLevel& level = pyramid.levels()[0];
  for (std::size_t i = 0; i < level.rgb.size() / 3; ++i)
    for (int c = 0; c < 3; ++c)
      mean[c] += level.solid_angle[i % level.solid_angle.size()] *
                 double{level.rgb[3 * i + static_cast<std::size_t>(c)]} / (4.0 * det::kPi);
  for (const double power : {1.0, 16.0}) {
    const Prefilter filter(pyramid, power);
    Number3 filtered(0.0);
    constexpr int kAxes = 2000;
    for (int i = 0; i < kAxes; ++i) filtered += filter.at(sh::onSpiral(1.0 - (2 * i + 1.0) / kAxes, i)) / double{kAxes};
    CAPTURE(power, offBy(filtered, mean));
    CHECK(offBy(filtered, mean) < 5e-4);
  }
}

}  // namespace welkin::tests
