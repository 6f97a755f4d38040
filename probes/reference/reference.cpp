// SPDX-License-Identifier: Apache-2.0
#include "probes/reference/reference.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "probes/reference/light_path.h"
#include "sky/base/error.h"

namespace welkin::reference {
namespace {

constexpr std::size_t kLeastBatches = 64;  // their spread gives the standard error to within a tenth
constexpr std::size_t kMostStrata = 64;    // on a side; keeps a batch short enough to be interrupted

/// Strata on a side of a batch, with one path in each.
std::size_t strataOf(const ReferenceSettings& settings) {
  const double each = static_cast<double>(settings.samples) / static_cast<double>(kLeastBatches);
  return std::clamp(static_cast<std::size_t>(std::sqrt(each)), std::size_t{1}, kMostStrata);
}

/// Mean over the batches and its standard error.
template <typename Of>
Estimate estimateOf(const std::vector<LightShares>& batches, Of of) {
  const auto count = static_cast<double>(batches.size());
  Estimate estimate;
  for (const LightShares& batch : batches) estimate.value += of(batch);
  estimate.value = estimate.value / count;
  Number3 squares(0.0);
  for (const LightShares& batch : batches) {
    const Number3 off = of(batch) - estimate.value;
    squares += off * off;
  }
  const Number3 variance = squares / (count * (count - 1.0));
  estimate.standard_error = {std::sqrt(variance.x), std::sqrt(variance.y), std::sqrt(variance.z)};
  return estimate;
}

}  // namespace

std::size_t referenceBatches(const ReferenceSettings& settings) {
  const std::size_t paths = strataOf(settings) * strataOf(settings);
  return std::max(kLeastBatches, (settings.samples + paths - 1) / paths);
}

ReferenceIrradiance traceReference(const geometry::Tracer& tracer, const DistantLight& distant,
                                   std::span<const LocalLight> lights, const Number3& position, const Number3& normal,
                                   const ReferenceSettings& settings, const base::Progress& progress) {
  const PathScene scene = pathScene(tracer, distant, lights, settings.bounces);
  const std::size_t strata = strataOf(settings);
  const geometry::Hit start = tracer.pointOn(position, normal);
  std::vector<LightShares> batches(referenceBatches(settings));
  tbb::parallel_for(std::size_t{0}, batches.size(), [&](std::size_t i) {
    batches[i] = meanOfBatch(scene, start, strata, settings.seed, i);
    progress.step();
  });
  ReferenceIrradiance irradiance;
  irradiance.sky = estimateOf(batches, [](const LightShares& b) { return b.sky; });
  irradiance.sun_bounce = estimateOf(batches, [](const LightShares& b) { return b.sun_bounce; });
  irradiance.local = estimateOf(batches, [](const LightShares& b) { return b.local; });
  irradiance.total = estimateOf(batches, [](const LightShares& b) { return b.sky + b.sun_bounce + b.local; });
  irradiance.samples = batches.size() * strata * strata;
  return irradiance;
}

}  // namespace welkin::reference
