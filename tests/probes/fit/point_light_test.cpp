// SPDX-License-Identifier: Apache-2.0
#include "probes/fit/point_light.h"

#include <catch2/catch.hpp>

#include "fit_level.h"

namespace welkin::tests {
namespace {

const std::vector<Number3> kLights = {geometry::unit({1, 0.5, 0.3}), geometry::unit({-0.4, 1.2, 0.1}),
                                      geometry::unit({-1, 0.3, 0.8})};

transfer::TransferSettings settingsOf(int bounces = 2) {
  transfer::TransferSettings settings;
  settings.bounces = bounces;
  settings.ground_albedo = Number3(0.2, 0.1, 0.3);
  settings.light_directions = kLights;
  return settings;
}

}  // namespace

TEST_CASE("PointLight, InTheOpenItHasNoNoise") {
  const geometry::Surfaces ground = groundOf(Number3(0.2, 0.1, 0.3), 1e5);
  const geometry::Tracer tracer(ground);
  const auto settings = settingsOf(0);
  const fit::TrainingSkies skies(kLights);
  const fit::PointTracer points(tracer, settings, skies);
  for (const Number3& normal : {Number3(0, 1, 0), geometry::unit(Number3(0.3, 0.8, -0.5))}) {
    const fit::PointLight few = points.trace({{3, 0.5, 4}, normal}, 7, 16);
    const std::vector<double> want = skies.irradiance(normal);
    // Rays towards the ground find nothing without bounces, and all rays towards the sky are open.
    for (std::size_t l = 0; l < skies.count(); ++l) CHECK(few.sky[l].x == Approx(want[l]).epsilon(1e-12));
    for (const Number3& e : few.sun) CHECK(e == Number3(0.0));
  }
}

TEST_CASE("PointLight, BeyondTheLevelTheGroundHasItsClosedForm") {
  geometry::Surfaces tile;  // a tile far away, so that all rays leave the level
  addQuad(tile, {1000, 0, 1000}, {0, 0, 1}, {1, 0, 0}, addMaterial(tile, Number3(0.5)));
  const geometry::Tracer tracer(tile);
  const auto settings = settingsOf();
  const fit::TrainingSkies skies(kLights);
  const Number3 normal = geometry::unit({0.6, -0.5, 0.2});
  const fit::PointLight light = fit::PointTracer(tracer, settings, skies).trace({{3, 5, 4}, normal}, 1, 64);
  const double below = (1.0 - normal.y) / 2.0;
  const std::vector<double> open = skies.irradiance(normal);
  for (int c = 0; c < 3; ++c) {
    for (std::size_t l = 0; l < skies.count(); ++l)
      CHECK(light.sky[l][c] == Approx(open[l] + below * settings.ground_albedo[c]).epsilon(1e-12));
    for (std::size_t i = 0; i < kLights.size(); ++i)
      CHECK(light.sun[i][c] == Approx(below * settings.ground_albedo[c] * kLights[i].y).epsilon(1e-12));
  }
}

TEST_CASE("PointLight, InAClosedBoxItIsExactlyDark") {
  const geometry::Surfaces yard = fitYard();
  const geometry::Tracer tracer(yard);
  const auto settings = settingsOf();
  const fit::TrainingSkies skies(kLights);
  const fit::PointTracer points(tracer, settings, skies);
  for (std::size_t i = 0; i < 40; ++i) {
    geometry::Random random(i);
    const double x = random.unit(), z = random.unit();
    const double s = random.unit(), t = random.unit();
    const Number3 p(kBoxLow + 0.3 + 11.0 * x, 1.7, kBoxLow + 0.3 + 11.0 * z);
    const fit::PointLight light = points.trace({p, geometry::sphereDirection(s, t)}, i, 128);
    for (const auto* list : {&light.sky, &light.sun})
      for (const Number3& e : *list) CHECK(e == Number3(0.0));
  }
}

TEST_CASE("PointLight, AmongWallsItIsTheReferences") {
  const geometry::Surfaces yard = fitYard();
  const geometry::Tracer tracer(yard);
  auto settings = settingsOf();
  const model::Sky even = uniformSky(1.0 / det::kPi);
  const model::Sky sun = sunOnly(1.0, 0.4, 0.7);
  settings.light_directions = {sun.sun.path.directionAt(12.0)};
  const fit::TrainingSkies skies(settings.light_directions);
  const fit::PointTracer points(tracer, settings, skies);
  model::Sky even_ground = even, sun_ground = sun;
  even_ground.ground_albedo = sun_ground.ground_albedo = settings.ground_albedo;
  const reference::DistantLight of_sky(even_ground, 12.0), of_sun(sun_ground, 12.0);
  const fit::FitPoint places[] = {{{12.0, 0.0, 33.0}, {0, 1, 0}},
                                  {{24.0, 2.0, 16.2}, geometry::unit({-3.1, 0.0, 7.7})},
                                  {{39.8, 1.0, 45.0}, {-1, 0, 0}}};
  std::size_t i = 0;
  for (const fit::FitPoint& p : places) {
    const fit::PointLight light = points.trace(p, i++, 1 << 15);
    const reference::ReferenceSettings exact{1 << 16, 2, i};
    const auto sky = reference::traceReference(tracer, of_sky, {}, p.position, p.normal, exact).sky;
    const auto bounced = reference::traceReference(tracer, of_sun, {}, p.position, p.normal, exact).sun_bounce;
    // Both have about the same standard error; five of their difference, and the texels of the training sky.
    for (int c = 0; c < 3; ++c) {
      CHECK(light.sky[0][c] == Approx(sky.value[c]).margin(8.0 * sky.standard_error[c] + 0.002));
      CHECK(light.sun[0][c] == Approx(bounced.value[c]).margin(8.0 * bounced.standard_error[c] + 1e-4));
    }
  }
}

}  // namespace welkin::tests
