// SPDX-License-Identifier: Apache-2.0
// Normals at which shaders that read modes are compared with the runtime.
#pragma once

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>
#include <welkin/welkin.hpp>

namespace welkin::tests {

using Vector = std::array<float, 3>;

/// A golden-angle spiral, the poles, the four corners of the horizon, and normals just to either side of it and of the
/// poles. 1e-30 is the smallest offset, because a denormal y may count as 0.
inline std::vector<Vector> modeNormals() {
  constexpr std::size_t kSpiral = 642;
  std::vector<Vector> all;
  for (std::size_t i = 0; i < kSpiral; ++i) {
    const double y = 1.0 - 2.0 * (static_cast<double>(i) + 0.5) / static_cast<double>(kSpiral);
    const double r = std::sqrt(1.0 - y * y);
    const double angle = 2.39996322972865332 * static_cast<double>(i);
    all.push_back(
        {static_cast<float>(r * std::cos(angle)), static_cast<float>(y), static_cast<float>(r * std::sin(angle))});
  }
  const float below_1 = std::nextafter(1.0F, 0.0F);
  const float beside = std::sqrt(1.0F - below_1 * below_1);
  for (const float sign : {1.0F, -1.0F}) {
    all.push_back({0.0F, sign, 0.0F});
    all.push_back({0.0F, sign * below_1, beside});
    all.push_back({-beside, sign * below_1, 0.0F});
    all.push_back({1e-30F, sign, -1e-30F});
    for (const float y : {0.0F, -0.0F, 1e-30F, -1e-30F, 0x1p-24F, -0x1p-24F}) {
      all.push_back({sign, y, 0.0F});
      all.push_back({0.0F, y, sign});
      all.push_back({sign * 0.6F, y, 0.8F});
    }
  }
  return all;
}

/// The irradiance that the runtime gives, pi included.
inline Vector expectedOf(const Sky& sky, const WelkinSkySample& sample, const Vector& normal) {
  Vector e{};
  REQUIRE(welkin_sky_irradiance(sky.get(), &sample, normal.data(), e.data()) == WELKIN_OK);
  return e;
}

}  // namespace welkin::tests
