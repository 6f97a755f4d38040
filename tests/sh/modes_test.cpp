// SPDX-License-Identifier: Apache-2.0
// Principal modes of snapshots whose modes are known, and what refinement does to the worst snapshot.
#include "sh/modes.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/sh/bits.h"

namespace welkin::sh {
namespace {

constexpr double kOrthonormal = 1e-13;   // as sh/modes.h states
constexpr double kModeRounding = 1e-13;  // of snapshots of size 1 in up to 60 dimensions

double largestOverlap(const Modes& modes) {
  double worst = 0.0;
  for (std::size_t k = 0; k < modes.count(); ++k)
    for (std::size_t j = 0; j <= k; ++j) {
      double sum = 0.0;
      for (std::size_t i = 0; i < modes.dimension; ++i) sum += modes.row(k)[i] * modes.row(j)[i];
      worst = std::max(worst, std::abs(sum - (j == k ? 1.0 : 0.0)));
    }
  return worst;
}

double worstError(const Modes& modes, const Snapshots& snapshots, const ErrorMeasure& measure) {
  std::vector<double> coefficients(modes.count());
  std::vector<double> residual(snapshots.dimension);
  double worst = 0.0;
  for (std::size_t i = 0; i < snapshots.count(); ++i) {
    projectOntoModes(modes, snapshots.row(i), coefficients, residual);
    worst = std::max(worst, measure(i, residual));
  }
  return worst;
}

/// 60 smooth, lopsided snapshots in 40 dimensions, of which number 41 has a narrow peak that no other has.
std::vector<double> withOutlier() {
  std::vector<double> value;
  for (int i = 0; i < 60; ++i)
    for (int j = 0; j < 40; ++j) {
      const double t = 0.02 * i;
      const double x = 0.05 * j;
      value.push_back(1.0 / (1.0 + t + x * x) + 0.3 * x / (1.0 + (x - t) * (x - t)) +
                      (i == 41 ? 0.3 / (1.0 + 400.0 * (x - 1.3) * (x - 1.3)) : 0.0));
    }
  return value;
}

TEST_CASE("LeadingModes, SpanWhatHasTheirRank") {
  for (const std::size_t rank : {1u, 3u, 8u}) {
    const std::size_t n = 60;
    const std::size_t count = 37;
    const auto direction = tests::randomNumbers(rank * n, 1);
    const auto amount = tests::randomNumbers(rank * count, 2);
    std::vector<double> value(count * n, 0.0);
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t k = 0; k < rank; ++k)
        for (std::size_t j = 0; j < n; ++j) value[i * n + j] += amount[i * rank + k] * direction[k * n + j];
    const Snapshots snapshots{value, n};
    const Modes modes = leadingModes(snapshots, {}, 16);
    CAPTURE(rank);
    CHECK(modes.count() == rank);
    CHECK(largestOverlap(modes) <= kOrthonormal);
    CHECK(worstError(modes, snapshots, MaximumNorm{}) <= kModeRounding);
    if (rank > 1) CHECK(worstError(leadingModes(snapshots, {}, rank - 1), snapshots, MaximumNorm{}) > 1e-2);
  }
}

TEST_CASE("LeadingModes, KnownOnes") {
  // Along x 3 and along (y + z) / sqrt 2 in both directions; w weighs nothing.
  const std::vector<double> value = {-3.0, 0, 0, 0, 0, -1.0, -1.0, 0, 0, 2.0, 2.0, 0, 0, 0, 0, 50.0};
  const std::vector<double> weights = {1.0, 2.0, 1.0, 0.0};
  const Modes modes = leadingModes({value, 4}, weights, 2);
  REQUIRE(modes.count() == 2);
  CHECK(modes.energy[0] == Approx((2.0 * 2.0 + 8.0) / 4.0).margin(kModeRounding));
  CHECK(modes.energy[1] == Approx(9.0 / 4.0).margin(kModeRounding));
  const std::vector<double> expected = {0, std::sqrt(0.5), std::sqrt(0.5), 0, 1.0, 0, 0, 0};
  for (std::size_t i = 0; i < expected.size(); ++i) CHECK(modes.vector[i] == Approx(expected[i]).margin(kModeRounding));
}

TEST_CASE("LeadingModes, LeaveTheLeastMeanSquare") {
  // Of all spans of 3 vectors none leaves less: not one turned a little, by the energies' own account.
  const auto value = withOutlier();
  const Snapshots snapshots{value, 40};
  const Modes modes = leadingModes(snapshots, {}, 3);
  const Modes all = leadingModes(snapshots, {}, 40);
  CHECK(largestOverlap(all) <= kOrthonormal);
  double total = 0.0;
  for (const double x : value) total += x * x / 60.0;
  double energy = 0.0;
  for (const double e : all.energy) energy += e;
  CHECK(energy == Approx(total).epsilon(1e-12));
  const auto left = [&](const Modes& of) {
    std::vector<double> coefficients(of.count());
    std::vector<double> residual(40);
    double sum = 0.0;
    for (std::size_t i = 0; i < 60; ++i) {
      projectOntoModes(of, snapshots.row(i), coefficients, residual);
      for (const double x : residual) sum += x * x / 60.0;
    }
    return sum;
  };
  CHECK(left(modes) == Approx(total - modes.energy[0] - modes.energy[1] - modes.energy[2]).epsilon(1e-9));
  for (std::size_t k = 0; k < 3; ++k)
    for (const double angle : {-0.01, 0.01}) {
      Modes turned = modes;
      for (std::size_t j = 0; j < 40; ++j)
        turned.vector[k * 40 + j] = std::cos(angle) * modes.row(k)[j] + std::sin(angle) * all.row(3)[j];
      CHECK(left(turned) > left(modes));
    }
}

TEST_CASE("LeadingModes, FewBlackAndDarkSnapshots") {
  const std::vector<double> black(30, 0.0);
  CHECK(leadingModes({black, 10}, {}, 4).count() == 0);
  CHECK(refineModes({black, 10}, {}, 4, MaximumNorm{}, 5).error == 0.0);
  CHECK(leadingModes({{}, 10}, {}, 4).count() == 0);
  CHECK(refineModes({{}, 10}, {}, 4, MaximumNorm{}, 5).modes.count() == 0);
  auto dark = tests::randomNumbers(30, 3);  // the second is as dark as a moonless night beside the first
  for (std::size_t i = 10; i < 20; ++i) dark[i] *= 1e-90;
  const Modes modes = leadingModes({dark, 10}, {}, 3);
  CHECK(modes.count() == 3);
  CHECK(largestOverlap(modes) <= kOrthonormal);
}

TEST_CASE("MaximumNorm, MapAndScale") {
  const std::vector<double> residual = {1.0, -4.0, 2.0};
  CHECK(MaximumNorm{}(0, residual) == 4.0);
  const std::vector<double> scale = {1.0, 8.0};
  CHECK(MaximumNorm{{}, scale}(1, residual) == 0.5);
  const std::vector<double> map = {1.0, 1.0, 1.0, -2.0, 1.0, 0.0};
  CHECK(MaximumNorm{map, scale}(1, residual) == 6.0 / 8.0);
}

TEST_CASE("RefineModes, LowerTheErrorOfARareOutlier") {
  constexpr double kGain = 0.17;  // 0.151 is seen: a peak in one of 60 weighs little in the mean square
  const auto value = withOutlier();
  const Snapshots snapshots{value, 40};
  const RefinedModes refined = refineModes(snapshots, {}, 3, MaximumNorm{}, 40);
  CHECK(refined.start_error == worstError(leadingModes(snapshots, {}, 3), snapshots, MaximumNorm{}));
  CHECK(refined.error == worstError(refined.modes, snapshots, MaximumNorm{}));
  CAPTURE(refined.start_error, refined.error, refined.step);
  CHECK(refined.error < kGain * refined.start_error);
  CHECK(refined.step > 0);
  CHECK(largestOverlap(refined.modes) <= kOrthonormal);
}

TEST_CASE("RefineModes, NearDelta") {
  // One component of one snapshot of 200: as many modes as there are shapes take it in; one fewer halves it at best.
  std::vector<double> value;
  for (int i = 0; i < 200; ++i)
    for (int j = 0; j < 30; ++j) value.push_back((j < 15 ? 1.0 : 0.01 * i) + (i == 77 && j == 21 ? 5.0 : 0.0));
  const Snapshots snapshots{value, 30};
  CHECK(refineModes(snapshots, {}, 3, MaximumNorm{}, 40).error <= 10.0 * kModeRounding);
  const RefinedModes two = refineModes(snapshots, {}, 2, MaximumNorm{}, 40);
  CHECK(two.start_error > 4.0);
  CHECK(two.error < 2.2);
}

TEST_CASE("RefineModes, KeepTheStartWhenNothingIsBetter") {
  const std::vector<double> value = {1.0, 0.0, 0.0, 1.0};  // one mode for two alike: every error is the same already
  const RefinedModes refined = refineModes(
      {value, 2}, {}, 1, [](std::size_t, auto) { return 1.0; }, 10);
  CHECK(refined.step == 0);
  CHECK(refined.error == refined.start_error);
}

TEST_CASE("RefineModes, SameBits") {
  const auto value = withOutlier();
  const RefinedModes refined = refineModes({value, 40}, {}, 6, MaximumNorm{}, 20);
  CHECK(tests::checksum(refined.modes.vector) == 0x90c275bd85ef4203u);
}

}  // namespace
}  // namespace welkin::sh
