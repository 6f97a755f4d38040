// SPDX-License-Identifier: Apache-2.0
#include "probes/fit/training_skies.h"

#include <algorithm>
#include <cmath>

namespace welkin::fit {
namespace {

constexpr int kSide = 48;  ///< texels along a side: 3 degrees
constexpr std::size_t kSuns = 6;
constexpr double kBelow_y[] = {-0.05, -0.25};  ///< sines of the elevations of suns below the horizon
constexpr det::LuminanceModel kClear{-1.0, -0.32, 10.0, -3.0, 0.45, 0.0};
constexpr det::LuminanceModel kOvercast{0.0, -1.0, 0.0, -1.0, 0.0, 2.0};

double angleBetween(const Number3& a, const Number3& b) {
  const Number3 across = cross(a, b);
  return det::atan(std::sqrt(dot(across, across)), dot(a, b));
}

/// The sun moved to a height, at the same azimuth. `from` is not vertical.
Number3 atHeight(const Number3& from, double y) {
  const double factor = std::sqrt((1.0 - y * y) / (from.x * from.x + from.z * from.z));
  return {from.x * factor, y, from.z * factor};
}

/// Suns by day along the path, and below the horizon at both of its ends.
std::vector<Number3> sunsOf(const std::vector<Number3>& light_directions) {
  constexpr double kLow_y = 0.02, kLevel = 1e-6;
  std::vector<Number3> up;
  for (const Number3& d : light_directions)
    if (d.y > kLow_y) up.push_back(d);
  if (up.empty())
    for (const Number3& d : {Number3(1, 0, 0), Number3(0, 0, 1), Number3(-1, 0, 0), Number3(0, 0, -1)})
      up.push_back(atHeight(d, 0.3));
  std::vector<Number3> suns;
  const std::size_t count = std::min(kSuns, up.size());
  for (std::size_t i = 0; i < count; ++i) suns.push_back(up[(2 * i + 1) * up.size() / (2 * count)]);
  const auto lowest = [&](const auto& counts) {
    const Number3* found = nullptr;
    for (const Number3& d : up)
      if (counts(d) && d.x * d.x + d.z * d.z > kLevel && (found == nullptr || d.y < found->y)) found = &d;
    return found;
  };
  const Number3* first = lowest([](const Number3&) { return true; });
  if (first == nullptr) return suns;
  const Number3* second = lowest([&](const Number3& d) { return d.x * first->x + d.z * first->z < 0.0; });
  for (const Number3* end : {first, second})
    for (const double y : kBelow_y)
      if (end != nullptr) suns.push_back(atHeight(*end, y));
  return suns;
}

}  // namespace

TrainingSkies::TrainingSkies(const std::vector<Number3>& light_directions) {
  for (int j = 0; j < kSide; ++j)
    for (int i = 0; i < kSide; ++i) {
      const double s = (2.0 * i + 1.0) / kSide - 1.0, t = (2.0 * j + 1.0) / kSide - 1.0;
      const double u = 0.5 * (s + t), v = 0.5 * (s - t);
      const Number3 p(u, 1.0 - std::abs(u) - std::abs(v), v);
      const double length = std::sqrt(dot(p, p));
      texel_.push_back({p / length, 2.0 / (kSide * kSide * length * length * length)});
    }
  add([](const Number3&) { return 1.0; });
  add([](const Number3& d) { return det::gradation(kOvercast, d.y); });
  for (const Number3& sun : sunsOf(light_directions))
    add([&](const Number3& d) { return det::gradation(kClear, d.y) * det::indicatrix(kClear, angleBetween(d, sun)); });
  arrange();
}

template <typename Radiance>
void TrainingSkies::add(const Radiance& radiance) {
  std::vector<double> value;
  double horizontal = 0.0;
  for (const Texel& texel : texel_) {
    value.push_back(radiance(texel.direction));
    horizontal += value.back() * texel.direction.y * texel.solid_angle;
  }
  std::array<double, 4> coefficient{};
  for (std::size_t i = 0; i < value.size(); ++i) {
    value[i] /= horizontal;
    const det::ShBasis basis = det::shBasis(texel_[i].direction);
    for (std::size_t k = 0; k < coefficient.size(); ++k)
      coefficient[k] += basis.v[k] * value[i] * texel_[i].solid_angle;
  }
  sky_.push_back(std::move(value));
  coefficient_.push_back(coefficient);
}

void TrainingSkies::arrange() {
  for (std::size_t i = 0; i < texel_.size(); ++i)
    for (const auto& sky : sky_) radiance_.push_back(sky[i]);
  sky_.clear();
}

std::span<const double> TrainingSkies::radiance(const Number3& d) const {
  const double length = std::abs(d.x) + std::abs(d.y) + std::abs(d.z);
  const auto texelOf = [](double along) {
    return std::clamp(static_cast<int>(0.5 * kSide * (along + 1.0)), 0, kSide - 1);
  };
  const int i = texelOf((d.x + d.z) / length), j = texelOf((d.x - d.z) / length);
  return std::span(radiance_).subspan(static_cast<std::size_t>(i + kSide * j) * count(), count());
}

std::vector<double> TrainingSkies::irradiance(const Number3& normal) const {
  std::vector<double> sum(count(), 0.0);
  for (std::size_t i = 0; i < texel_.size(); ++i) {
    const double weight = dot(normal, texel_[i].direction) * texel_[i].solid_angle;
    if (weight <= 0.0) continue;
    for (std::size_t l = 0; l < sum.size(); ++l) sum[l] += weight * radiance_[i * sum.size() + l];
  }
  return sum;
}

}  // namespace welkin::fit
