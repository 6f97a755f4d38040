// SPDX-License-Identifier: Apache-2.0
// Tells charts from what only looks like one, and the way up of a chart, by the pattern of its 24 colours.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "calibrate/chart_place.h"
#include "calibrate/patches.h"

namespace welkin::calibrate {

/// How well patches match a chart's. Both are compared as perceived lightness of the three channels, each photographed
/// channel relative to its brightest patch, after the affine map of least squares. So white balance, exposure and a
/// camera's curve count little.
struct PatternMatch {
  double likeness = 0.0;             ///< coefficient of determination: 1 for the same pattern, near 0 for another
  std::vector<std::size_t> foreign;  ///< patches that were left out, since the others put their colour elsewhere
};

/// A match of this likeness is a chart. Of 9000 patterns of random colours, of ramps and of the chart's own colours in
/// another order none comes to 0.65; a chart through every camera of the tests has 0.95 and more
/// (tests/calibrate/judge_test.cpp).
inline constexpr double kLeastLikeness = 0.85;

/// The best way up leaves at most this part of the squares that the next best leaves.
inline constexpr double kMostAmbiguity = 0.5;

/// None if the patches that can be used are less than kLeastPatches or have no two colours.
std::optional<PatternMatch> matchPattern(const Patches& patches, const ReferenceChart& reference);

/// The verdict about one candidate.
struct Judgement {
  std::optional<ChartPlace> place;  ///< none if it is refused; else the right way up
  Patches patches;                  ///< measured at the place
  PatternMatch match;
  std::string refusal;  ///< the reason, without the file's name
};

/// Judges four corners in any order around the chart. `full` is as in measurePatches(). Where `turn` is not set, the
/// first corner must be dark skin's, and other ways up are refused.
Judgement judge(const image::Image& image, const Corners& corners, const ReferenceChart& reference, double full,
                bool turn);

/// Judges many areas. Returns the charts, the most similar first, each once: of areas whose middles are nearer than
/// half way to a corner the most similar counts. Without a chart it returns the most similar refusal, and nothing where
/// there is no area.
std::vector<Judgement> judgeAll(const image::Image& image, const std::vector<Corners>& areas,
                                const ReferenceChart& reference, double full, bool turn);

}  // namespace welkin::calibrate
