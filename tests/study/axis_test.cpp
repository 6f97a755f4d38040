// SPDX-License-Identifier: Apache-2.0
// Axes of charts: positions of numbers, and the commands that set range and ticks.
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <regex>

#include "sky/base/error.h"
#include "study/chart_axis.h"

namespace welkin::study {
namespace {

constexpr double kRounding = 1e-12;  // positions are in [0, 1]: a few logarithms and divisions

struct Tick {
  std::string label;
  double value;
};

std::vector<Tick> ticksOf(const AxisScale& scale) {
  const std::string commands = scale.commands("x");
  const std::regex pattern("'([^']+)' ([-+.e0-9]+) [01]");
  std::vector<Tick> ticks;
  for (std::sregex_iterator it(commands.begin(), commands.end(), pattern); it != std::sregex_iterator(); ++it)
    ticks.push_back({std::regex_replace(std::string((*it)[1]), std::regex("%%"), "%"), std::stod((*it)[2])});
  return ticks;
}

std::vector<std::string> labelsOf(const AxisScale& scale) {
  std::vector<std::string> labels;
  for (const Tick& tick : ticksOf(scale)) labels.push_back(tick.label);
  return labels;
}

TEST_CASE("AxisScale, DecadesAreEquallyWide") {
  const AxisScale scale({"error", Quantity::share, Scale::log}, {1e-4, 0.3});
  const double decade = scale.position(1e-3) - scale.position(1e-4);
  CHECK(scale.position(0.1) - scale.position(0.01) == Approx(decade).margin(kRounding));
  CHECK(scale.position(0.02) - scale.position(0.01) == Approx(decade * std::log10(2.0)).margin(kRounding));
  CHECK(scale.position(1e-4) > 0.0);
  CHECK(scale.position(0.3) < 1.0);
  CHECK(labelsOf(scale) == std::vector<std::string>{"0.01 %", "0.1 %", "1 %", "10 %"});
}

TEST_CASE("AxisScale, FewDecadesAreDividedFurther") {
  const AxisScale scale({"size", Quantity::bytes, Scale::log}, {700.0, 30000.0});
  CHECK(labelsOf(scale) == std::vector<std::string>{"1 KB", "2 KB", "5 KB", "10 KB", "20 KB"});
}

TEST_CASE("AxisScale, TicksLieAtTheirNumbers") {
  const AxisScale scale({"n", Quantity::number, Scale::log}, {0.031, 47.0});
  int compared = 0;
  for (const Tick& tick : ticksOf(scale)) {
    CHECK(std::stod(tick.label) == Approx(tick.value).epsilon(kRounding));
    ++compared;
  }
  CHECK(compared >= 3);
}

TEST_CASE("AxisScale, ZerosLieApartBelowTheDecades") {
  const AxisScale scale({"error", Quantity::share, Scale::log}, {0.0, 1e-3, 0.1});
  CHECK(scale.position(0.0) > 0.0);
  CHECK(scale.position(0.0) < scale.position(1e-3) - 0.02);
  const std::vector<Tick> ticks = ticksOf(scale);
  CHECK(ticks.back().label == "0 %");
  CHECK(ticks.back().value == Approx(scale.coordinate(0.0)).epsilon(kRounding));
  CHECK(ticks.back().value < ticks.front().value);
  CHECK(scale.coordinate(1e-3) == 1e-3);
}

TEST_CASE("AxisScale, CommandsNameTheRange") {
  CHECK(AxisScale({"x"}, {2.0, 3.0}).commands("y") == "set yrange [1.97:3.0299999999999998]\n");
  CHECK_THAT(AxisScale({"x", Quantity::number, Scale::log}, {1.0, 3.0}).commands("x"),
             Catch::Contains("set logscale x\n"));
}

TEST_CASE("Quoted, HasNoWayOut") {
  CHECK(quoted("it's `date` \"a\"\nplot") == "'it''s `date` \"a\" plot'");
}

TEST_CASE("AxisScale, LinearIsLinearAndInside") {
  const AxisScale scale({"x"}, {3.7, 11.9});
  CHECK(scale.position(7.8) == Approx((scale.position(3.7) + scale.position(11.9)) / 2.0).margin(kRounding));
  CHECK(scale.position(3.7) >= 0.0);
  CHECK(scale.position(11.9) <= 1.0);
  CHECK(scale.position(3.7) < scale.position(11.9));
}

TEST_CASE("AxisScale, RangeWidens") {
  const AxisScale scale({"x", Quantity::share, Scale::log, Range{1e-4, 1.0}}, {0.01});
  CHECK(labelsOf(scale) == std::vector<std::string>{"0.01 %", "0.1 %", "1 %", "10 %", "100 %"});
}

TEST_CASE("AxisScale, OneValueIsShown") {
  for (const Scale kind : {Scale::linear, Scale::log}) {
    for (const double value : {0.0, 5.0, 1e-30, 1e30}) {
      const AxisScale scale({"x", Quantity::number, kind}, {value});
      CAPTURE(value);
      CHECK(scale.position(value) >= 0.0);
      CHECK(scale.position(value) <= 1.0);
      if (kind == Scale::log) CHECK_FALSE(labelsOf(scale).empty());  // gnuplot marks linear axes
    }
  }
}

TEST_CASE("AxisScale, RefusesWhatHasNoPlace") {
  CHECK_THROWS_WITH(AxisScale({"error"}, {1.0, std::nan("")}), Catch::Contains("nan along 'error'"));
  CHECK_THROWS_AS(AxisScale({"x"}, {std::numeric_limits<double>::infinity()}), base::Error);
  CHECK_THROWS_AS(AxisScale({"x", Quantity::number, Scale::log}, {1.0, -1.0}), base::Error);
  CHECK_THROWS_AS(AxisScale({"x"}, {}), base::Error);
}

}  // namespace
}  // namespace welkin::study
