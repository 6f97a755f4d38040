// SPDX-License-Identifier: Apache-2.0
#include "probes/transfer/local_relight.h"

#include <algorithm>
#include <cmath>

#include "sh/deterministic.h"

namespace welkin::transfer {
namespace {

constexpr std::size_t kNearest = 4;
constexpr double kReach = 1.5;
constexpr double kOutside = 1.0 / 16.0;

struct Seen {
  std::size_t light;
  double distance;
};

/// The virtual lights that take a share, nearest first.
std::vector<Seen> seenFrom(std::span<const Number3> lights, const Number3& position, const SeeEachOther& see) {
  std::vector<Seen> all;
  for (std::size_t l = 0; l < lights.size(); ++l) {
    const Number3 away = lights[l] - position;
    all.push_back({l, std::sqrt(dot(away, away))});
  }
  std::stable_sort(all.begin(), all.end(), [](const Seen& a, const Seen& b) { return a.distance < b.distance; });
  std::vector<Seen> seen;
  for (const Seen& s : all) {
    if (seen.size() >= kNearest && s.distance >= kReach * seen[kNearest - 1].distance) break;
    if (see(lights[s.light], position)) seen.push_back(s);
  }
  return seen;
}

/// Mean over the sphere of coneShareOf: Simpson's rule is exact for the square between the cones.
double partOfSphere(const DynamicLight& light) {
  if (!light.outer_rad) return 1.0;
  const double low = std::cos(*light.outer_rad), high = std::cos(light.inner_rad);
  const double between =
      (coneShareOf(light, low) + 4.0 * coneShareOf(light, (low + high) / 2.0) + coneShareOf(light, high)) / 6.0;
  return (1.0 - high + (high - low) * between) / 2.0;
}

}  // namespace

double coneShareOf(const DynamicLight& light, double cosine) {
  if (!light.outer_rad) return 1.0;
  const double low = std::cos(*light.outer_rad), high = std::cos(light.inner_rad);
  if (cosine >= high) return 1.0;
  const double inside = cosine <= low ? 0.0 : (cosine - low) / (high - low);
  return inside * inside;
}

LocalColours relightLocal(std::span<const Number3> virtual_lights, std::span<const DynamicLight> dynamic_lights,
                          const SeeEachOther& see_each_other) {
  LocalColours result;
  result.colour.resize(virtual_lights.size(), Number3(0.0));
  for (std::size_t i = 0; i < dynamic_lights.size(); ++i) {
    const DynamicLight& lamp = dynamic_lights[i];
    const auto seen = seenFrom(virtual_lights, lamp.position, see_each_other);
    if (seen.empty()) {
      result.unseen.push_back(i);
      continue;
    }
    if (seen.front().distance == 0.0) {
      result.colour[seen.front().light] += lamp.intensity * partOfSphere(lamp);
      continue;
    }
    const double reach = kReach * seen[std::min(kNearest, seen.size()) - 1].distance;
    std::vector<double> weight;
    double sum = 0.0;
    for (const Seen& s : seen) {
      // Scaled by the nearest distance, so that a tiny distance does not overflow.
      const double root = seen.front().distance * (1.0 / s.distance - 1.0 / reach);
      const double cosine = dot(virtual_lights[s.light] - lamp.position, lamp.axis) / s.distance;
      weight.push_back(root * root * (kOutside + coneShareOf(lamp, cosine)));
      sum += weight.back();
    }
    for (std::size_t s = 0; s < seen.size(); ++s)
      result.colour[seen[s].light] += lamp.intensity * (partOfSphere(lamp) * weight[s] / sum);
  }
  return result;
}

std::array<Number3, kDirections> relitLocal(std::span<const LocalTransfer> transfer, std::span<const Number3> colour) {
  const auto basis = transferBasis();
  std::array<Number3, kDirections> irradiance{};
  for (const LocalTransfer& t : transfer)
    for (std::size_t b = 0; b < kDirections; ++b) {
      const double linear = det::cosineLobe(1) * det::kShLinear;
      irradiance[b] +=
          colour[t.light] *
          (t.radiance[0] * (det::cosineLobe(0) * det::kShConstant) + t.radiance[1] * (linear * basis[b].y) +
           t.radiance[2] * (linear * basis[b].z) + t.radiance[3] * (linear * basis[b].x));
    }
  return irradiance;
}

}  // namespace welkin::transfer
