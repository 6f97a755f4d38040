// SPDX-License-Identifier: Apache-2.0
#include "probes/transfer/local_relight.h"

#include <algorithm>
#include <cmath>

#include "sh/deterministic.h"

namespace welkin::transfer {
namespace {

constexpr std::size_t kNearest = 4;
constexpr double kReach = 1.5;

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

}  // namespace

LocalColours relightLocal(std::span<const Number3> virtual_lights, std::span<const geometry::PointLight> dynamic_lights,
                          const SeeEachOther& see_each_other) {
  LocalColours result;
  result.colour.resize(virtual_lights.size(), Number3(0.0));
  for (std::size_t i = 0; i < dynamic_lights.size(); ++i) {
    const geometry::PointLight& lamp = dynamic_lights[i];
    const auto seen = seenFrom(virtual_lights, lamp.position, see_each_other);
    if (seen.empty()) {
      result.unseen.push_back(i);
      continue;
    }
    if (seen.front().distance == 0.0) {
      result.colour[seen.front().light] += lamp.intensity;
      continue;
    }
    const double reach = kReach * seen[std::min(kNearest, seen.size()) - 1].distance;
    std::vector<double> weight;
    double sum = 0.0;
    for (const Seen& s : seen) {
      // Scaled by the nearest distance, so that a tiny distance does not overflow.
      const double root = seen.front().distance * (1.0 / s.distance - 1.0 / reach);
      weight.push_back(root * root);
      sum += weight.back();
    }
    for (std::size_t s = 0; s < seen.size(); ++s) result.colour[seen[s].light] += lamp.intensity * (weight[s] / sum);
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
