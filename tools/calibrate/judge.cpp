// SPDX-License-Identifier: Apache-2.0
#include "calibrate/judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "calibrate/calibration.h"
#include "calibrate/least_squares.h"

namespace welkin::calibrate {
namespace {

/// A patch this far off in the lightness of a channel is not the chart's: 23 of L*, twice the largest error of a
/// camera.
constexpr double kForeign = 0.2;

/// The least side of a patch whose middle half has four pixels.
constexpr double kLeastPatchPixels = 4.0;

/// The cube root of CIE 1976's lightness with its straight part for the dark (CIE 15:2004, 8.2.1).
double lightness(double light) {
  constexpr double kBend = 6.0 / 29.0;
  const double t = std::max(light, 0.0);
  return t > kBend * kBend * kBend ? std::cbrt(t) : t / (3.0 * kBend * kBend) + 4.0 / 29.0;
}

/// Rows of the used patches: photographed lightness and 1, and wanted lightness.
struct Pattern {
  Eigen::MatrixXd rows, wanted;

  Pattern(const Patches& patches, const ReferenceChart& reference, const std::vector<std::size_t>& used)
      : rows(static_cast<Eigen::Index>(used.size()), 4), wanted(static_cast<Eigen::Index>(used.size()), 3) {
    Colour brightest = Colour::Zero();
    for (const std::size_t i : used) brightest = brightest.cwiseMax(patches[i].mean);
    for (Eigen::Index k = 0; k < rows.rows(); ++k) {
      const std::size_t i = used[static_cast<std::size_t>(k)];
      for (int c = 0; c < 3; ++c) {
        rows(k, c) = brightest[c] > 0.0 ? lightness(patches[i].mean[c] / brightest[c]) : 0.0;
        wanted(k, c) = lightness(reference[i][c]);
      }
      rows(k, 3) = 1.0;
    }
  }
};

std::vector<std::size_t> cleanPatches(const Patches& patches) {
  std::vector<std::size_t> clean;
  for (std::size_t i = 0; i < kPatches; ++i)
    if (patches[i].isUsable()) clean.push_back(i);
  return clean;
}

bool isInside(const image::Image& image, const Corners& corners) {
  return std::all_of(corners.begin(), corners.end(), [&](const Point& p) {
    return p.x() >= 0.0 && p.y() >= 0.0 && p.x() <= image.width && p.y() <= image.height;
  });
}

Corners mirrored(const Corners& c) {
  return {c[1], c[0], c[3], c[2]};
}

/// One way up: a turn by quarters of the corners as given, or of their mirror image.
struct WayUp {
  ChartPlace place;
  std::size_t quarters;
  bool is_mirrored;
  Patches patches;
  std::optional<PatternMatch> match;

  double left() const { return match ? 1.0 - match->likeness : 1.0; }
};

std::vector<WayUp> waysUp(const image::Image& image, const Corners& corners, const ReferenceChart& reference,
                          double full) {
  std::vector<WayUp> ways;
  for (const bool mirror : {false, true})
    for (std::size_t quarters = 0; quarters < 4; ++quarters) {
      const ChartPlace place = ChartPlace::of(mirror ? mirrored(corners) : corners)->turned(quarters);
      const Patches patches = measurePatches(image, place, full);
      ways.push_back({place, quarters, mirror, patches, matchPattern(patches, reference)});
    }
  std::stable_sort(ways.begin(), ways.end(), [](const WayUp& a, const WayUp& b) { return a.left() < b.left(); });
  return ways;
}

Point middleOf(const ChartPlace& place) {
  return place.pixelOf(0.5 * kChartWidth, 0.5 * kChartHeight);
}

std::string whyNotUsable(const Patches& patches) {
  std::size_t clipped = 0, uneven = 0;
  for (const Patch& p : patches) {
    clipped += p.isClipped() ? 1 : 0;
    uneven += p.isUneven() ? 1 : 0;
  }
  for (const int c : {0, 1, 2})
    if (std::all_of(patches.begin(), patches.end(), [&](const Patch& p) { return !(p.mean[c] > 0.0); }))
      return fmt::format("its channel {} has no light", "rgb"[c]);
  if (kPatches - clipped - uneven >= kLeastPatches) return "its patches do not differ in colour";
  return fmt::format("{} of its {} patches are overexposed and {} hold an edge, of a shadow or of what covers them",
                     clipped, kPatches, uneven);
}

}  // namespace

std::optional<PatternMatch> matchPattern(const Patches& patches, const ReferenceChart& reference) {
  PatternMatch match;
  std::vector<std::size_t> used = cleanPatches(patches);
  for (;;) {
    if (used.size() < kLeastPatches) return match.foreign.empty() ? std::nullopt : std::optional(PatternMatch{});
    const Pattern pattern(patches, reference, used);
    const Eigen::VectorXd weight = Eigen::VectorXd::Ones(pattern.rows.rows());
    const auto map = leastSquares(pattern.rows, pattern.wanted, weight, 1e-3);
    if (!map) return std::nullopt;
    const Eigen::MatrixXd error = pattern.rows * *map - pattern.wanted;
    Eigen::Index worst = 0;
    const double most = error.cwiseAbs().rowwise().maxCoeff().maxCoeff(&worst);
    if (most <= kForeign) {
      const Eigen::MatrixXd varied = pattern.wanted.rowwise() - pattern.wanted.colwise().mean();
      match.likeness = std::max(0.0, 1.0 - error.squaredNorm() / varied.squaredNorm());
      return match;
    }
    match.foreign.push_back(used[static_cast<std::size_t>(worst)]);
    used.erase(used.begin() + worst);
  }
}

Judgement judge(const image::Image& image, const Corners& corners, const ReferenceChart& reference, double full,
                bool turn) {
  Judgement result{std::nullopt, {}, {}, ""};
  const auto given = ChartPlace::of(corners);
  if (!given) {
    result.refusal = "its corners are not those of a convex area, one after the other around it";
  } else if (!isInside(image, corners)) {
    result.refusal = "the picture cuts it: a corner lies outside";
  } else if (given->shortestSide() < kLeastPatchPixels) {
    result.refusal = fmt::format("its patches are {:.1f} pixels wide; at least {} are needed", given->shortestSide(),
                                 kLeastPatchPixels);
  }
  if (!result.refusal.empty()) return result;

  const std::vector<WayUp> ways = waysUp(image, corners, reference, full);
  const WayUp& best = ways[0];
  result.patches = best.patches;
  if (!best.match) {
    result.refusal = whyNotUsable(given ? measurePatches(image, *given, full) : best.patches);
    return result;
  }
  result.match = *best.match;
  for (const std::size_t i : result.match.foreign) result.patches[i].is_foreign = true;
  if (best.match->likeness < kLeastLikeness) {
    result.refusal = fmt::format(
        "its colours are not a ColorChecker's, or too much of it is covered: likeness {:.2f}, "
        "at least {} is needed",
        best.match->likeness, kLeastLikeness);
  } else if (best.left() > kMostAmbiguity * ways[1].left()) {
    result.refusal = fmt::format("two ways up are equally likely: likeness {:.3f} and {:.3f}", best.match->likeness,
                                 1.0 - ways[1].left());
  } else if (best.is_mirrored) {
    result.refusal = "it is mirrored, or its corners run against the order dark skin, bluish green, black, white";
  } else if (!turn && best.quarters != 0) {
    result.refusal = fmt::format(
        "its corners begin at another patch than dark skin; the right order begins with the "
        "{} one",
        best.quarters == 1   ? "second"
        : best.quarters == 2 ? "third"
                             : "fourth");
  } else {
    result.place = best.place;
  }
  return result;
}

std::vector<Judgement> judgeAll(const image::Image& image, const std::vector<Corners>& areas,
                                const ReferenceChart& reference, double full, bool turn) {
  std::vector<Judgement> all;
  for (const Corners& area : areas) all.push_back(judge(image, area, reference, full, turn));
  std::stable_sort(all.begin(), all.end(), [](const Judgement& a, const Judgement& b) {
    return std::pair(b.place.has_value(), b.match.likeness) < std::pair(a.place.has_value(), a.match.likeness);
  });
  if (all.empty()) return all;
  if (!all[0].place) return {all[0]};
  std::vector<Judgement> charts;
  for (const Judgement& verdict : all) {
    if (!verdict.place) break;
    const Point middle = middleOf(*verdict.place);
    const bool is_known = std::any_of(charts.begin(), charts.end(), [&](const Judgement& chart) {
      const double size = (chart.place->corners()[0] - middleOf(*chart.place)).norm();
      return (middleOf(*chart.place) - middle).norm() < 0.5 * size;
    });
    if (!is_known) charts.push_back(verdict);
  }
  return charts;
}

}  // namespace welkin::calibrate
