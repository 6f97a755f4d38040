// SPDX-License-Identifier: Apache-2.0
// Sharing of dynamic lights among virtual ones.
#include "probes/transfer/local_relight.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "probes/transfer/local_paths.h"
#include "tests/probes/closed_forms/closed_forms.h"

namespace welkin::tests {

using f64::Number3;
namespace {

const transfer::SeeEachOther kOpen = [](const Number3&, const Number3&) { return true; };

std::vector<Number3> lattice() {
  std::vector<Number3> light;
  for (int x = 0; x < 5; ++x)
    for (int z = 0; z < 5; ++z) light.push_back({4.0 * x, 1.0, 4.0 * z});
  return light;
}

Number3 sumOf(const std::vector<Number3>& colour) {
  Number3 sum(0.0);
  for (const Number3& c : colour) sum += c;
  return sum;
}

}  // namespace

TEST_CASE("LocalRelight, SharesSumToTheLight") {
  const auto light = lattice();
  const std::vector<transfer::DynamicLight> lamp = {
      {{5.3, 2.2, 6.1}, {1, 2, 3}}, {{90, 1, 3}, {0.5, 0, 7}}, {{8, 1, 8}, {2, 2, 2}}};
  const Number3 sum = sumOf(transfer::relightLocal(light, lamp, kOpen).colour);
  CHECK(sum.x == Approx(3.5));
  CHECK(sum.y == Approx(4.0));
  CHECK(sum.z == Approx(12.0));
  for (const double from : {0.0, 1e-300, 1e-9}) {  // at the place of a virtual light
    const auto colour =
        transfer::relightLocal(light, std::vector<transfer::DynamicLight>{{{8 + from, 1, 8}, {1, 2, 3}}}, kOpen).colour;
    CHECK(colour[12].y == Approx(2.0));
    CHECK(sumOf(colour).y == Approx(2.0));
  }
  const auto middle =
      transfer::relightLocal(light, std::vector<transfer::DynamicLight>{{{6, 1, 6}, {1, 2, 3}}}, kOpen).colour;
  for (const std::size_t l : {6U, 7U, 11U, 12U}) CHECK(middle[l].y == Approx(0.5));
  // Nearer lights take more, along the way from one to the next.
  const auto near =
      transfer::relightLocal(light, std::vector<transfer::DynamicLight>{{{5, 1, 4}, {1, 1, 1}}}, kOpen).colour;
  CHECK(near[6].x > 2.0 * near[11].x);
  CHECK(near[11].x > near[7].x);
  CHECK(near[24].x == 0.0);
}

TEST_CASE("LocalRelight, SharesChangeContinuously") {
  const auto light = lattice();
  constexpr double kStep_m = 1e-3;
  std::vector<Number3> before;
  double worst = 0.0;
  for (int i = 0; i < 12000; ++i) {
    const double x = 1.7 + kStep_m * i;
    const std::vector<transfer::DynamicLight> lamp = {{{x, 2.5, 5.1 + 0.3 * x}, {1, 1, 1}}};
    const auto colour = transfer::relightLocal(light, lamp, kOpen).colour;
    for (std::size_t l = 0; l < before.size(); ++l) worst = std::max(worst, std::abs(colour[l].x - before[l].x));
    before = colour;
  }
  CHECK(worst < 2.0 * kStep_m);
}

TEST_CASE("LocalRelight, ASpotSharesTheLightOfItsWholeCone") {
  const auto light = lattice();
  for (const auto& [inner, outer] : {std::pair(0.0, 0.5), {0.4, 0.5}, {0.2, 2.0}, {1.0, 3.1}, {0.0, det::kPi}}) {
    const std::vector<transfer::DynamicLight> spot = {{{5.3, 2.2, 6.1}, {1, 2, 3}, {0.6, 0, 0.8}, inner, outer}};
    constexpr int kSteps = 100000;
    double mean = 0.0;
    for (int i = 0; i < kSteps; ++i) mean += transfer::coneShareOf(spot[0], -1.0 + (2.0 * i + 1.0) / kSteps) / kSteps;
    const auto colour = transfer::relightLocal(light, spot, kOpen).colour;
    CHECK(sumOf(colour).y == Approx(2.0 * mean).epsilon(1e-4));  // of the steps at the edge of the inner cone
    CHECK(mean > 0.0);
  }
}

TEST_CASE("LocalRelight, ALampDoesNotLeakThroughAWall") {
  const geometry::Surfaces rooms = twoRooms(Number3(0.5), false);
  const geometry::Tracer tracer(rooms);
  const auto see = [&](const Number3& a, const Number3& b) { return transfer::seesEachOther(tracer, a, b); };
  const std::vector<Number3> light = {{-3, 1, 0}, {-1, 1, 0.5}, {0.2, 1, 0}, {2, 1, -1}};
  const std::vector<transfer::DynamicLight> lamp = {{{-0.1, 1, 0}, {1, 2, 3}}};
  const transfer::LocalColours colours = transfer::relightLocal(light, lamp, see);
  CHECK(colours.colour[2] == Number3(0.0));
  CHECK(colours.colour[3] == Number3(0.0));
  CHECK(sumOf(colours.colour).y == Approx(2.0));
  CHECK(colours.unseen.empty());
  const std::vector<transfer::DynamicLight> both = {lamp[0], {{0, 50, 0}, {1, 1, 1}}};  // outside both rooms
  CHECK(transfer::relightLocal(light, both, see).unseen == std::vector<std::size_t>{1});
  CHECK(transfer::relightLocal({}, lamp, see).unseen.size() == 1);
}

TEST_CASE("LocalRelight, IrradianceOfTheSameRadianceFromEverywhereIsPiTimesIt") {
  transfer::LocalTransfer uniform;
  uniform.light = 1;
  uniform.radiance[0] = Number3(0.1, 0.2, 0.3) * (4.0 * det::kPi * det::kShConstant);
  const std::vector<Number3> colour = {{9, 9, 9}, {1, 2, 4}};
  for (const Number3& e : transfer::relitLocal(std::vector{uniform}, colour)) {
    CHECK(e.x == Approx(det::kPi * 0.1));
    CHECK(e.y == Approx(det::kPi * 0.4));
    CHECK(e.z == Approx(det::kPi * 1.2));
  }
  // A beam from a direction D: irradiance 1/4 + 1/2 D . B.
  const Number3 from(0.48, 0.6, -0.64);
  transfer::LocalTransfer beam;
  const auto y = det::Number3(det::kShLinear * from.y, det::kShLinear * from.z, det::kShLinear * from.x);
  beam.radiance = {Number3(det::kShConstant), Number3(y.x), Number3(y.y), Number3(y.z)};
  const auto irradiance = transfer::relitLocal(std::vector{beam}, std::vector{Number3(1.0)});
  for (std::size_t b = 0; b < transfer::kDirections; ++b)
    CHECK(irradiance[b].x == Approx(0.25 + 0.5 * dot(from, transfer::transferBasis()[b])));
}

}  // namespace welkin::tests
