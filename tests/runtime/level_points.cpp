// SPDX-License-Identifier: Apache-2.0
#include "tests/runtime/level_points.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

namespace welkin::tests {

using f64::Number3;
using transfer::SunTransfer;

std::vector<Point> somePoints(std::size_t count) {
  std::mt19937 random(5);
  const auto in = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
  std::vector<Point> points;
  while (points.size() < count) {
    const Number3 v(in(-1, 1), in(-1, 1), in(-1, 1));
    if (dot(v, v) > 1.0 || dot(v, v) < 0.01) continue;
    const Number3 n = v * (1.0 / std::sqrt(dot(v, v)));
    const bool inside = points.size() % 4 == 0;  // of the room that lies across a border
    const Number3 p = inside ? Number3(in(-6, 9), in(0, 6), in(20, 32)) : Number3(in(-66, 130), in(-8, 70), in(-2, 66));
    points.push_back({{static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)},
                      {static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z)}});
  }
  return points;
}

double differenceOf(const RandomLevel& baked, OpenedLevel& opened, double time_h) {
  const WelkinSkySample sample = opened.relight(time_h);
  const sectors::LevelLight reference(baked.sector, lightOf(sample), sample.time_h, baked.index.scale);
  double worst = 0.0, largest = 0.0;
  std::size_t served_points = 0, compared = 0;
  const bool has_sun =
      baked.index.sun != SunTransfer::none && (sample.sun.direction[1] > 0 || sample.moon.direction[1] > 0);
  const bool has_local = !baked.sector[0].probes.emitted.empty();
  for (const Point& p : somePoints(3000)) {
    float rgb[3];
    std::uint8_t served = 2;
    REQUIRE(welkin_level_irradiance(opened.level, 1, &p.position, &p.normal, &rgb, &served) == WELKIN_OK);
    const auto wanted = reference.at({double{p.position[0]}, double{p.position[1]}, double{p.position[2]}},
                                     {double{p.normal[0]}, double{p.normal[1]}, double{p.normal[2]}});
    REQUIRE(served == (wanted ? 1 : 0));
    if (!wanted) {
      CHECK((rgb[0] == 0.0F && rgb[1] == 0.0F && rgb[2] == 0.0F));
      continue;
    }
    ++served_points;
    // The reference keeps each part from falling below 0, the runtime their sum alone: compare where no part does.
    const Number3 total = wanted->total();
    for (int c = 0; c < 3; ++c) {
      largest = std::max(largest, total[c]);
      const bool clamped =
          wanted->sky[c] == 0.0 || (has_sun && wanted->sun_bounce[c] == 0.0) || (has_local && wanted->local[c] == 0.0);
      if (clamped) continue;
      ++compared;
      worst = std::max(worst, std::abs(double{rgb[c]} - total[c]));
    }
  }
  CHECK(served_points > 1500);
  CHECK(compared > 1000);
  CHECK(largest > 0.0);
  return worst / largest;
}

}  // namespace welkin::tests
