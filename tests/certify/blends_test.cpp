// SPDX-License-Identifier: Apache-2.0
// The certificate of a family's blends against direct integration, and on files that share no modes.
#include <algorithm>
#include <catch2/catch.hpp>
#include <tuple>

#include "baked_day.h"
#include "sky/bake/certify_blends.h"
#include "sky/table/family_plan.h"
#include "some_skies.h"

namespace welkin::tests {
namespace {

using det::Number3;

/// Skies that share the sun's path, with a ground and less than full saturation.
model::Sky wetSky(std::size_t which, double albedo) {
  model::Sky sky = someSkies()[which].sky;
  sky.ground_albedo = Number3(albedo, 1.5 * albedo, albedo);
  sky.ambient_saturation = {1, {3.0, 14.0}, {0.6, 0.9}};
  return sky;
}

/// The error of a blend at an instant and normals, by definition.
double blendErrorAt(const SampledDay& a, const OpenedTable& of_a, const SampledDay& b, const OpenedTable& of_b,
                    double time_h, double weight, const std::vector<Number3>& normals) {
  const auto irradiance = [&](const SampledDay& day, const Number3& n) {
    const model::SkyProjector direct(day.sky.luminance, 1, 1e-5);
    const model::SkyInstant instant(day.sky, time_h);
    const Number3 ground = instant.groundRadiance(direct.irradiance(instant, {0.0, 1.0, 0.0}));
    return det::desaturate(direct.irradiance(instant, n) * instant.intensity() + ground * (M_PI * 0.5 * (1.0 - n.y)),
                           day.sky.ambient_saturation.at(time_h));
  };
  WelkinSkySample blended{};
  const WelkinSkySample sample_a = of_a.at(time_h), sample_b = of_b.at(time_h);
  REQUIRE(welkin_sample_blend(&sample_a, &sample_b, static_cast<float>(weight), &blended) == WELKIN_OK);
  Number3 sum(0.0);  // the mean over normals and their opposites is that over the sphere, within its quadrature
  double worst[3] = {};
  for (const Number3& n : normals) {
    const Number3 want = mix(irradiance(a, n), irradiance(b, n), weight);
    const Number3 off = of_a.irradiance(blended, n) - want;
    for (int c = 0; c < 3; ++c) worst[c] = std::max(worst[c], std::abs(off[c]));
    sum += want;
  }
  const Number3 mean = sum / static_cast<double>(normals.size());
  const double luminance = 0.2126 * mean.x + 0.7152 * mean.y + 0.0722 * mean.z;
  double error = 0.0;
  for (int c = 0; c < 3; ++c) error = std::max(error, worst[c] / std::max(mean[c], luminance));
  return error;
}

/// Unit directions of equal areas.
std::vector<Number3> equalAreas(int rows, int columns) {
  std::vector<Number3> normals;
  for (int j = 0; j < rows; ++j) {
    const double y = 1.0 - (2.0 * j + 1.0) / rows;
    for (int i = 0; i < columns; ++i) {
      const double azimuth = 2.0 * M_PI * (i + 0.37) / columns;
      normals.push_back({std::sqrt(1.0 - y * y) * std::sin(azimuth), y, std::sqrt(1.0 - y * y) * std::cos(azimuth)});
    }
  }
  return normals;
}

}  // namespace

TEST_CASE("CertifyBlends, AgreesWithDirectIntegration") {
  const SampledDay a(wetSky(0, 0.2), everyHours(0.5)), b(wetSky(2, 0.05), everyHours(0.5));
  std::vector<table::FamilyMember> member = {{&a.values, {}}, {&b.values, {}}};
  member[0].request.max_error = member[1].request.max_error = 0.05;
  const auto plan = table::planFamily(member);
  const OpenedTable of_a(a.sky, plan[0].table, plan[0].encoding), of_b(b.sky, plan[1].table, plan[1].encoding);
  const bake::FamilySky family[] = {{of_a.sky.get(), a.sky, plan[0].table}, {of_b.sky.get(), b.sky, plan[1].table}};
  const auto errors = bake::certifyBlends(family, {}, 1.0);
  REQUIRE(errors.size() == 1);
  const bake::BlendError& worst = errors[0];
  CAPTURE(worst.max_error, worst.time_h, worst.weight, worst.channel);
  CHECK(worst.first == 0);
  CHECK(worst.second == 1);
  double of_skies = 0.0;
  for (const auto& [day, of, table] : {std::tuple(&a, &of_a, &plan[0]), {&b, &of_b, &plan[1]}}) {
    const bake::Baked baked{day->sky,
                            table->representation,
                            table->table,
                            table->encoding,
                            {0.0, &model::kIrradianceRules[0]},
                            table::brightestOf(day->sky)};
    of_skies = std::max(of_skies, bake::certify(of->sky.get(), baked, bake::Certify::fast, {}, 1.0).max_error);
  }
  CHECK(worst.max_error > 0.1 * of_skies);
  CHECK(worst.max_error < 1.2 * of_skies);  // divisors of a channel: docs/conventions.md, "Blends"
  CHECK(std::max_element(worst.day.begin(), worst.day.end(), [](auto& x, auto& y) {
          return x.error < y.error;
        })->error == worst.max_error);
  auto normals = equalAreas(24, 24);
  // 5 %: the mean over 576 normals, and the certificate's grid beside them.
  CHECK(blendErrorAt(a, of_a, b, of_b, worst.time_h, worst.weight, normals) < 1.05 * worst.max_error);
  normals.push_back(worst.normal);
  CHECK(blendErrorAt(a, of_a, b, of_b, worst.time_h, worst.weight, normals) > 0.95 * worst.max_error);
}

TEST_CASE("CertifyBlends, SeesSkiesThatShareNoModes") {
  const SampledDay a(wetSky(0, 0.2), everyHours(0.5));
  model::Sky lobe = a.sky;
  lobe.luminance = {-1.0, -0.3, 300.0, -12.0, 0.2, 0.0};
  const SampledDay b(lobe, everyHours(0.5));
  table::PlanRequest request;
  request.max_error = 0.03;
  request.reconstruction = table::Reconstruction::modes;
  const auto plan_a = table::planDay(a.values, request), plan_b = table::planDay(b.values, request);
  const OpenedTable of_a(a.sky, plan_a.table, plan_a.encoding), of_b(b.sky, plan_b.table, plan_b.encoding);
  const bake::FamilySky family[] = {{of_a.sky.get(), a.sky, plan_a.table}, {of_b.sky.get(), b.sky, plan_b.table}};
  CHECK(bake::certifyBlends(family, {}, 2.0)[0].max_error > 0.06);
}

}  // namespace welkin::tests
