// SPDX-License-Identifier: Apache-2.0
#include "probes/transfer/local_lights.h"

#include <algorithm>

namespace welkin::transfer {
namespace {

double meanOf(const Number3& v) {
  return (v.x + v.y + v.z) / 3.0;
}

}  // namespace

std::vector<double> influenceOf(const geometry::Tracer& tracer, const Number3& probe,
                                std::span<const PathVertex> vertices, std::span<const Number3> lights,
                                std::size_t draws, double nearest_m, std::uint64_t& rays) {
  std::vector<double> unshadowed(lights.size(), 0.0);
  std::vector<double> tested(lights.size(), 1.0);
  std::vector<double> passed(lights.size(), 0.0);
  LightDraw draw(lights, draws, nearest_m);
  for (const PathVertex& vertex : vertices) {
    const double reflected = vertex.reflected.x + vertex.reflected.y + vertex.reflected.z;
    draw.at(vertex, [&](std::size_t l, double) {
      ++rays;
      tested[l] += 1.0;
      passed[l] += meanOf(shareBetween(tracer, vertex.origin, lights[l]));
    });
    for (std::size_t l = 0; l < lights.size(); ++l) unshadowed[l] += reflected * draw.unshadowed()[l];
  }
  for (std::size_t l = 0; l < lights.size(); ++l) {
    if (unshadowed[l] == 0.0) continue;
    ++rays;
    passed[l] += meanOf(shareBetween(tracer, probe, lights[l]));
    unshadowed[l] *= passed[l] / tested[l];
  }
  return unshadowed;
}

std::vector<std::size_t> mostInfluential(std::span<const double> influence, std::size_t most) {
  std::vector<std::size_t> chosen;
  for (std::size_t l = 0; l < influence.size(); ++l)
    if (influence[l] > 0.0) chosen.push_back(l);
  std::stable_sort(chosen.begin(), chosen.end(),
                   [&](std::size_t a, std::size_t b) { return influence[a] > influence[b]; });
  chosen.resize(std::min(chosen.size(), most));
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}

}  // namespace welkin::transfer
