// SPDX-License-Identifier: Apache-2.0
#include "probes/placement/thinning.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>
#include <tuple>

#include "probes/geometry/random.h"
#include "probes/placement/nearby.h"

namespace welkin::tests {

using f64::Number3;
namespace {

/// For each walkable point, the probes that it sees within reach, nearest first.
using Coverage = std::vector<std::vector<placement::SeenProbe>>;

Coverage randomCoverage(std::size_t points, std::size_t probes, std::uint64_t seed) {
  geometry::Random random(seed);
  Coverage result(points);
  for (auto& seen : result) {
    for (std::size_t i = 0; i < probes; ++i)
      if (random.unit() < 0.3) seen.push_back({i, 8.0 * random.unit()});
    std::sort(seen.begin(), seen.end(),
              [](const placement::SeenProbe& a, const placement::SeenProbe& b) { return a.distance_m < b.distance_m; });
  }
  return result;
}

std::vector<std::size_t> thin(const Coverage& coverage, const std::vector<bool>& by_hand, std::size_t most) {
  const placement::Look look = [&](std::size_t point, const std::vector<bool>& gone) {
    std::vector<placement::SeenProbe> seen;
    for (const placement::SeenProbe& s : coverage[point])
      if (!gone[s.probe] && seen.size() < placement::kNearestSeen) seen.push_back(s);
    return seen;
  };
  return placement::thin(coverage.size(), look, by_hand, most);
}

/// Number of points without a probe, and the sum of the others' distances, without the probes in `gone`.
std::pair<std::size_t, double> costOf(const Coverage& coverage, const std::vector<std::size_t>& gone) {
  std::pair<std::size_t, double> cost{0, 0.0};
  for (const auto& seen : coverage) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const placement::SeenProbe& s : seen)
      if (std::find(gone.begin(), gone.end(), s.probe) == gone.end()) nearest = std::min(nearest, s.distance_m);
    if (nearest < 1e9)
      cost.second += nearest;
    else
      ++cost.first;
  }
  return cost;
}

}  // namespace

TEST_CASE("Thinning, EachStepIsTheLeastLossByBruteForce") {
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U}) {
    const std::size_t probes = seed < 4 ? 12 : 60;  // of 60, a point sees about 18, so it looks again
    const Coverage coverage = randomCoverage(40, probes, seed);
    const auto gone = thin(coverage, std::vector<bool>(probes, false), 5);
    REQUIRE(gone.size() == probes - 5);
    std::vector<std::size_t> before;
    for (const std::size_t next : gone) {
      // The loss counts a point that loses its last probe, but not the distance of that point.
      const auto loss = [&](std::size_t probe) {
        std::vector<std::size_t> after = before;
        after.push_back(probe);
        std::size_t lost = costOf(coverage, after).first - costOf(coverage, before).first;
        double growth = 0.0;
        for (const auto& seen : coverage) {
          const Coverage one{seen};
          const auto was = costOf(one, before);
          const auto is = costOf(one, after);
          if (was.first == is.first) growth += is.second - was.second;
        }
        return std::pair{lost, growth};
      };
      const auto least = loss(next);
      for (std::size_t i = 0; i < probes; ++i) {
        if (std::find(before.begin(), before.end(), i) != before.end()) continue;
        constexpr double kSums_m = 1e-9;  // rounding of two orders of summing
        CHECK(std::tuple(least.first, least.second) <= std::tuple(loss(i).first, loss(i).second + kSums_m));
      }
      before.push_back(next);
    }
  }
}

TEST_CASE("Nearby, VisitsFromTheNearestOnByBruteForce") {
  geometry::Random random(7);
  const auto somewhere = [&] {
    return Number3(-64.0 + 64.0 * random.unit(), 20.0 * random.unit(), 128.0 + 64.0 * random.unit());
  };
  placement::Nearby nearby({-1, 2});
  std::vector<Number3> position;
  for (std::size_t i = 0; i < 3000; ++i) {
    position.push_back(i % 50 == 1 ? Number3(position.back()) : somewhere());  // some twice
    nearby.add(i, position.back());
  }
  for (int n = 0; n < 200; ++n) {
    const Number3 from = n == 0 ? Number3(-64.0, 3.0, 192.0) : somewhere();
    const double far_m = n % 4 == 0 ? 0.7 : 11.0 * random.unit();
    const auto counts = [](std::size_t i) { return i % 3 != 0; };
    std::vector<std::pair<double, std::size_t>> expected;
    for (std::size_t i = 0; i < position.size(); ++i)
      if (counts(i) && placement::distanceOf(from, position[i]) < far_m)
        expected.emplace_back(placement::distanceOf(from, position[i]), i);
    std::sort(expected.begin(), expected.end());
    const std::size_t most = n % 2 == 0 ? expected.size() + 1 : 3;
    expected.resize(std::min(expected.size(), most));
    std::vector<std::pair<double, std::size_t>> visited;
    nearby.visit(from, far_m, counts, [&](std::size_t i, double distance_m) {
      visited.emplace_back(distance_m, i);
      return visited.size() < most;
    });
    CHECK(visited == expected);
  }
}

TEST_CASE("Thinning, ThoseByHandGoLast") {
  const Coverage coverage = randomCoverage(30, 6, 9);
  const auto gone = thin(coverage, {true, false, false, true, false, false}, 1);
  REQUIRE(gone.size() == 5);
  for (std::size_t i = 0; i < 4; ++i) CHECK((gone[i] != 0 && gone[i] != 3));
  CHECK(thin(coverage, std::vector<bool>(6, false), 6).empty());
}

TEST_CASE("Thinning, KeepsTheOnlyProbeOfAPoint") {
  // Probe 0 alone sees point 0; 1 and 2 see the others, from nearly the same distance.
  const Coverage coverage{{{0, 7.0}}, {{1, 1.0}, {2, 1.5}}, {{2, 1.0}, {1, 1.25}}};
  CHECK(thin(coverage, {false, false, false}, 2) == std::vector<std::size_t>{2});
  CHECK(thin(coverage, {false, false, false}, 1) == std::vector<std::size_t>{2, 0});
}

}  // namespace welkin::tests
