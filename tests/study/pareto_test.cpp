// SPDX-License-Identifier: Apache-2.0
// The Pareto front against its definition, trade by trade.
#include "study/pareto.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>

#include "sky/base/error.h"

namespace welkin::study {
namespace {

using Front = std::vector<std::size_t>;

// A trade is on the front when none is as good in both and better in one, and none before it equals it.
Front frontByDefinition(const std::vector<Tradeoff>& tradeoffs) {
  Front front;
  for (std::size_t i = 0; i < tradeoffs.size(); ++i) {
    bool beaten = false;
    for (std::size_t j = 0; j < tradeoffs.size(); ++j) {
      const bool as_good = tradeoffs[j].cost <= tradeoffs[i].cost && tradeoffs[j].error <= tradeoffs[i].error;
      const bool better = tradeoffs[j].cost < tradeoffs[i].cost || tradeoffs[j].error < tradeoffs[i].error;
      beaten = beaten || (as_good && (better || j < i));
    }
    if (!beaten) front.push_back(i);
  }
  std::ranges::sort(front, {}, [&](std::size_t i) { return tradeoffs[i].cost; });
  return front;
}

TEST_CASE("ParetoFront, NoneAndOne") {
  CHECK(paretoFront({}).empty());
  CHECK(paretoFront(std::vector<Tradeoff>{{3.0, 0.5}}) == Front{0});
}

TEST_CASE("ParetoFront, HyperbolaIsAllOnIt") {
  std::vector<Tradeoff> tradeoffs;
  for (int i = 1; i <= 20; ++i) tradeoffs.push_back({static_cast<double>(21 - i), 1.0 / (21 - i)});
  const Front front = paretoFront(tradeoffs);
  REQUIRE(front.size() == 20);
  CHECK(front.front() == 19);  // the cheapest first
  CHECK(front.back() == 0);
}

TEST_CASE("ParetoFront, CostAndErrorAreNotInterchangeable") {
  // 1 is beaten by 0, for it costs more and errs as much; 3 by 2, for it errs more and costs as much.
  const std::vector<Tradeoff> tradeoffs = {{1.0, 9.0}, {2.0, 9.0}, {5.0, 1.0}, {5.0, 2.0}, {100.0, 0.5}};
  CHECK(paretoFront(tradeoffs) == Front{0, 2, 4});
}

TEST_CASE("ParetoFront, OfEqualTradesTheFirst") {
  const std::vector<Tradeoff> tradeoffs = {{2.0, 1.0}, {1.0, 3.0}, {2.0, 1.0}, {1.0, 3.0}, {2.0, 1.0}};
  CHECK(paretoFront(tradeoffs) == Front{1, 0});
}

TEST_CASE("ParetoFront, IsItsDefinition") {
  std::mt19937 random(7);
  for (int run = 0; run < 50; ++run) {
    std::vector<Tradeoff> tradeoffs;
    for (int i = 0; i < 60; ++i) {  // of few values, so that there are ties of every kind
      tradeoffs.push_back({static_cast<double>(random() % 12), static_cast<double>(random() % 9)});
    }
    CHECK(paretoFront(tradeoffs) == frontByDefinition(tradeoffs));
  }
}

TEST_CASE("ParetoFront, InfinitiesHaveAnOrderNaNHasNot") {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const std::vector<Tradeoff> tradeoffs = {{1.0, kInfinity}, {kInfinity, 0.0}};
  CHECK(paretoFront(tradeoffs) == Front{0, 1});
  CHECK_THROWS_AS(paretoFront(std::vector<Tradeoff>{{1.0, 1.0}, {std::nan(""), 1.0}}), base::Error);
  CHECK_THROWS_AS(paretoFront(std::vector<Tradeoff>{{1.0, std::nan("")}}), base::Error);
}

}  // namespace
}  // namespace welkin::study
