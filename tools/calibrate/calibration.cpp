// SPDX-License-Identifier: Apache-2.0
#include "calibrate/calibration.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "calibrate/affine_cubic.h"
#include "calibrate/left_out.h"
#include "sky/base/error.h"

namespace welkin::calibrate {
namespace {

[[noreturn]] void refusePatches(const std::string& photo, const std::string& why) {
  throw base::Error(base::ExitStatus::content, fmt::format("{}: {}", photo, why));
}

/// Patches that light or the camera's range has not spoilt.
std::vector<std::size_t> usedPatches(const std::string& photo, const Patches& patches) {
  std::vector<std::size_t> used;
  std::size_t clipped = 0, uneven = 0;
  for (std::size_t i = 0; i < kPatches; ++i) {
    clipped += patches[i].isClipped() ? 1 : 0;
    uneven += patches[i].isUneven() || patches[i].is_foreign ? 1 : 0;
    if (patches[i].isUsable()) used.push_back(i);
  }
  if (used.size() < kLeastPatches)
    refusePatches(photo,
                  fmt::format("{} of {} patches are overexposed and {} are partly in shadow or covered; at least {} "
                              "good ones are needed",
                              clipped, kPatches, uneven, kLeastPatches));
  return used;
}

void requireThreeColours(const std::string& photo, std::span<const Pair> pairs) {
  constexpr const char* kChannels[] = {"red", "green", "blue"};
  for (int c = 0; c < 3; ++c)
    if (std::all_of(pairs.begin(), pairs.end(), [c](const Pair& p) { return p.measured[c] <= 0.0; }))
      refusePatches(photo, fmt::format("the chart has no light in {}: every patch is 0 there", kChannels[c]));
  if (!modelNamed("3x3")->fit(pairs))
    refusePatches(photo, "the chart's patches do not differ in colour: they determine no calibration");
}

double squaresInSrgb(std::span<const Pair> pairs, const Model& model) {
  double sum = 0.0;
  for (const Pair& p : pairs) sum += (srgbOfRgb(model(p.measured)) - srgbOfRgb(p.wanted)).squaredNorm();
  return sum;
}

double meanOf(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

}  // namespace

std::vector<Pair> pairsOf(const Patches& patches, const ReferenceChart& reference,
                          const std::vector<std::size_t>& used) {
  std::vector<Pair> pairs;
  for (const std::size_t i : used) pairs.push_back({patches[i].mean, reference[i]});
  return pairs;
}

Calibration calibratePatches(const std::string& photo, const Patches& patches, const ReferenceChart& reference,
                             std::string_view model) {
  Calibration result;
  result.used = usedPatches(photo, patches);
  const std::vector<Pair> pairs = pairsOf(patches, reference, result.used);
  requireThreeColours(photo, pairs);
  std::vector<std::size_t> row;
  for (const std::size_t i : result.used) row.push_back(i / kColumns);
  std::vector<Model> fitted;
  for (const ModelKind& kind : models()) {
    if (model != "auto" && model != kind.name) continue;
    auto numbers = kind.fit(pairs);
    auto left_out = differencesLeftOut(pairs, result.used, kind);
    if (!numbers || !left_out) continue;
    fitted.push_back({&kind, std::move(*numbers)});
    result.tried.push_back({&kind, differences(pairs, fitted.back()), std::move(*left_out),
                            differencesLeftOut(pairs, row, kind).value_or(std::vector<double>{})});
  }
  if (fitted.empty()) refusePatches(photo, fmt::format("the chart's patches do not determine the model {}", model));
  const auto best = std::min_element(
      result.tried.begin(), result.tried.end(),
      [](const ModelErrors& a, const ModelErrors& b) { return meanOf(a.left_out) < meanOf(b.left_out); });
  result.chosen = static_cast<std::size_t>(best - result.tried.begin());
  result.model = fitted[result.chosen];
  result.before = differencesBefore(pairs);
  result.rss_srgb = squaresInSrgb(pairs, result.model);
  result.rss_xyY = squaresInXyY(pairs, result.model);
  return result;
}

}  // namespace welkin::calibrate
