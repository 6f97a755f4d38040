// SPDX-License-Identifier: Apache-2.0
#include "generate/noise.h"

#include <cmath>

namespace welkin::island {
namespace {

double lattice(int64_t x, int64_t y, int64_t z, uint32_t seed) {
  return random(seed, hash(hash(static_cast<uint32_t>(x)) + static_cast<uint32_t>(y)) + static_cast<uint32_t>(z));
}

double fade(double t) {
  return t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
}

}  // namespace

double noise(const Vec3& p, uint32_t seed) {
  const Vec3 floor(std::floor(p.x), std::floor(p.y), std::floor(p.z));
  const auto x = static_cast<int64_t>(floor.x);
  const auto y = static_cast<int64_t>(floor.y);
  const auto z = static_cast<int64_t>(floor.z);
  const Vec3 t(fade(p.x - floor.x), fade(p.y - floor.y), fade(p.z - floor.z));
  const auto alongX = [&](int64_t j, int64_t k) {
    return mix(lattice(x, y + j, z + k, seed), lattice(x + 1, y + j, z + k, seed), t.x);
  };
  return mix(mix(alongX(0, 0), alongX(1, 0), t.y), mix(alongX(0, 1), alongX(1, 1), t.y), t.z);
}

double fractalNoise(const Vec3& p, int octaves, uint32_t seed) {
  double sum = 0.0;
  double total = 0.0;
  double amplitude = 1.0;
  double frequency = 1.0;
  for (int i = 0; i < octaves; ++i) {
    sum += amplitude * noise(p * frequency, seed + static_cast<uint32_t>(i));
    total += amplitude;
    amplitude *= 0.5;
    frequency *= 2.0;
  }
  return sum / total;
}

}  // namespace welkin::island
