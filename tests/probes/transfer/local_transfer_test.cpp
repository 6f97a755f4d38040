// SPDX-License-Identifier: Apache-2.0
// Local transfer against closed forms and the reference.
#include <catch2/catch.hpp>
#include <cmath>

#include "local_helpers.h"
#include "probes/geometry/directions.h"
#include "tests/probes/closed_forms/closed_forms.h"
#include "tests/probes/skies.h"

namespace welkin::tests {

using f64::Number3;
namespace {

const Number3 kWallAlbedo(0.2, 0.5, 0.9);

/// Coefficient 0 of a radiance that is the same from everywhere.
double coefficientOf(double radiance) {
  return radiance * 4.0 * det::kPi * det::kShConstant;
}

}  // namespace

TEST_CASE("LocalTransfer, ALightInASphereHasItsClosedForm") {
  constexpr double kRadius_m = 3.0;
  const geometry::Surfaces sphere = sphereInside(kRadius_m, 5, kWallAlbedo);
  const double roughness = roughnessOf(sphere, kRadius_m);
  CHECK(roughness < 4e-4);
  const geometry::Tracer tracer(sphere);
  const Number3 probe(0.7, 1.2, -0.9);
  const double wall = 1.0 / (kRadius_m * kRadius_m);  // mean irradiance
  for (const int n : {1, 2, 5}) {
    const transfer::LocalTransferTracer local(tracer, {512, n, 4}, {{0, 0, 0}});
    for (int c = 0; c < 3; ++c) {
      const double expected = coefficientOf(wall / det::kPi * bounces(kWallAlbedo, 1, n)[c]);
      const double bound = 3.0 * roughness * expected;
      checkMeasured(measured(local, probe, 20, [&](const transfer::LocalProbe& p) { return of(p, 0).radiance[0][c]; }),
                    expected, bound);
      for (std::size_t k = 1; k < 4; ++k)
        checkMeasured(
            measured(local, probe, 20, [&](const transfer::LocalProbe& p) { return of(p, 0).radiance[k][c]; }), 0.0,
            bound);
    }
  }
  // Wherever the light is, radiance after the first bounce is the same from everywhere.
  const std::vector<Number3> aside = {{1.1, -0.4, 0.6}, {-2.0, 0.5, 0.1}};
  const transfer::LocalTransferTracer one(tracer, {1024, 1, 4}, aside);
  const transfer::LocalTransferTracer five(tracer, {1024, 5, 4}, aside);
  for (const std::uint32_t light : {0U, 1U})
    for (int c = 0; c < 3; ++c) {
      const double expected = coefficientOf(wall / det::kPi * bounces(kWallAlbedo, 2, 5)[c]);
      for (std::size_t k = 0; k < 4; ++k) {
        const auto part = [&](const transfer::LocalProbe& p) { return of(p, light).radiance[k][c]; };
        const Measured all = measured(five, probe, 10, part);
        const Measured first = measured(one, probe, 10, part);
        checkMeasured({all.mean - first.mean, std::hypot(all.standard_error, first.standard_error)},
                      k == 0 ? expected : 0.0, 3.0 * roughness * expected);
      }
    }
}

TEST_CASE("LocalTransfer, ALightOverAPlaneSeesItsOwnReflection") {
  // Radiance is rho cos^3 / (pi h^2) at an angle from straight down. Its integral is pi / 2, and 2 pi / 5 with the
  // cosine.
  const geometry::Surfaces ground = groundOf(kWallAlbedo, 100.0);
  const geometry::Tracer tracer(ground);
  for (const auto& [height, rays] : {std::pair{0.5, 1024U}, {2.0, 1024U}, {2.0, 5000U}}) {  // whole blocks and a part
    const Number3 at(1, height, -2);
    const transfer::LocalTransferTracer local(tracer, {rays, 2, 8}, {at});
    const double by = kWallAlbedo.z / (height * height);
    checkMeasured(measured(local, at, 20, [](const transfer::LocalProbe& p) { return of(p, 0).radiance[0].z; }),
                  det::kShConstant * by / 2.0, 1e-5 * by);
    checkMeasured(measured(local, at, 20, [](const transfer::LocalProbe& p) { return of(p, 0).radiance[1].z; }),
                  -det::kShLinear * by * 0.4, 1e-5 * by);
    for (const std::size_t k : {2U, 3U})
      checkMeasured(measured(local, at, 20, [&](const transfer::LocalProbe& p) { return of(p, 0).radiance[k].z; }), 0.0,
                    1e-5 * by);
  }
}

TEST_CASE("LocalTransfer, NearSurfacesAreLitAsFromTheNearestDistance") {
  // As above, but radiance is rho cos / (pi n^2) nearer than n, within the angle whose cosine is h / n.
  const geometry::Surfaces ground = groundOf(kWallAlbedo, 100.0);
  const geometry::Tracer tracer(ground);
  const Number3 at(1, 0.5, -2);
  for (const double nearest : {0.4, 1.0, 3.0}) {
    transfer::LocalSettings settings{1024, 2, 8};
    settings.nearest_m = nearest;
    const transfer::LocalTransferTracer local(tracer, settings, {at});
    const double edge = std::min(0.5 / nearest, 1.0);
    const double within = (1.0 - edge * edge) / (2.0 * nearest * nearest);
    const double beyond = std::pow(edge, 4) / (4.0 * 0.25);
    const double expected = det::kShConstant * 2.0 * kWallAlbedo.z * (within + beyond);
    checkMeasured(measured(local, at, 20, [](const transfer::LocalProbe& p) { return of(p, 0).radiance[0].z; }),
                  expected, 1e-5 * expected);
  }
}

TEST_CASE("LocalTransfer, TwoBandsAreTheReferences") {
  // The difference of irradiance between opposite directions has band 1 alone. The mean over an icosahedron's twelve
  // directions has band 0 and, at most a hundredth, bands 6 and up.
  const geometry::Surfaces room = furnishedRoom();
  const geometry::Tracer tracer(room);
  const std::vector<Number3> lights = {{-3, 3, 1}, {3, 1, -2}, {0, 1, 3}, {-1, 1, -3.2}};
  const Number3 probe(-1.5, 1.5, 0.5);
  const transfer::LocalTransferTracer local(tracer, {1024, 2, 2}, lights);
  const double golden = 0.5 * (1.0 + std::sqrt(5.0));
  for (std::uint32_t l = 0; l < lights.size(); ++l) {
    const reference::LocalLight light[] = {{lights[l], Number3(1.0)}};
    const auto reference = [&](const Number3& normal, std::uint64_t seed) {
      return reference::traceReference(tracer, darkness(), light, probe, normal, {8192, 2, seed}).local;
    };
    Number3 sum(0.0);
    Number3 squares(0.0);
    std::uint64_t seed = 1;
    for (const double a : {-1.0, 1.0})
      for (const double b : {-golden, golden})
        for (const Number3& v : {Number3(0, a, b), Number3(a, b, 0), Number3(b, 0, a)}) {
          const reference::Estimate e = reference(geometry::unit(v), seed++);
          sum += e.value;
          squares += e.standard_error * e.standard_error;
        }
    for (const int c : {0, 2}) {
      CAPTURE(l, c);
      const Measured mean = measured(local, probe, 20, [&](const transfer::LocalProbe& p) {
        return det::kPi * det::kShConstant * of(p, l).radiance[0][c];
      });
      checkMeasured({mean.mean - sum[c] / 12.0, std::hypot(mean.standard_error, std::sqrt(squares[c]) / 12.0)}, 0.0,
                    0.01 * mean.mean);
    }
    for (const auto& [normal, k] : {std::pair{Number3(0, 1, 0), 1}, {Number3(0, 0, 1), 2}, {Number3(1, 0, 0), 3}}) {
      const reference::Estimate a = reference(normal, seed++);
      const reference::Estimate b = reference(-normal, seed++);
      const double lobe = 2.0 * det::cosineLobe(1) * det::kShLinear;
      const Measured m =
          measured(local, probe, 20, [&, k = static_cast<std::size_t>(k)](const transfer::LocalProbe& p) {
            return lobe * of(p, l).radiance[k].x;
          });
      CAPTURE(l, k);
      checkMeasured({m.mean - (a.value.x - b.value.x),
                     std::hypot(m.standard_error, std::hypot(a.standard_error.x, b.standard_error.x))},
                    0.0);
    }
  }
}

}  // namespace welkin::tests
