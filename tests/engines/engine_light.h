// SPDX-License-Identifier: Apache-2.0
// Samples and normals on which the engines' light is compared with this library's.
#pragma once

#include <welkin/engines.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <random>
#include <string>
#include <vector>

namespace welkin::tests {

using Vector = std::array<float, 3>;

/// A sample to compare, with its name for messages.
struct EngineLight {
  std::string name;
  WelkinSkySample sample;
};

/// Values of the first nine basis functions, from the table of welkin.h.
inline std::array<double, 9> basisOf(double x, double y, double z) {
  const double c0 = std::sqrt(1.0 / M_PI) / 2.0, c1 = std::sqrt(3.0 / M_PI) / 2.0, c2 = std::sqrt(15.0 / M_PI) / 2.0;
  return {c0,
          c1 * y,
          c1 * z,
          c1 * x,
          c2 * x * y,
          c2 * y * z,
          c2 * (3 * z * z - 1) / (2 * std::sqrt(3.0)),
          c2 * z * x,
          c2 * (x * x - y * y) / 2};
}

/// A sky without any symmetry, with two bands or three, and the light of a sun that is nearly a point. The three
/// channels differ.
inline std::vector<EngineLight> engineLights() {
  std::vector<EngineLight> lights;
  for (const std::uint32_t count : {9U, 4U}) {
    std::mt19937 random(11 + count);
    std::uniform_real_distribution<float> value(0.1F, 0.5F);
    EngineLight light{count == 9 ? "three bands" : "two bands", {}};
    light.sample.coefficient_count = count;
    for (std::uint32_t i = 0; i < count; ++i)
      for (float& c : light.sample.ambient_sh[i])
        c = i == 0 ? 3.0F + value(random) : value(random) * (random() % 2 == 0 ? 1.0F : -1.0F);
    lights.push_back(light);
  }
  EngineLight sun{"sun", {}};
  sun.sample.coefficient_count = 9;
  const auto basis = basisOf(0.48, 0.64, -0.6);
  const double irradiance[3] = {3.0, 2.0, 1.0};
  for (std::size_t i = 0; i < 9; ++i)
    for (std::size_t c = 0; c < 3; ++c) sun.sample.ambient_sh[i][c] = static_cast<float>(basis[i] * irradiance[c]);
  lights.push_back(sun);
  for (EngineLight& light : lights) {
    WelkinLight& key = light.sample.sun;
    const float direction[3] = {0.48F, 0.64F, -0.6F}, key_irradiance[3] = {1.5F, 1.25F, 0.5F};
    std::copy_n(direction, 3, key.direction);
    std::copy_n(key_irradiance, 3, key.normal_irradiance);
    key.visible = 1.0F;
  }
  return lights;
}

/// The six axes, and 200 normals evenly spread (a Fibonacci spiral).
inline std::vector<Vector> engineNormals() {
  std::vector<Vector> normals = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  constexpr int kSpread = 200;
  for (int i = 0; i < kSpread; ++i) {
    const double z = 1.0 - (2.0 * i + 1.0) / kSpread, turn = i * M_PI * (3.0 - std::sqrt(5.0));
    const double radius = std::sqrt(1.0 - z * z);
    normals.push_back({static_cast<float>(radius * std::cos(turn)), static_cast<float>(radius * std::sin(turn)),
                       static_cast<float>(z)});
  }
  return normals;
}

/// The irradiance that this library gives, pi included.
inline Vector welkinIrradiance(const WelkinSkySample& sample, const Vector& normal) {
  Vector e{};
  welkin_sample_irradiance(&sample, normal.data(), e.data());
  return e;
}

/// A vector in an engine's axes.
inline Vector inAxes(WelkinAxes axes, const Vector& v) {
  Vector converted{};
  welkin_axes_vector(axes, v.data(), converted.data());
  return converted;
}

/// Largest difference of an engine's irradiance from this library's over all normals, divided by the mean irradiance.
/// `engine(sample, normal)` gives the engine's irradiance over pi; its normal is in this library's axes.
template <typename Engine>
double largestError(const WelkinSkySample& sample, Engine engine) {
  double largest = 0.0, sum = 0.0;
  const std::vector<Vector> normals = engineNormals();
  for (const Vector& normal : normals) {
    const Vector expected = welkinIrradiance(sample, normal);
    const Vector e = engine(sample, normal);
    for (std::size_t c = 0; c < 3; ++c) {
      largest = std::max(largest, std::abs(std::max(double{e[c]} * M_PI, 0.0) - double{expected[c]}));
      sum += double{expected[c]};
    }
  }
  return largest / (sum / (3.0 * static_cast<double>(normals.size())));
}

/// Prints the largest error of an engine on a sample, for the table of docs/engines.md.
inline void printError(const char* engine, const EngineLight& light, double error) {
  std::printf("%s, %s: %.1e\n", engine, light.name.c_str(), error);
}

/// Floats round each of at most ten terms of an irradiance by 6e-8 of its size, and a near point has terms several
/// times the mean. A wrong sign is off by more than 0.1.
inline constexpr double kRounding = 3e-6;

}  // namespace welkin::tests
