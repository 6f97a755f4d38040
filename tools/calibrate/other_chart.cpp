// SPDX-License-Identifier: Apache-2.0
#include "calibrate/other_chart.h"

#include "calibrate/calibration.h"
#include "calibrate/find_charts.h"
#include "calibrate/left_out.h"

namespace welkin::calibrate {
namespace {

std::vector<Corners> cornersOf(const std::vector<Candidate>& candidates) {
  std::vector<Corners> areas;
  for (const Candidate& candidate : candidates) areas.push_back(candidate.corners);
  return areas;
}

}  // namespace

std::vector<Corners> areasIn(const image::Image& image, const ReferenceChart& reference, double full) {
  const auto hold_chart = [&](const std::vector<Candidate>& found) {
    const std::vector<Judgement> verdicts = judgeAll(image, cornersOf(found), reference, full, true);
    return !verdicts.empty() && verdicts[0].place;
  };
  return cornersOf(findCandidates(image, hold_chart));
}

std::vector<FoundChart> chartsIn(const image::Image& image, bool linear_codes, const ReferenceChart& reference) {
  const double full = clippingLevel(image, linear_codes);
  std::vector<FoundChart> charts;
  for (const Judgement& v : judgeAll(image, areasIn(image, reference, full), reference, full, true))
    if (v.place) charts.push_back({*v.place, v.match.likeness, v.patches});
  return charts;
}

ChartError errorOn(const FoundChart& chart, const Model& model, const ReferenceChart& reference) {
  std::vector<std::size_t> usable;
  for (std::size_t i = 0; i < kPatches; ++i)
    if (chart.patches[i].isUsable()) usable.push_back(i);
  const std::vector<Pair> pairs = pairsOf(chart.patches, reference, usable);
  return {chart, usable, differencesBefore(pairs), differences(pairs, model)};
}

}  // namespace welkin::calibrate
