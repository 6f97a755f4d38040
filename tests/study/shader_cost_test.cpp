// SPDX-License-Identifier: Apache-2.0
// Costs of shaders: small ones counted by hand, loops against their unrolled form, and the order of Welkin's own.
#include "study/shader_cost.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include "sky/base/error.h"

namespace welkin::study {
namespace {

#include "spirv/kBranch.h"
#include "spirv/kDataIndex.h"
#include "spirv/kDataLoop.h"
#include "spirv/kFetchesOfOnePlace.h"
#include "spirv/kLeftOut.h"
#include "spirv/kLengths.h"
#include "spirv/kNestedBranches.h"
#include "spirv/kProduct.h"
#include "spirv/kWeightedByHand.h"
#include "spirv/kWeightedInLoops.h"

ShaderCost costOf(const std::string& name) {
  const std::vector<NamedShaderCost> all = measuredShaders();
  const auto found = std::ranges::find(all, name, &NamedShaderCost::name);
  REQUIRE(found != all.end());
  return found->cost;
}

TEST_CASE("CountShader, Product") {
  const ShaderCost cost = countShader(kProduct);
  CHECK(cost.instructions == 1);
  CHECK(cost.scalar_operations == 3);
  CHECK(cost.uniform_loads == 1);
  CHECK(cost.texture_fetches == 0);
}

TEST_CASE("CountShader, LoopsCostTheirUnrolledForm") {
  const ShaderCost loops = countShader(kWeightedInLoops);
  const ShaderCost by_hand = countShader(kWeightedByHand);
  CHECK(loops.uniform_loads == 6);
  CHECK(by_hand.uniform_loads == 6);
  // 6 weights, 6 products and 5 sums of 3; by hand, spirv-opt joins a product and a sum to one operation.
  CHECK(loops.scalar_operations == 6 + 6 * 3 + 5 * 3);
  CHECK(by_hand.scalar_operations <= loops.scalar_operations);
  CHECK(by_hand.scalar_operations >= 6 + 6 * 3);
}

TEST_CASE("CountShader, BothSidesOfABranch") {
  const ShaderCost cost = countShader(kBranch);
  CHECK(cost.instructions == 3);  // compare, sin, cos
  CHECK(cost.scalar_operations == 3);
}

TEST_CASE("CountShader, BranchesWithinBranches") {
  CHECK(countShader(kNestedBranches).scalar_operations == 4);  // two of compare and function
}

TEST_CASE("CountShader, WholeVectorsCountTheirComponents") {
  const ShaderCost cost = countShader(kLengths);
  CHECK(cost.instructions == 3);  // length, dot, product
  CHECK(cost.scalar_operations == 3 + 3 + 1);
}

TEST_CASE("CountShader, WhatIsNotNeededIsNotCounted") {
  CHECK(countShader(kLeftOut).scalar_operations == 1);  // one exp; x + 0 y is x
}

TEST_CASE("CountShader, EqualFetchesAreOne") {
  CHECK(countShader(kFetchesOfOnePlace).texture_fetches == 2);  // with and without a level
}

TEST_CASE("CountShader, AnIndexFromDataIsOneLoad") {
  const ShaderCost cost = countShader(kDataIndex);
  CHECK(cost.uniform_loads == 1);
  CHECK(cost.scalar_operations == 1);  // the conversion of the index
}

TEST_CASE("CountShader, RefusesWhatHasNoCount") {
  CHECK_THROWS_WITH(countShader(kDataLoop), Catch::Contains("bounds depend on data"));
  CHECK_THROWS_AS(countShader({}), base::Error);
  const std::span<const std::uint32_t> whole = kProduct;
  for (std::size_t words = 0; words < whole.size(); ++words)
    CHECK_THROWS_AS(countShader(whole.first(words)), base::Error);
  std::vector<std::uint32_t> other(whole.begin(), whole.end());
  other[0] ^= 1U;  // the magic number
  CHECK_THROWS_WITH(countShader(other), Catch::Contains("no module"));
}

TEST_CASE("MeasuredShaders, MoreBandsCostMore") {
  const ShaderCost two = costOf("irradiance 2 bands");
  const ShaderCost three = costOf("irradiance 3 bands");
  const ShaderCost four = costOf("irradiance 4 bands");
  const ShaderCost five = costOf("irradiance 5 bands");
  CHECK(two.instructions > 0);
  CHECK(three.instructions > two.instructions);
  CHECK(three.scalar_operations > two.scalar_operations);
  CHECK(four.scalar_operations == three.scalar_operations);  // the irradiance of the fourth band is 0
  CHECK(five.scalar_operations > four.scalar_operations);
  CHECK(two.uniform_loads == 4);
  CHECK(three.uniform_loads == 9);
  CHECK(five.uniform_loads == 18);  // 9 of three bands, 9 of the fifth
  for (const ShaderCost& cost : {two, three, four, five}) CHECK(cost.texture_fetches == 0);
}

TEST_CASE("MeasuredShaders, ModesComputeLessThanThreeBands") {
  const ShaderCost three = costOf("irradiance 3 bands");
  const ShaderCost four = costOf("irradiance 4 modes");
  const ShaderCost eight = costOf("irradiance 8 modes");
  CHECK(four.texture_fetches == 1);
  CHECK(eight.texture_fetches == 2);
  CHECK(eight.instructions <= three.instructions);
  CHECK(eight.scalar_operations <= three.scalar_operations);
  CHECK(four.scalar_operations < eight.scalar_operations);
  CHECK(eight.uniform_loads == four.uniform_loads + 3);
}

TEST_CASE("MeasuredShaders, TheDomeFetchesOrComputes") {
  const ShaderCost analytic = costOf("dome analytic");
  const ShaderCost cubemaps = costOf("dome cubemaps");
  CHECK(analytic.texture_fetches == 8);
  CHECK(cubemaps.texture_fetches == 2);
  CHECK(analytic.instructions > 10 * cubemaps.instructions);
  CHECK(cubemaps.uniform_loads == 1);
}

}  // namespace
}  // namespace welkin::study
